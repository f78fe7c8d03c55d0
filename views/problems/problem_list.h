// What keeps the scene from running, what will run but hardly as meant, that a run is not as true
// as wanted, and why the simulation stopped.
//
// A click selects the culprit. Beside it stands how near the design is to what its solver can
// follow; a warning that is told there, with its repair, is not told twice. The check runs on the
// thread of the follower, shortly after the last edit, and its findings arrive as signals in the
// thread of the window.
#pragma once

#include "check/check.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QLabel;
class QListWidget;
class QStackedLayout;

namespace ripstop {

class Document;
struct Frame;
class Player;
class Selection;
class StabilityList;

class ProblemList final : public QWidget
{
    Q_OBJECT

public:
    ProblemList(Document& document, Selection& selection, Player& player,
                QWidget* parent = nullptr);

    int errorCount() const { return m_errors; }
    int warningCount() const { return m_warnings; }

signals:
    void countChanged(int errors, int warnings);

private:
    void check();
    void noteStop(const QString& why, quint32 culprit);
    void noteFrame(const Frame& frame);
    std::vector<Finding> told() const; // what is told here, as the list beside does not tell it
    void rebuild();

    Selection& m_selection;
    Player& m_player;
    std::vector<Finding> m_problems;
    std::vector<Finding> m_stops;  // why the run stopped, at most one
    std::vector<Finding> m_untrue; // that the run is not as true as wanted, at most one
    QElapsedTimer m_sinceUntrue;   // its figures change with each frame
    QTimer m_delay;
    QWidget* m_side; // with the pages, gone where only the list beside has something to tell
    QStackedLayout* m_pages;
    QLabel* m_empty;
    QListWidget* m_list;
    StabilityList* m_stability;
    int m_errors = 0;
    int m_warnings = 0;
};

} // namespace ripstop
