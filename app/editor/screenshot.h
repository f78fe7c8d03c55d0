#pragma once

#include "editor/options.h"
#include "scene/id.h"

#include <QObject>
#include <QTimer>

#include <vector>

namespace ripstop {

class MainWindow;
class Player;

// Takes the pictures that the command line asked for and quits: flies the scene as fast as it can
// to each of the times, waits until the view has drawn it, and saves the window.
class Screenshot final : public QObject
{
    Q_OBJECT

public:
    // `fitted` is what fills the pictures; nothing is the whole scene.
    Screenshot(const Options& options, std::vector<Id> fitted, MainWindow& window, Player& player);

private:
    void goOn();
    void save();
    void saveImport();
    void saveWithDialog();
    void finish(int exitCode);

    Options m_options;
    std::vector<Id> m_fitted;
    MainWindow& m_window;
    Player& m_player;
    QTimer m_timer;
    int m_slice = 0;   // of the flight; the plots get a sample at the end of each
    int m_picture = 0; // the next to be taken
    int m_settling = 0;
    int m_waited = 0;
};

} // namespace ripstop
