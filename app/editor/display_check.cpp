// lackOfOpenGl() lets a widget of one pixel draw: the context alone would not do, because there are
// platforms that make one and cannot show it in a widget. Qt only tells so by a warning of the
// widget's constructor.
#include "editor/display_check.h"

#include "document/words.h"

#include <QGuiApplication>
#include <QMessageBox>
#include <QOpenGLContext>
#include <QOpenGLWidget>
#include <QSurfaceFormat>

#include <cstdio>
#include <cstdlib>

namespace ripstop {
namespace {

QString remedies()
{
    return words("Start it on a desktop, or as \"xvfb-run -a ripstop\" where there is none; with "
                 "LIBGL_ALWAYS_SOFTWARE=1 it draws without a graphics card. ripstop-cli needs no "
                 "window.");
}

QString firstHeard; // of the messages that are held back

// In English, because no translation can be installed before there is an application.
[[noreturn]] void endWithoutDisplay(const QString& reason)
{
    std::fprintf(stderr, "ripstop: there is no display for the window: %s. %s\n",
                 qPrintable(reason), qPrintable(remedies()));
    std::_Exit(noDisplay);
}

void holdBack(QtMsgType type, const QMessageLogContext&, const QString& message)
{
    // The fatal message only says that the one before it was fatal.
    if (type == QtFatalMsg)
        endWithoutDisplay(firstHeard.isEmpty() ? message.section('\n', 0, 0) : firstHeard);
    if (firstHeard.isEmpty())
        firstHeard = message.trimmed();
}

bool drawsInWidgets()
{
    const DisplayCheck quiet; // Qt says in its own words what lackOfOpenGl() says
    QOpenGLWidget probe;
    if (!firstHeard.isEmpty())
        return false;
    probe.resize(1, 1);
    probe.grabFramebuffer();
    if (!probe.isValid())
        return false;
    const auto wanted = QSurfaceFormat::defaultFormat().version();
    return probe.context()->format().version() >= wanted;
}

} // namespace

DisplayCheck::DisplayCheck()
{
    firstHeard.clear();
    qInstallMessageHandler(holdBack);
}

DisplayCheck::~DisplayCheck() { qInstallMessageHandler(nullptr); }

QString lackOfOpenGl()
{
    if (drawsInWidgets())
        return {};
    const QSurfaceFormat wanted = QSurfaceFormat::defaultFormat();
    return words("the platform \"%1\" has no OpenGL %2.%3, which the view in three dimensions "
                 "needs. %4")
        .arg(QGuiApplication::platformName())
        .arg(wanted.majorVersion())
        .arg(wanted.minorVersion())
        .arg(remedies());
}

void showLack(const QString& lack)
{
    const QString platform = QGuiApplication::platformName();
    if (platform == QLatin1String("xcb") || platform.startsWith(QLatin1String("wayland")))
        QMessageBox::critical(nullptr, QCoreApplication::applicationName(),
                              words("Ripstop cannot open its window: %1").arg(lack));
}

} // namespace ripstop
