// How the pictures of a film are to look, and the caption that is painted into them.
//
// The export dialog fills it; the view draws what concerns the scene, and paintCaption() the rest.
// It paints on a QImage, on the calling thread.
#pragma once

#include "simulation/frame.h"

#include <QImage>
#include <QSize>
#include <QStringList>

#include <cstdint>
#include <vector>

namespace ripstop {

struct Scene;

struct FilmLook
{
    QSize size;           // pixels
    bool overlays = true; // legend and compass
    bool time = true;
    bool probes = false; // those probes that are plotted
    bool pins = false;   // the marks of fixed particles, which are for who edits
    bool transparent = false;
    std::vector<std::uint32_t> inPercent = {}; // ids of probes, see sharesOf()
};

// The probes that read strains and other shares, which people say in percent. By id.
std::vector<std::uint32_t> sharesOf(const Scene& scene);

// What paintCaption() writes.
QStringList captionOf(const Frame& frame, const FilmLook& look);

// Writes time and probes into the upper left corner, in letters that fit the picture.
void paintCaption(QImage& picture, const Frame& frame, const FilmLook& look);

} // namespace ripstop
