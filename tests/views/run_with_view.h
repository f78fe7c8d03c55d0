#pragma once

#include <QApplication>
#include <QSurfaceFormat>
#include <QtTest>

namespace ripstop {

// Runs a test whose windows have a 3D view.
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
