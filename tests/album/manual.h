// The pictures of the manual that show a hand at work: links being drawn, a mode that swings, a
// kite that is pulled. The editor's own --screenshot has no mouse.
#pragma once

#include <QString>

namespace ripstop {

void takeManualPictures(const QString& folder);

} // namespace ripstop
