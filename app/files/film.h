// Films and pictures of a flight. Pictures are drawn by the view, films made of them by the program
// ffmpeg.
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

const FilmFormat* filmFormatOf(const QString& target); // null for none

// A sentence when a film cannot be made here, because ffmpeg is missing; or nothing.
QString whyNoFilm(const FilmFormat& format);

// All pictures have the same size.
using DrawFrame = std::function<QImage(const std::shared_ptr<const Frame>&)>;

// The sink has to be made, filled and destroyed by one thread, which also calls `draw`.
Result<std::unique_ptr<FrameSink>> openFilm(const FilmFormat& format, const QString& target,
                                            double picturesPerSecond, DrawFrame draw);

} // namespace ripstop
