// Icons of icon.h in a colour of their own, for signs such as errors and warnings.
//
// Other than those of icon.h they are pixmaps of one size, 20 by 20 pixels, and do not follow the
// palette.
#pragma once

#include <QColor>
#include <QIcon>

namespace ripstop {

// The icon in one colour, and in that of the words where its row is selected: red on the blue of a
// selection is not seen. Choose a colour that can be told on light and on dark, and icons that can
// be told by their forms.
QIcon tinted(const QString& name, const QColor& colour);

} // namespace ripstop
