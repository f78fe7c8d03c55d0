// Pictures of the view for papers and posters: larger than the window, on paper or on nothing, with
// legend and compass that stay text where the file can hold text.
//
// PNG keeps what is transparent, JPEG has white there. In SVG and PDF the view is a picture and
// what lies over it is drawn above it, so that its letters can be searched, and changed, and have
// no pixels. Marks of editing are not in a picture: neither those of what is selected nor handles,
// and those of pins only where they are wanted, as in a film. It is for the thread of the window,
// which draws the view.
#pragma once

#include "look/backdrop.h"

#include <QImage>
#include <QSize>
#include <QString>

namespace ripstop {

class Viewport;

struct PictureLook
{
    QSize size; // pixels
    Backdrop backdrop = Backdrop::Scenery;
    bool overlays = true; // legend and compass
    bool pins = false;    // the marks of particles that are fixed or guided
};

inline constexpr int mostPixels = 16384; // along a side, as graphics cards have it

// The size that is so wide and has the shape of `view`.
QSize sizeOfWidth(int width, QSize view);

// The picture in pixels, of which a transparent background has none.
QImage pixelsOf(Viewport& viewport, const PictureLook& look);

// The ending of the file says its kind: png, jpg, svg or pdf. False when it cannot be written.
bool writePicture(Viewport& viewport, const PictureLook& look, const QString& file);

} // namespace ripstop
