#pragma once

#include "builders/builder.h"
#include "document/worker.h"

#include <QDialog>
#include <QTimer>

#include <vector>

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QScrollArea;

namespace ripstop {

class ParameterField;

// Chooses a builder and its parameters. The design is built anew, on a thread of its own, shortly
// after each change, so that its size and what is wrong with it are always on screen.
class BuilderDialog final : public QDialog
{
    Q_OBJECT

public:
    explicit BuilderDialog(const QString& builder, QWidget* parent = nullptr);

    // What was built; the dialog can only be accepted while there is something.
    const Scene& scene() const { return m_scene; }
    QString builder() const; // its name in the table of builders

private:
    struct Job
    {
        const Builder* builder;
        Parameters parameters;
        int number;
    };
    struct Outcome
    {
        Result<Scene> scene;
        int number;
    };

    void layOut();
    void showParameters(); // of the chosen builder
    void restoreDefaults();
    void buildSoon();
    void post();
    void collect();
    void showResult();
    const Builder& chosen() const;

    QComboBox* m_builders;
    QLabel* m_help;
    QScrollArea* m_form;
    std::vector<ParameterField*> m_fields; // of the chosen builder
    QLabel* m_counts;
    QDialogButtonBox* m_buttons;

    Scene m_scene;
    bool m_built = false; // m_scene is what the form says
    QString m_refusal;    // why nothing was built
    int m_number = 0;     // of the newest job
    QTimer m_delay;
    Worker<Job, Outcome> m_worker;
};

} // namespace ripstop
