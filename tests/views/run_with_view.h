// The main() of tests whose windows have a 3D view: it sets the surface format that VTK needs
// before the application exists, as the program itself does, and gives the application a name of
// its own, so that tests do not touch the settings of the user. Needs a display (Xvfb will do).
#pragma once

#include <QApplication>
#include <QSurfaceFormat>
#include <QtTest>

namespace ripstop {

template <typename Test>
int runWithView(int argc, char** argv)
{
    QSurfaceFormat format;
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format); // before the application exists
    QApplication application(argc, argv);
    QApplication::setApplicationName("RipstopTest");
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace ripstop
