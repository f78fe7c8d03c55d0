// The colours of everything in the view that is not the author's own.
//
// There is one set for light desktops and one for dark ones. The viewport chooses by the palette of
// the application and hands the set to its layers, overlays and tools; a Theme is a plain value
// that each of them may keep.
#pragma once

#include <QColor>

class QPalette;

namespace ripstop {

// One set of colours. The defaults are invalid colours: take light(), dark() or from().
struct Theme
{
    QColor skyTop;
    QColor skyBottom; // and haze
    QColor sun;       // of the sky around it
    QColor ground;
    QColor groundSquare; // every other square of it
    QColor groundLine;
    QColor shadow;
    QColor text;
    QColor card; // behind the text
    QColor accent;
    QColor particle;
    QColor pin;
    QColor person;
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
