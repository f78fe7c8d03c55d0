#pragma once

#include <QColor>

class QPalette;

namespace ripstop {

// The colours of everything in the view that is not the author's own.
struct Theme
{
    QColor skyTop;
    QColor skyBottom;
    QColor ground;
    QColor groundLine;
    QColor shadow;
    QColor text;
    QColor card; // behind the text
    QColor accent;
    QColor particle;
    QColor pin;
    QColor wind;
    QColor neutral; // elements that a coloured quantity says nothing about

    QColor axis(int number) const; // x, y, z: red, green, blue

    bool isDark() const { return text.lightnessF() > 0.5; }

    static Theme light();
    static Theme dark();

    // Light or dark as the palette is, with its highlight colour as the accent.
    static Theme from(const QPalette& palette);
};

} // namespace ripstop
