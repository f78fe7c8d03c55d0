#pragma once

#include "import/import_work.h"

#include <QDialog>
#include <QTimer>

class QDialogButtonBox;
class QLabel;
class QListWidget;
class QProgressBar;

namespace ripstop {

class ImportForm;
class MeshPreview;

// A mesh before it becomes fabric: how it looks and how large it is, what is wrong with it and
// what was repaired, and what will be made of it. Everything is worked out on another thread
// shortly after each change.
class ImportDialog final : public QDialog
{
    Q_OBJECT

public:
    // What is imported is for this scene, which must not change while the dialog is open.
    ImportDialog(const Scene& scene, const QString& file, QWidget* parent = nullptr);

    // Where a mesh may be; empty when the user thinks better of it.
    static QString askFile(QWidget* parent, const QString& folder);
    static bool isMesh(const QString& file); // by its ending

    // What to add; the dialog can only be accepted while there is something.
    const MeshImport& result() const { return m_outcome->made; }
    QString file() const { return m_file; }
    bool isReady() const { return m_outcome && m_outcome->refusal.isEmpty(); }
    bool isSettled() const { return m_outcome && !m_delay.isActive(); }

signals:
    void settled(); // what is shown is of what is chosen

private:
    void layOut();
    QWidget* filePlace();
    void chooseFile();
    void openFile(const QString& file);
    void workSoon();
    void post();
    void watch(); // shows progress
    void take(std::shared_ptr<const ImportOutcome> outcome);
    void showReport();
    void setReady(bool isReady);

    const Scene& m_scene;
    QString m_file;
    QLabel* m_fileName;
    MeshPreview* m_preview;
    ImportForm* m_form;
    QLabel* m_size;
    QLabel* m_counts;
    QListWidget* m_report;
    QProgressBar* m_progress;
    QDialogButtonBox* m_buttons;
    std::shared_ptr<const ImportOutcome> m_outcome; // null while work goes on
    std::shared_ptr<const PreparedMesh> m_shown;    // stays until there is another one
    QTimer m_delay;
    QTimer m_watch;
    ImportWork m_work;
};

} // namespace ripstop
