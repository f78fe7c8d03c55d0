// Events of a run in words and colours, the same in plots, in the timeline and in the status bar.
// The texts are in the language of the window and call things by their names in a scene; the
// colours suit the palette. Both are pure functions, called from the window's thread.
#pragma once

#include "recording/run_event.h"
#include "scene/scene.h"

#include <QColor>
#include <QPalette>
#include <QString>

namespace ripstop {

// "3.204 s: canopy touches ground". With `more` it goes on: ", and 3 more in this step". Names are
// looked up in the scene; what it does not have is called by its number.
QString describe(const RunEvent& event, const Scene& scene, int more = 0);

// With the discrete gust that blows at the time. `flown` is the design of the run at that time,
// which the open one is only while it flies.
QString describeInGust(const RunEvent& event, const Scene& flown);

// The colour of the marks of such events; what begins and what ends it have the same one.
QColor eventColor(RunEvent::Kind kind, const QPalette& palette);

} // namespace ripstop
