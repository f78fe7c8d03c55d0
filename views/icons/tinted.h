#pragma once

#include <QColor>
#include <QIcon>

namespace ripstop {

// The icon in one colour, also where its row is selected. Choose one that can be told on light and
// on dark.
QIcon tinted(const QString& name, const QColor& colour);

} // namespace ripstop
