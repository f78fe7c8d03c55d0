// Films and pictures of a flight. Pictures are drawn by the view, films are made of them by the
// program ffmpeg, which has to be installed; whyNoFilm() says so where it is not.
//
// The formats are a table, from which the export dialog makes its choices. A sink takes frames one
// after another (FrameSink) and leaves nothing behind when it is destroyed before it has finished.
// Failures are sentences, those of ffmpeg in its own words. Sizes are in pixels, rates in pictures
// per second.
#pragma once

#include "export/frame_sink.h"

#include <QImage>
#include <QString>

#include <functional>
#include <memory>
#include <span>

namespace ripstop {

struct FilmFormat
{
    enum class Alpha { Kept, Lost };

    const char* ending; // of the target's name
    const char* label;
    const char* note;
    Alpha alpha;        // what a transparent picture comes to
    const char* filter; // of ffmpeg, null for pictures, which need no ffmpeg
    const char* codec;  // arguments of ffmpeg with blanks between them, null for pictures
};

std::span<const FilmFormat> filmFormats();

// Pixels of the film that is made of pictures of this size: most codecs need even numbers, so that
// a row or a column at the edge is left out.
QSize filmSize(const FilmFormat& format, QSize pictures);

const FilmFormat* filmFormatOf(const QString& target); // null for none

// A sentence when a film cannot be made here, because ffmpeg is missing; or nothing.
QString whyNoFilm(const FilmFormat& format);

// All pictures have the same size.
using DrawFrame = std::function<QImage(const std::shared_ptr<const Frame>&)>;

// The sink has to be made, filled and destroyed by one thread, which also calls `draw`.
Result<std::unique_ptr<FrameSink>> openFilm(const FilmFormat& format, const QString& target,
                                            double picturesPerSecond, DrawFrame draw);

} // namespace ripstop
