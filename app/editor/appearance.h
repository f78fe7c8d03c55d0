#pragma once

#include <QString>

class QApplication;

namespace ripstop {

enum class Appearance { Desktop, Light, Dark };

// Fusion everywhere, so that the editor looks the same on every desktop; light or dark as the
// desktop's palette is, or as asked.
void applyAppearance(QApplication& application, Appearance appearance);

} // namespace ripstop
