// Chooses a builder and its parameters, for a new design, for a part of the open one, or to build
// a part again.
//
// The design is built anew, on a thread of its own (builder_work.h), shortly after each change, so
// that its shape, its figures and what is wrong with it are always on screen: in the open design
// when it goes there, and in a view of the dialog's own when it is a new one.
//
// While the view shows a run it shows no preview: trying out is an edit, and the run would go on
// with it. The run, its moment and the camera stay as they are until something is inserted, or
// built again.
//
// Accepted, a change of the open design is one step of the history; dismissed, it is none. The
// dialog is modal because the preview stands in the history until then: another edit would come to
// lie on it. It lives on the thread of the window; arrivals.h and the rows of the Insert menu open
// it.
#pragma once

#include "dialogs/builder_work.h"

#include <QDialog>
#include <QTimer>

#include <map>
#include <memory>
#include <optional>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QLabel;
class QPlainTextEdit;
class QPushButton;
class QScrollArea;

namespace ripstop {

class Complaint;
class Document;
class ParameterForm;
class PlaceForm;
class Selection;

// The open design that a builder's part goes into, or stands in.
struct OpenDesign
{
    Document& document;
    Selection& selection;
    Vec3 focus = Vec3::Zero(); // m, what the view turns about
    Id part = noId;            // to be built again with other parameters; noId inserts a new one
    bool showsRun = false;     // which a preview in the view would change
};

class BuilderDialog final : public QDialog
{
    Q_OBJECT

public:
    explicit BuilderDialog(const QString& builder, QWidget* parent = nullptr); // a new design
    BuilderDialog(const QString& builder, const OpenDesign& open, QWidget* parent = nullptr);
    ~BuilderDialog() override;

    // What was built for a new design; the dialog can only be accepted while there is something.
    const Scene& scene() const { return m_outcome->scene; }

    void accept() override;
    void reject() override;

signals:
    void agreed(); // what was built goes into the open design next

    // What is inserted stands in the view for the first time since its builder or its place was
    // chosen, so the camera may turn to it.
    void shown(const std::vector<ripstop::Id>& bodies);

private:
    struct Preview; // of a new design

    BuilderDialog(const QString& builder, std::optional<OpenDesign> open, QWidget* parent);
    void layOut();
    void showParameters(); // of the chosen builder
    void keepTyped();
    void fillForm(); // with what was typed before
    bool clothIsIdeal() const;
    void followCloth(); // with what is offered beside it
    void showValuesOf(const Part& part);
    void restoreDefaults();
    void buildSoon();
    void post();
    void collect();
    void preview();
    void takeBack();
    void refuse(const QString& why);
    std::optional<BuildJob> job(); // nothing, and a refusal, where the form cannot be read
    const Builder& chosen() const;

    std::optional<OpenDesign> m_open;
    std::vector<Id> m_selected; // when the dialog was opened
    QComboBox* m_builders;
    QLabel* m_help;
    QScrollArea* m_scroll;
    ParameterForm* m_form = nullptr;
    QPlainTextEdit* m_table = nullptr; // of a builder that takes one
    struct Typed
    {
        Parameters values;
        Parameters said; // of those, by the person
        QString table;
    };
    std::map<const Builder*, Typed> m_typed; // until the dialog closes
    const Builder* m_shown = nullptr;        // by the form
    bool m_clothIsIdeal = false;             // in the form, at the last look
    QCheckBox* m_show;
    QLabel* m_figures;
    Complaint* m_lost; // what would go of the work of hands
    QDialogButtonBox* m_buttons;
    QPushButton* m_ideal; // sets what the papers have

    // of a change of the open design
    PlaceForm* m_place = nullptr;
    std::shared_ptr<const InsertGround> m_ground; // of an insertion
    std::shared_ptr<const Scene> m_scene;         // as it was, where a part is built again
    bool m_isNew = true; // no design of this builder was shown at this place yet

    std::unique_ptr<Preview> m_preview;
    std::shared_ptr<const BuildOutcome> m_outcome; // of what the form says, or null
    int m_number = 0;                              // of the newest job
    QTimer m_delay;
    BuildWork m_worker;
};

} // namespace ripstop
