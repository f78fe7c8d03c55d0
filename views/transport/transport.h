// The bar that runs the simulation, and plays back what was recorded: back to the design, one step,
// play and pause, speed; and where the run stands: the mode, the simulated time, s, how it keeps up
// with the clock, the substeps, and how true it is. There is no other one: while one looks back,
// the button plays the recording, at the same speed. It keeps no state: buttons call Player and
// Recordings, and everything shown is read from them. Only the window's thread uses it.
#pragma once

#include <QWidget>

#include <vector>

class QComboBox;
class QLabel;
class QToolButton;

namespace ripstop {

class Document;
class Player;
class Recordings;

class Transport final : public QWidget
{
    Q_OBJECT

public:
    Transport(Document& document, Player& player, Recordings& recordings,
              QWidget* parent = nullptr);

    // With all that it says, and with the buttons alone.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QToolButton* button(const char* name, const QString& text, const QString& toolTip);
    void fillSpeeds();
    void toggle(); // what is seen: the run, or the recording
    bool isPast() const;
    void refresh();      // what the player is asked to do
    void refreshRun();   // where the run stands
    void refreshRatio(); // simulated seconds per second of the clock
    void refreshSubsteps();
    void refreshAccuracy(); // how true it is
    void refreshBadge();

    Document& m_document;
    Player& m_player;
    Recordings& m_recordings;
    QToolButton* m_reset;
    QToolButton* m_step;
    QToolButton* m_play;
    QComboBox* m_speed;
    QLabel* m_badge;
    QLabel* m_time;
    QLabel* m_ratio;
    QLabel* m_substeps;
    QLabel* m_accuracy;
    std::vector<QWidget*> m_spared; // what goes first where there is no room comes last
};

} // namespace ripstop
