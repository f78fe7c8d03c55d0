// Runs the scene until all hangs still (run/settle.h): slower than a speed in m/s everywhere,
// within a simulated time in s, with kinetic damping if wanted.
//
// The player runs on its own thread, so the window goes on meanwhile; stopping or closing the
// dialog pauses the run where it is. It follows the player by signals, on the thread of the
// window, and deletes itself when it is closed. Dialogs::showSettle() opens it.
#pragma once

#include "simulation/frame.h"

#include <QDialog>

#include <functional>

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace ripstop {

class ParameterField;
class Player;

class SettleDialog final : public QDialog
{
    Q_OBJECT

public:
    SettleDialog(Player& player, std::function<void()> adopt, QWidget* parent);

    void start();
    void stop();

    void done(int result) override;

private:
    void layOut();
    void refresh(); // brings the buttons and fields up to date
    void follow(const Frame& frame);
    void end(const Settling& end);
    void say(const QString& words);

    Player& m_player;
    std::function<void()> m_adopt;
    ParameterField* m_speed;
    ParameterField* m_within;
    QCheckBox* m_damped;
    QProgressBar* m_bar;
    QLabel* m_state;
    QPushButton* m_start;
    QPushButton* m_pose;
    bool m_runs = false;    // by this dialog
    double m_fastest = 0.0; // m/s, so far
    double m_lately = 0.0;  // m/s, falls slowly, so that the bar does not jump about
};

} // namespace ripstop
