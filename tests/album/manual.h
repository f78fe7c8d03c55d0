// The pictures of the manual that show a hand at work: links being drawn, a mode that swings, a
// kite that is pulled. The editor's own --screenshot has no mouse, so they are taken here.
//
// The folder must exist; pictures in it are replaced. It needs an application with a 3D view
// (prepareViews() in moments.h) and runs on the thread of the window.
#pragma once

#include <QString>

namespace ripstop {

void takeManualPictures(const QString& folder);

} // namespace ripstop
