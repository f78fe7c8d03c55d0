// The colours of the window: light, dark, or as the palette of the desktop is.
//
// main() applies the choice that was kept before it makes the window, and the View menu another one
// at any time. The style is Fusion everywhere, so that the editor looks alike on every desktop; the
// style sheet is :/style/ripstop.qss.
#pragma once

#include <QString>

class QApplication;

namespace ripstop {

enum class ThemeChoice { Desktop, Light, Dark };

void applyThemeChoice(QApplication& application, ThemeChoice appearance);

ThemeChoice keptThemeChoice(); // Desktop until one was chosen
void keepThemeChoice(ThemeChoice appearance);

} // namespace ripstop
