// Takes the pictures that the command line asked for, and ends the program.
//
// It flies the scene as fast as it can to each of the times, or looks back at a recording there,
// waits until docks, view and dialogs have their sizes, and saves the window, the view alone, or
// the window with the dialog of an action over it. main() makes it when --screenshot is given; it
// lives on the thread of the window and works from a timer. It ends the program with exit code 0
// when all are saved, 1 when a file could not be written, and 3 when the run stopped.
#pragma once

#include "editor/options.h"
#include "scene/id.h"

#include <QObject>
#include <QPixmap>
#include <QTimer>

#include <vector>

namespace ripstop {

class MainWindow;
class Player;

class Screenshot final : public QObject
{
    Q_OBJECT

public:
    // `fitted` is what fills the pictures; when it is empty, the whole scene does.
    Screenshot(const Options& options, std::vector<Id> fitted, MainWindow& window, Player& player);

private:
    void goOn();
    bool lookBack(); // false until it does, at the time of the next picture
    void save();
    QPixmap grabWindow(); // as it is at this moment
    bool writeView(const QString& file);
    void saveImport();
    void saveWithDialog();
    void finish(int exitCode);

    Options m_options;
    std::vector<Id> m_fitted;
    MainWindow& m_window;
    Player& m_player;
    QTimer m_timer;
    bool m_isRecording;
    bool m_sought = false;
    int m_slice = 0;   // of the flight, counted from 0; the plots get a sample at the end of each
    int m_picture = 0; // number of the next to be taken
    int m_settling = 0;
    int m_waited = 0;
};

} // namespace ripstop
