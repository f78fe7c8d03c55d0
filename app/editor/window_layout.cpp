#include "editor/window_layout.h"

#include <QMainWindow>
#include <QSettings>

namespace ripstop {
namespace {

constexpr int layoutVersion = 2; // raised when docks change so that an old layout would mislead

} // namespace

void keepLayout(const QMainWindow& window)
{
    QSettings settings;
    settings.setValue("window/geometry", window.saveGeometry());
    settings.setValue("window/state", window.saveState(layoutVersion));
}

void restoreLayout(QMainWindow& window)
{
    const QSettings settings;
    window.restoreGeometry(settings.value("window/geometry").toByteArray());
    window.restoreState(settings.value("window/state").toByteArray(), layoutVersion);
}

} // namespace ripstop
