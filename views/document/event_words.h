// Events of a run, as views show them.
#pragma once

#include "run/run_event.h"
#include "scene/scene.h"

#include <QColor>
#include <QPalette>
#include <QString>

namespace ripstop {

// "3.204 s: canopy touches ground", "..., and 3 more in this step"; the scene is the one that names
// are looked up in.
QString describe(const RunEvent& event, const Scene& scene, int more = 0);

QColor eventColor(RunEvent::Kind kind, const QPalette& palette);

} // namespace ripstop
