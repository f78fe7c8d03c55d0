#include "look/theme.h"

#include <QPalette>

namespace ripstop {

Theme Theme::light()
{
    Theme theme;
    theme.skyTop = QColor(0x7f, 0xa9, 0xd6);
    theme.skyBottom = QColor(0xee, 0xf2, 0xf4);
    theme.sun = QColor(0xff, 0xf8, 0xe8);
    theme.ground = QColor(0xcd, 0xd6, 0xc6);
    theme.groundSquare = QColor(0xc2, 0xcd, 0xba);
    theme.groundLine = QColor(0x8a, 0x99, 0x8a);
    theme.shadow = QColor(0x78, 0x85, 0x80);
    theme.text = QColor(0x1d, 0x25, 0x2c);
    theme.card = QColor(0xff, 0xff, 0xff, 0xb8);
    theme.accent = QColor(0x0b, 0x6c, 0xda);
    theme.particle = QColor(0x26, 0x32, 0x38);
    theme.pin = QColor(0xd8, 0x31, 0x2a);
    theme.person = QColor(0x4d, 0x5b, 0x69);
    theme.wind = QColor(0x0c, 0x7d, 0xa8);
    theme.neutral = QColor(0x9a, 0xa4, 0xaa);
    return theme;
}

Theme Theme::dark()
{
    Theme theme;
    theme.skyTop = QColor(0x16, 0x1d, 0x2a);
    theme.skyBottom = QColor(0x42, 0x4f, 0x5d);
    theme.sun = QColor(0x6a, 0x70, 0x74);
    theme.ground = QColor(0x2b, 0x34, 0x35);
    theme.groundSquare = QColor(0x25, 0x2d, 0x2e);
    theme.groundLine = QColor(0x62, 0x70, 0x72);
    theme.shadow = QColor(0x0e, 0x12, 0x14);
    theme.text = QColor(0xe8, 0xec, 0xef);
    theme.card = QColor(0x12, 0x17, 0x1d, 0xb0);
    theme.accent = QColor(0x4d, 0xa3, 0xff);
    theme.particle = QColor(0xdd, 0xe4, 0xe8);
    theme.pin = QColor(0xff, 0x5f, 0x52);
    theme.person = QColor(0xa6, 0xb3, 0xbf);
    theme.wind = QColor(0x55, 0xc7, 0xee);
    theme.neutral = QColor(0x70, 0x7b, 0x84);
    return theme;
}

QColor Theme::axis(int number) const
{
    if (number == 0)
        return isDark() ? QColor(0xff, 0x75, 0x6b) : QColor(0xc6, 0x28, 0x28);
    if (number == 1)
        return isDark() ? QColor(0x7b, 0xd8, 0x7f) : QColor(0x2e, 0x7d, 0x32);
    return isDark() ? QColor(0x7a, 0xb2, 0xff) : QColor(0x15, 0x65, 0xc0);
}

Theme Theme::from(const QPalette& palette)
{
    const bool isDark = palette.color(QPalette::Window).lightnessF() < 0.5;
    Theme theme = isDark ? dark() : light();
    const QColor highlight = palette.color(QPalette::Active, QPalette::Highlight);
    if (highlight.hslSaturationF() > 0.3) // a grey accent would not stand out
        theme.accent = isDark ? highlight.lighter(125) : highlight;
    return theme;
}

} // namespace ripstop
