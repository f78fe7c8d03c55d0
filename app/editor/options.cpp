// Stages: readOptions() declares the options with their help, lets Qt parse them (which ends the
// program on --help, --version and unknown options), then reads those that are text as they are,
// and checks the numbers, the size and the names of language, theme and colour. The first that
// makes no sense is refused with a sentence.
#include "editor/options.h"

#include "document/words.h"
#include "files/view_picture.h"
#include "import/import_dialog.h"

#include <QCommandLineParser>
#include <QRegularExpression>

namespace ripstop {
namespace {

const QStringList appearances{"desktop", "light", "dark"};      // in the order of ThemeChoice
const QStringList backdrops{"scenery", "white", "transparent"}; // in the order of Backdrop

QStringList colors() // in the order of ColorBy
{
    QStringList names;
    for (const std::string_view name : colorByNames)
        names << QString::fromUtf8(name.data(), qsizetype(name.size()));
    return names;
}

bool isPage(const QString& file) // which holds text, as pictures of a window cannot
{
    return file.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive)
           || file.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive);
}

std::optional<QSize> sizeFrom(const QString& text)
{
    static const QRegularExpression pattern("^(\\d{2,5})x(\\d{2,5})$");
    const auto match = pattern.match(text);
    if (!match.hasMatch())
        return std::nullopt;
    return QSize(match.captured(1).toInt(), match.captured(2).toInt());
}

} // namespace

std::optional<Options> readOptions(const QStringList& arguments, QString& error)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(words(
        "Ripstop, an editor and simulator for fabric that flies.\n\nripstop-cli does the same "
        "work without a window."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(
        "scene",
        words("Scene file to open (*.ripstop.json), or a mesh to import (*.obj, *.stl, ...)."),
        "[SCENE]");
    const QCommandLineOption play("play", words("Start the simulation at once."));
    const QCommandLineOption screenshot("screenshot",
                                        words("Save a picture of the window as FILE (PNG), or of "
                                              "the view (also SVG, PDF), and quit."),
                                        "FILE");
    const QCommandLineOption after(
        "after", words("Take the picture after this much simulated time (0)."), "SECONDS", "0");
    const QCommandLineOption frames(
        "frames",
        words("Take N pictures at equal steps up to that time; %1 in FILE becomes the number."),
        "N", "1");
    const QCommandLineOption viewOnly("view-only",
                                      words("Only the 3D view, without legend and compass."));
    const QCommandLineOption pictureWidth(
        "picture-width", words("Width of a picture of the view alone, for papers: 3000."),
        "PIXELS");
    const QCommandLineOption backdrop(
        "backdrop",
        words("What lies behind things in a picture of the view: scenery, white or "
              "transparent."),
        "NAME");
    const QCommandLineOption legend("legend",
                                    words("Legend and compass in a picture of the view."));
    const QCommandLineOption size("size", words("Size of the window (1280x800)."), "WxH");
    const QCommandLineOption theme(
        "theme", words("Colours: desktop, light or dark; as chosen in the View menu."), "NAME");
    const QCommandLineOption language(
        "language", words("Language of the window: system, en or fr; as chosen in the View menu."),
        "CODE");
    const QCommandLineOption colorBy(
        "color-by", words("Colour by one of %1.").arg(colors().join(", ")), "NAME", "material");
    const QCommandLineOption select(
        "select",
        words("Select the item of this name, or what meets this condition: \"mass < 1 g\"."),
        "WHAT");
    const QCommandLineOption fit("fit", words("Fill the picture with the item of this name."),
                                 "NAME");
    const QCommandLineOption dock(
        "dock", words("Bring a panel to the front: tuning, table, problems, ...; more than once."),
        "NAME");
    const QCommandLineOption action(
        "action", words("Do this as from a menu, once the window is there: \"insert bridle\"."),
        "ID");
    parser.addOptions({action, play, screenshot, after, frames, viewOnly, pictureWidth, backdrop,
                       legend, size, theme, language, colorBy, select, fit, dock});
    parser.process(arguments);

    Options options;
    const QStringList files = parser.positionalArguments();
    if (files.size() > 1) {
        error = words("one scene at a time; \"%1\" is one too many").arg(files[1]);
        return std::nullopt;
    }
    const bool isMesh = ImportDialog::isMesh(files.value(0));
    (isMesh ? options.mesh : options.scene) = files.value(0);
    options.play = parser.isSet(play);
    options.screenshot = parser.value(screenshot);
    options.viewOnly = parser.isSet(viewOnly) || parser.isSet(pictureWidth)
                       || parser.isSet(backdrop) || parser.isSet(legend)
                       || isPage(options.screenshot);
    options.legend = parser.isSet(legend);
    options.select = parser.value(select);
    options.fit = parser.value(fit);
    options.docks = parser.values(dock);
    options.action = parser.value(action);

    bool isNumber = false;
    options.after = parser.value(after).toDouble(&isNumber);
    if (!isNumber || !(options.after >= 0.0) || options.after > 1e6) {
        error = words("--after needs a time in seconds, not \"%1\"").arg(parser.value(after));
        return std::nullopt;
    }
    options.frames = parser.value(frames).toInt(&isNumber);
    if (!isNumber || options.frames < 1 || options.frames > 100000) {
        error = words("--frames needs a number of pictures, not \"%1\"").arg(parser.value(frames));
        return std::nullopt;
    }
    options.pictureWidth = parser.value(pictureWidth).toInt(&isNumber);
    if (parser.isSet(pictureWidth)
        && (!isNumber || options.pictureWidth < 16 || options.pictureWidth > mostPixels)) {
        error = words("--picture-width needs a number of pixels from 16 to %1, not \"%2\"")
                    .arg(QString::number(mostPixels), parser.value(pictureWidth));
        return std::nullopt;
    }
    if (parser.isSet(backdrop)) {
        const auto chosen = backdrops.indexOf(parser.value(backdrop));
        if (chosen < 0) {
            error = words("--backdrop is one of %1").arg(backdrops.join(", "));
            return std::nullopt;
        }
        options.backdrop = Backdrop(chosen);
    }
    if (parser.isSet(size) && !(options.size = sizeFrom(parser.value(size)))) {
        error = words("--size needs a size like 1280x800, not \"%1\"").arg(parser.value(size));
        return std::nullopt;
    }
    if (parser.isSet(language) && !(options.language = languageFromCode(parser.value(language)))) {
        error = words("--language is system, en or fr, not \"%1\"").arg(parser.value(language));
        return std::nullopt;
    }
    const auto appearance = appearances.indexOf(parser.value(theme));
    const auto quantity = colors().indexOf(parser.value(colorBy));
    if (appearance < 0 && parser.isSet(theme)) {
        error = words("--theme is one of %1").arg(appearances.join(", "));
        return std::nullopt;
    }
    if (quantity < 0) {
        error = words("--color-by is one of %1").arg(colors().join(", "));
        return std::nullopt;
    }
    if (parser.isSet(theme))
        options.appearance = ThemeChoice(appearance);
    options.colorBy = ColorBy(quantity);
    return options;
}

} // namespace ripstop
