// The colours of the window: light, dark, or as the palette of the desktop is.
//
// main() applies the choice once, before the window is made. The style is Fusion everywhere, so
// that the editor looks alike on every desktop; the style sheet is :/style/ripstop.qss.
#pragma once

#include <QString>

class QApplication;

namespace ripstop {

enum class ThemeChoice { Desktop, Light, Dark };

void applyThemeChoice(QApplication& application, ThemeChoice appearance);

} // namespace ripstop
