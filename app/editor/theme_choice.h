#pragma once

#include <QString>

class QApplication;

namespace ripstop {

enum class ThemeChoice { Desktop, Light, Dark };

// Fusion everywhere, so that the editor looks the same on every desktop; light or dark as the
// desktop's palette is, or as asked.
void applyThemeChoice(QApplication& application, ThemeChoice appearance);

} // namespace ripstop
