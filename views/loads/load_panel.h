// What is nearest to breaking: the ten places with the most load for their strength, of the instant
// that is shown and of the run so far (laws/load_margin.h).
//
// Of the run, what has broken stands before what holds, in the order in which it broke.
//
// A click selects a place and asks for it to come to the middle of the view. What carries a load
// and has no strength is named below the lists, and so is what has one but never tears, with a link
// that lets it tear; where nothing has a strength, the panel says how to give one. It follows the
// player a few times a second, and only while it is seen. The worst of a run stays after a reset,
// until the next run has left the design, as that is when one wants to read it. Belongs to the
// window's thread.
#pragma once

#include "scene/scene.h"
#include "simulation/frame.h"

#include <QTimer>
#include <QWidget>

#include <vector>

class QLabel;
class QPushButton;
class QStackedLayout;

namespace ripstop {

class Document;
class LoadList;
class Player;
class Selection;

class LoadPanel final : public QWidget
{
    Q_OBJECT

public:
    LoadPanel(Document& document, Selection& selection, Player& player, QWidget* parent = nullptr);

    const LoadList& now() const { return *m_now; }
    const LoadList& ofRun() const { return *m_ofRun; }
    QString said() const; // instead of the lists; empty where these are shown

    // Shows what it has put off, so that a picture of the window shows one moment.
    void catchUp();

signals:
    void chosen(quint32 element); // that the view is to show in its middle
    // What has broken in that run, at a time (s) and a place (m), which are to be shown.
    void breakChosen(quint64 run, double time, const ripstop::Vec3& place);

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* emptyPage();
    QWidget* listPage();
    void choose(const LoadedPlace& place);
    void noteWorst();
    bool isBeforeRun() const;
    WorstPlaces worstOfRun() const;
    std::vector<LoadedPlace> brokenOfRun(const WorstPlaces& worst) const;
    std::vector<LoadedPlace> placesOfRun(const WorstPlaces& worst) const;
    bool isOfRun() const;
    void refresh();
    void tellWhyNone(const Frame* frame);
    void showUnjudged();
    void selectUnjudged();
    void showUntearable();
    void showOpening();
    void showMore(bool isUnknown);
    void showLaunch(const Frame& frame, const WorstPlaces& ofRun);
    void letTear();
    void takeSafetyFactor();
    QString namesOf(const std::vector<Id>& materials) const;

    Document& m_document;
    Selection& m_selection;
    Player& m_player;
    QTimer m_delay;
    QStackedLayout* m_pages;
    QLabel* m_empty;
    QPushButton* m_materials;
    LoadList* m_now;
    LoadList* m_ofRun;
    QLabel* m_unjudged;        // materials without a strength, below the lists
    QLabel* m_untearable;      // materials that hold beyond theirs, likewise
    QLabel* m_opening;         // that canopies open too softly
    QLabel* m_more;            // that more has broken than is listed, or why nothing is listed
    QLabel* m_launch;          // that the worst of the run was the launch
    bool m_isEdited = true;    // since those were found
    WorstPlaces m_worst;       // of the newest run that left the design, also when it was reset
    FirstBreaks m_firstBreaks; // of that run
    std::size_t m_breaks = 0;  // in that run, all of them
    std::uint64_t m_run = 0;   // that run
};

} // namespace ripstop
