// Stages: the functions at the top name the files of a choice and say in words what they hold, for
// meshes, pictures, films, tables and bundles; sizes of pictures are estimated by bytes a pixel.
// exportChoices() puts the tables of formats into one list; replacedBy() looks for files that
// exist; and previewOf() joins all into the text under the form.
#include "files/export_choice.h"

#include "document/spoken.h"
#include "run/tear_report.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>

namespace ripstop {
namespace {

QString tr(const char* text, int n = -1)
{
    return QCoreApplication::translate("ExportDialog", text, nullptr, n);
}

QString rounded(double value) { return spokenNumber(value); }

QString sizeInWords(double bytes)
{
    return QLocale().formattedDataSize(qint64(bytes), 1, QLocale::DataSizeSIFormat);
}

std::vector<std::filesystem::path> filesOf(const ExportChoice& choice, const QString& target,
                                           std::size_t frames, const MeshAppearance& appearance)
{
    const std::filesystem::path path = target.toStdString();
    if (choice.mesh())
        return ripstop::filesOf(*choice.mesh(), path, frames, appearance);
    std::vector<std::filesystem::path> files;
    if (choice.film() && !choice.film()->codec)
        for (std::size_t i = 0; i < frames; ++i)
            files.push_back(fileOfFrame(path, i));
    else
        files.push_back(path);
    return files;
}

// What has no ending is a folder.
QString nameOf(const std::filesystem::path& file)
{
    const QString name = QString::fromStdString(file.filename().string());
    return file.has_extension() ? name : tr("the folder %1").arg(name);
}

// "a.obj", "a.pc2 and a.obj", "a_0000.obj to a_0250.obj", "a.obj, and its materials in a.mtl"
QString inWords(std::vector<std::filesystem::path> files)
{
    if (files.size() > 1 && files.back().extension() == ".mtl") {
        const QString materials = nameOf(files.back());
        files.pop_back();
        return tr("%1, and the materials in %2").arg(inWords(std::move(files)), materials);
    }
    if (files.size() == 1)
        return nameOf(files[0]);
    if (files.size() == 2)
        return tr("%1 and %2").arg(nameOf(files[0]), nameOf(files[1]));
    return tr("%1 to %2").arg(nameOf(files.front()), nameOf(files.back()));
}

// The size of pictures as PNG files. Films are smaller, by how much depends on what is seen.
double bytesOfPictures(QSize size, std::size_t frames)
{
    constexpr double bytesPerPixel = 0.15;
    return bytesPerPixel * size.width() * size.height() * double(frames);
}

QString tearsInWords(const Frame* frame, const Scene& scene)
{
    if (!frame || frame->tears.empty())
        return tr("Nothing has torn in the run on the screen: the table will be empty.");
    const TearReport report = tearReport(frame->tears, *frame->layout, placesIn(scene));
    return tr("Links that broke in the run on the screen: %1, the first at %2 s. In the design, "
              "the "
              "tears reach %3 m from there; they released %4 J.")
        .arg(report.count)
        .arg(rounded(frame->tears.front().time), rounded(report.front.back().distance),
             rounded(report.energy));
}

QString controlsInWords(const Frame* frame)
{
    if (!frame || (frame->commands.empty() && frame->hands.empty()))
        return tr("No control and no hand has moved anything in this run.");
    return tr("What the pilot and your hands did in this run: %1 commands, %2 moves of the hand.")
        .arg(frame->commands.size())
        .arg(frame->hands.size());
}

QString filmInWords(const FilmFormat& format, std::size_t frames, QSize picture)
{
    const QSize size = filmSize(format, picture);
    const QString text =
        tr("%1 frames of %2 × %3 pixels.").arg(frames).arg(size.width()).arg(size.height());
    return size == picture ? text
                           : text + ' '
                                 + tr("Films of this kind have an even number of pixels in each "
                                      "direction: the last column or row is left out.");
}

QString contentInWords(const ExportChoice& choice, std::size_t frames, const Scene& scene,
                       const Frame* now, QSize picture)
{
    if (choice.isBundle())
        return tr(
            "In it are the scene, what was done by hand, the recording, the probes as a table "
            "and a figure, a picture of the view, and the command lines that make all of it "
            "again.");
    if (const auto* table = std::get_if<RunTable>(&choice.what))
        return *table == RunTable::Tears ? tearsInWords(now, scene) : controlsInWords(now);
    if (choice.film())
        return choice.film()->codec ? filmInWords(*choice.film(), frames, picture)
                                    : tr("%1 frames of %2 × %3 pixels, about %4.")
                                          .arg(frames)
                                          .arg(picture.width())
                                          .arg(picture.height())
                                          .arg(sizeInWords(bytesOfPictures(picture, frames)));
    if (!now)
        return {};
    const ExportFormat& format = *choice.mesh();
    const QString size =
        sizeInWords(expectedSize(format, *now->layout, MeshAppearance(scene), frames));
    return choice.isSeries() ? tr("%1 frames, about %2.").arg(frames).arg(size)
                             : tr("The shape at %1 s, when this was opened, about %2.")
                                   .arg(rounded(now->time), size);
}

} // namespace

const ExportFormat* ExportChoice::mesh() const
{
    const auto* format = std::get_if<const ExportFormat*>(&what);
    return format ? *format : nullptr;
}

const FilmFormat* ExportChoice::film() const
{
    const auto* format = std::get_if<const FilmFormat*>(&what);
    return format ? *format : nullptr;
}

bool ExportChoice::isSeries() const
{
    return film() || (mesh() && mesh()->of == ExportFormat::Of::Series);
}

bool ExportChoice::isBundle() const { return std::holds_alternative<WholeRun>(what); }

std::vector<ExportChoice> exportChoices()
{
    std::vector<ExportChoice> choices;
    for (const ExportFormat& format : exportFormats())
        choices.push_back({&format, QString::fromUtf8(format.ending.data()),
                           tr(format.label.data()), tr(format.note.data())});
    for (const FilmFormat& format : filmFormats())
        choices.push_back({&format, format.ending,
                           QCoreApplication::translate("Film", format.label),
                           QCoreApplication::translate("Film", format.note)});
    choices.push_back(
        {RunTable::Tears, "_tears.csv", tr("Table of what has torn, CSV"),
         tr("A row for each link that broke: when, where, at which strain and force.")});
    choices.push_back({RunTable::Controls, "_controls.csv", tr("Control track of this run, CSV"),
                       tr("ripstop-cli run --controls does it again, in this or another design.")});
    choices.push_back({WholeRun{}, ".zip", tr("Bundle of the whole run, ZIP"),
                       tr("For a paper or a colleague: ripstop-cli run flies it again and compares "
                          "every step.")});
    return choices;
}

QStringList replacedBy(const ExportChoice& choice, const QString& target, std::size_t frames,
                       const MeshAppearance& appearance)
{
    QStringList there;
    for (const std::filesystem::path& file : filesOf(choice, target, frames, appearance))
        if (std::error_code error; std::filesystem::exists(file, error))
            there << QString::fromStdString(file.string());
    return there;
}

QString previewOf(const ExportChoice& choice, const QString& target, std::size_t frames,
                  const MeshAppearance& appearance, const Scene& scene, const Frame* now,
                  QSize picture)
{
    QString text = tr("Writes %1.").arg(inWords(filesOf(choice, target, frames, appearance))) + ' '
                   + contentInWords(choice, frames, scene, now, picture);
    const QStringList there = replacedBy(choice, target, frames, appearance);
    if (there.size() == 1)
        text += ' ' + tr("%1 is there and will be replaced.").arg(QFileInfo(there[0]).fileName());
    else if (!there.isEmpty())
        text += ' ' + tr("%1 of these files are there and will be replaced.").arg(there.size());
    return text;
}

} // namespace ripstop
