// What runs tests of windows (registered_test.h). They need a display; Xvfb will do.
#pragma once

#include "registered_test.h"

#include <QApplication>
#include <QSurfaceFormat>

namespace ripstop {

// Widgets without a 3D view. Fonts are as on a screen of 96 dots per inch, whatever the screen
// says.
template <typename Test>
int runWithWidgets(int argc, char** argv)
{
    const QApplication application(argc, argv);
    QApplication::setAttribute(Qt::AA_Use96Dpi);
    return runPlain<Test>(argc, argv);
}

// Windows with a 3D view: the surface format that VTK needs is set before the application exists,
// as the program itself does, and the application has a name of its own, so that tests do not touch
// the settings of the user.
template <typename Test>
int runWithView(int argc, char** argv)
{
    QSurfaceFormat format;
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
    const QApplication application(argc, argv);
    QApplication::setApplicationName("RipstopTest");
    return runPlain<Test>(argc, argv);
}

} // namespace ripstop
