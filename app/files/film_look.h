#pragma once

#include "run/frame.h"

#include <QImage>
#include <QSize>

namespace ripstop {

// How the pictures of a film are to look.
struct FilmLook
{
    QSize size;           // pixels
    bool overlays = true; // legend and compass
    bool time = true;
    bool probes = false; // that are plotted
    bool transparent = false;
};

// Writes time and probes into the upper left corner, in letters that fit the picture.
void paintCaption(QImage& picture, const Frame& frame, const FilmLook& look);

} // namespace ripstop
