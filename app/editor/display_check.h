// Whether there is a display that the window can be drawn on, and a sentence where there is none.
//
// Qt ends a program without a display by SIGABRT, and VTK one without OpenGL by SIGSEGV. Both come
// before anybody sees a window, so that the sentence goes to the terminal, and into a dialog where
// the desktop can show one. The exit code is `noDisplay` (docs/command-line.md).
#pragma once

#include <QString>

namespace ripstop {

constexpr int noDisplay = 8; // exit code

// As long as it lives, what Qt says is held back; a fatal message ends the program with a sentence
// instead of a core dump. It stands around the making of the application.
class DisplayCheck
{
public:
    DisplayCheck();
    ~DisplayCheck();
    DisplayCheck(const DisplayCheck&) = delete;
    DisplayCheck& operator=(const DisplayCheck&) = delete;
};

// Empty where widgets can draw with OpenGL as the default surface format asks for. Needs the
// application.
QString lackOfOpenGl();

// In a dialog, on platforms where somebody can see and answer it.
void showLack(const QString& lack);

} // namespace ripstop
