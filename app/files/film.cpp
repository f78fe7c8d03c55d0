// Stages: the table of formats holds the arguments of ffmpeg for each. Two sinks take frames:
// Pictures draws each frame and writes a file of it; Film starts ffmpeg with the size of the first
// picture and writes raw pixels into its input, waiting until they are taken, so that no more than
// one picture is held. Both write to temporary files that finish() puts into place, so that a
// cancelled film leaves nothing. Failures of ffmpeg are passed on in its own words.
#include "files/film.h"

#include "export/output_files.h"
#include "export/series.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>

namespace ripstop {
namespace {

using Alpha = FilmFormat::Alpha;

// Most codecs need an even number of pixels in each direction.
constexpr const char* even = "crop=trunc(iw/2)*2:trunc(ih/2)*2";

// The whole film gets one palette of its own.
constexpr const char* palette =
    "split[a][b];[a]palettegen=reserve_transparent=1[p];[b][p]paletteuse=alpha_threshold=128";

constexpr FilmFormat formats[]{
    {".mp4", QT_TRANSLATE_NOOP("Film", "Film, MP4"),
     QT_TRANSLATE_NOOP("Film", "H.264, which everything plays. Made by ffmpeg."), Alpha::Lost, even,
     "-c:v libx264 -preset medium -crf 18 -pix_fmt yuv420p -movflags +faststart -f mp4"},
    {".webm", QT_TRANSLATE_NOOP("Film", "Film, WebM"),
     QT_TRANSLATE_NOOP("Film",
                       "VP9 for web pages; keeps a transparent background. Made by ffmpeg."),
     Alpha::Kept, even,
     "-c:v libvpx-vp9 -crf 24 -b:v 0 -row-mt 1 -cpu-used 4 -pix_fmt yuva420p -f webm"},
    {".gif", QT_TRANSLATE_NOOP("Film", "Moving picture, GIF"),
     QT_TRANSLATE_NOOP("Film", "For texts and slides; 256 colours, large. Made by ffmpeg."),
     Alpha::Kept, palette, "-f gif"},
    {"_{frame}.png", QT_TRANSLATE_NOOP("Film", "Pictures, PNG"),
     QT_TRANSLATE_NOOP("Film",
                       "One picture for each frame, exact; for other programs and for papers."),
     Alpha::Kept, nullptr, nullptr}};

Failure about(const QString& text) { return Failure(Message::verbatim(text.toStdString())); }

// A name without a place for the number gets one before its ending.
QString numbered(QString target)
{
    const auto placeholder = QString::fromUtf8(framePlaceholder.data());
    if (!target.contains(placeholder))
        target.insert(target.lastIndexOf('.'), "_" + placeholder);
    return target;
}

class Pictures final : public FrameSink
{
public:
    Pictures(const QString& target, DrawFrame draw)
        : m_target(target.toStdString())
        , m_draw(std::move(draw))
    {}

    std::optional<Failure> add(const Frame& frame) override
    {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        if (!m_draw(std::make_shared<Frame>(frame)).save(&buffer, "PNG"))
            return Failure{"A picture of this size cannot be drawn here; choose a smaller one."};
        return m_files.write(fileOfFrame(m_target, m_count++),
                             {bytes.constData(), std::size_t(bytes.size())});
    }

    std::optional<Failure> finish(const Progress&) override { return m_files.commit(); }

private:
    OutputFiles m_files;
    std::filesystem::path m_target;
    DrawFrame m_draw;
    std::size_t m_count = 0;
};

class Film final : public FrameSink
{
public:
    Film(const FilmFormat& format, const QString& target, double picturesPerSecond, DrawFrame draw)
        : m_format(format)
        , m_target(target)
        , m_rate(picturesPerSecond)
        , m_draw(std::move(draw))
    {}

    ~Film() override
    {
        if (m_ffmpeg.state() != QProcess::NotRunning) {
            m_ffmpeg.kill();
            m_ffmpeg.waitForFinished(-1);
        }
    }

    std::optional<Failure> add(const Frame& frame) override
    {
        const QImage picture =
            m_draw(std::make_shared<Frame>(frame)).convertToFormat(QImage::Format_RGBA8888);
        if (picture.isNull())
            return Failure{"A picture of this size cannot be drawn here; choose a smaller one."};
        if (m_ffmpeg.program().isEmpty()) {
            if (auto failure = start(picture.size()))
                return failure;
        } else if (m_ffmpeg.state() == QProcess::NotRunning) {
            return broken();
        }
        m_ffmpeg.write(reinterpret_cast<const char*>(picture.constBits()), picture.sizeInBytes());
        while (m_ffmpeg.bytesToWrite() > 0)
            if (!m_ffmpeg.waitForBytesWritten(-1))
                return broken();
        return std::nullopt;
    }

    std::optional<Failure> finish(const Progress&) override
    {
        m_ffmpeg.closeWriteChannel();
        m_ffmpeg.waitForFinished(-1);
        if (m_ffmpeg.exitStatus() != QProcess::NormalExit || m_ffmpeg.exitCode() != 0)
            return broken();
        return m_files.commit();
    }

private:
    std::optional<Failure> start(QSize size)
    {
        QStringList arguments{"-loglevel",
                              "error",
                              "-y",
                              "-f",
                              "rawvideo",
                              "-pixel_format",
                              "rgba",
                              "-video_size",
                              QString("%1x%2").arg(size.width()).arg(size.height()),
                              "-framerate",
                              QString::number(m_rate),
                              "-i",
                              "-",
                              "-an",
                              "-filter_complex",
                              m_format.filter};
        arguments += QString(m_format.codec).split(' ');
        arguments += QString::fromStdString(m_files.reserve(m_target.toStdString()).string());
        m_ffmpeg.start("ffmpeg", arguments);
        if (!m_ffmpeg.waitForStarted(-1))
            return about(whyNoFilm(m_format));
        return std::nullopt;
    }

    Failure broken()
    {
        m_ffmpeg.waitForFinished(-1);
        const QString said = QString::fromLocal8Bit(m_ffmpeg.readAllStandardError()).trimmed();
        return about(QCoreApplication::translate("Film", "%1 was not written; ffmpeg says: %2")
                         .arg(m_target, said.isEmpty() ? m_ffmpeg.errorString() : said));
    }

    const FilmFormat& m_format;
    QString m_target;
    double m_rate; // pictures per second
    DrawFrame m_draw;
    OutputFiles m_files; // outlives ffmpeg, which writes there
    QProcess m_ffmpeg;
};

} // namespace

std::span<const FilmFormat> filmFormats() { return formats; }

QSize filmSize(const FilmFormat& format, QSize pictures)
{
    if (format.filter != even)
        return pictures;
    return {pictures.width() / 2 * 2, pictures.height() / 2 * 2};
}

const FilmFormat* filmFormatOf(const QString& target)
{
    const QString extension = QFileInfo(target).suffix().toLower();
    for (const FilmFormat& format : formats)
        if (QString(format.ending).endsWith("." + extension))
            return &format;
    return nullptr;
}

QString whyNoFilm(const FilmFormat& format)
{
    if (!format.codec || !QStandardPaths::findExecutable("ffmpeg").isEmpty())
        return {};
    return QCoreApplication::translate("Film",
                                       "The program ffmpeg, which makes films, is not "
                                       "installed. Install it (Debian: apt install ffmpeg), "
                                       "or choose pictures.");
}

Result<std::unique_ptr<FrameSink>> openFilm(const FilmFormat& format, const QString& target,
                                            double picturesPerSecond, DrawFrame draw)
{
    if (!format.codec)
        return std::unique_ptr<FrameSink>(
            std::make_unique<Pictures>(numbered(target), std::move(draw)));
    if (const QString why = whyNoFilm(format); !why.isEmpty())
        return about(why);
    return std::unique_ptr<FrameSink>(
        std::make_unique<Film>(format, target, picturesPerSecond, std::move(draw)));
}

} // namespace ripstop
