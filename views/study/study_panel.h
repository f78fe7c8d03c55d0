// The study panel: a design flown with many values in the background, and the map of what came of
// it.
//
// "Study this" on a property makes a study of the open design, or adds a variable to the one that
// is shown. Fly writes the file of the study, beside the design, and flies what is missing on all
// cores but one; it can be stopped at any moment and goes on where it was. A flight of the map can
// be watched, which computes it again with all of its frames and compares the hash, and its values
// can be given to the design. The form (study_form.h) edits, the view (study_view.h) shows, and the
// runner (study_runner.h) works. Only the window's thread uses it.
#pragma once

#include "study/study_runner.h"

#include "scene/slider.h"

#include <QElapsedTimer>
#include <QWidget>

#include <memory>

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedLayout;

namespace ripstop {

class Document;
class Recordings;
class StudyForm;
class StudyView;

class StudyPanel final : public QWidget
{
    Q_OBJECT

public:
    //   saveDesign  sees to it that the design is in a file of its own as it is; false when the
    //               user does not want that
    StudyPanel(Document& document, Recordings& recordings, std::function<bool()> saveDesign,
               QWidget* parent = nullptr);

    // Goes on with what another panel shows and flies, which is empty then and about to go.
    void takeOver(StudyPanel& before);

    // Varies this property, in the study that is shown or in a new one of the open design.
    void study(const Property& property, const std::vector<Id>& ids,
               const std::optional<SliderRange>& range);
    static bool isStudy(const QString& file); // by its name
    void browse();                            // asks for the file of a study
    void open(const QString& file);
    void run(); // saves, and flies what is missing
    void stop();

    const StudyRunner& runner() const { return *m_runner; }
    StudyView& view() { return *m_view; }
    StudyForm& form() { return *m_form; }
    QString file() const { return m_file; } // empty while it was never saved
    QString state() const;                  // what is said below the form

signals:
    void opened();                          // a study, which is shown now
    void designWanted(const QString& file); // of a study, while no design is open
    void said(const QString& words);        // for the status bar

protected:
    void showEvent(QShowEvent* event) override;

private:
    void hearRunner();
    void showForm(const Study& study);
    QWidget* emptyPage();
    QWidget* formSide();
    void startNew();
    bool saveStudy();
    QString freeName() const;
    bool isOfTheDesign() const; // the study that is shown
    void showOpened();
    void showState();
    void showProgress(double flown, double all);
    void refreshSometimes(); // there are more flights
    void showFailure(const Message& why);
    void watched(std::size_t point);
    void compare(const std::vector<std::size_t>& points);
    void showCompared(const std::vector<std::size_t>& points);
    void showGhosts();
    void applyToDesign(std::size_t point);
    void saveTable();
    QString unitOf(const StudyVariable& variable) const;
    QStringList probes() const;

    Document& m_document;
    Recordings& m_recordings;
    std::function<bool()> m_saveDesign;
    QStackedLayout* m_pages;
    QLabel* m_title;
    StudyForm* m_form;
    StudyView* m_view;
    QPushButton* m_run;
    QProgressBar* m_progress;
    QLabel* m_state;
    QString m_file;
    bool m_isEdited = false; // since it was written
    bool m_fliesOnceOpen = false;
    QElapsedTimer m_sinceRefresh;          // not valid: the next one is due
    qint64 m_refreshTime = 0;              // ms, that the last one took
    std::unique_ptr<StudyRunner> m_runner; // last: it ends before what hears of it
};

} // namespace ripstop
