// The icons of the editor, by name: "play", "particle", ... (resources/icons/NAME.svg).
//
// They are drawn in one colour, which is taken from the palette each time an icon is painted, so
// that the same drawing serves light and dark desktops. Kinds of items and elements have icons by
// the name of the kind.
#pragma once

#include <QIcon>
#include <QString>

namespace ripstop {

QIcon icon(const QString& name); // an empty picture when there is no such drawing

QIcon applicationIcon(); // in its own colours

} // namespace ripstop
