// Qt parses the options, which ends the program on --help, --version and unknown options. Then the
// values are taken, text as it is, numbers and names with a look at them. The first that makes no
// sense is refused with a sentence.
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

class Parser : public QCommandLineParser
{
public:
    Parser()
    {
        setApplicationDescription(words(
            "Ripstop, an editor and simulator for fabric that flies.\n\nripstop-cli does the same "
            "work without a window."));
        addHelpOption();
        addVersionOption();
        addPositionalArgument(
            "scene",
            words("Scene to open (*.ripstop.json), recording to look back at (*.ripstop-run), or "
                  "mesh to import (*.obj, *.stl, ...)."),
            "[SCENE]");
    }
};

// Each option is a member, which declares it as it is made. The functions that take values return
// what is wrong with them, or an empty text.
class OptionReader
{
public:
    std::optional<Options> read(const QStringList& arguments, QString& error)
    {
        m_parser.process(arguments);
        Options options;
        for (const auto take : {&OptionReader::takeTexts, &OptionReader::takeNumbers,
                                &OptionReader::takePicture, &OptionReader::takeWindow})
            if (error = (this->*take)(options); !error.isEmpty())
                return std::nullopt;
        return options;
    }

private:
    QCommandLineOption add(const QCommandLineOption& option)
    {
        m_parser.addOption(option);
        return option;
    }

    QString takeTexts(Options& options) const
    {
        const QStringList files = m_parser.positionalArguments();
        if (files.size() > 1)
            return words("one scene at a time; \"%1\" is one too many").arg(files[1]);
        const bool isMesh = ImportDialog::isMesh(files.value(0));
        (isMesh ? options.mesh : options.scene) = files.value(0);
        options.play = m_parser.isSet(m_play);
        options.screenshot = m_parser.value(m_screenshot);
        options.select = m_parser.value(m_select);
        options.fit = m_parser.value(m_fit);
        options.docks = m_parser.values(m_dock);
        options.action = m_parser.value(m_action);
        return {};
    }

    QString takeNumbers(Options& options) const
    {
        bool isNumber = false;
        options.after = m_parser.value(m_after).toDouble(&isNumber);
        if (!isNumber || !(options.after >= 0.0) || options.after > 1e6)
            return words("--after needs a time in seconds, not \"%1\"")
                .arg(m_parser.value(m_after));
        options.frames = m_parser.value(m_frames).toInt(&isNumber);
        if (!isNumber || options.frames < 1 || options.frames > 100000)
            return words("--frames needs a number of pictures, not \"%1\"")
                .arg(m_parser.value(m_frames));
        options.pictureWidth = m_parser.value(m_pictureWidth).toInt(&isNumber);
        if (m_parser.isSet(m_pictureWidth)
            && (!isNumber || options.pictureWidth < 16 || options.pictureWidth > mostPixels))
            return words("--picture-width needs a number of pixels from 16 to %1, not \"%2\"")
                .arg(QString::number(mostPixels), m_parser.value(m_pictureWidth));
        return {};
    }

    QString takePicture(Options& options) const
    {
        options.legend = m_parser.isSet(m_legend);
        options.pins = m_parser.isSet(m_pins);
        options.viewOnly = m_parser.isSet(m_viewOnly) || m_parser.isSet(m_pictureWidth)
                           || m_parser.isSet(m_backdrop) || options.legend || options.pins
                           || isPage(options.screenshot);
        if (m_parser.isSet(m_backdrop)) {
            const auto backdrop = backdrops.indexOf(m_parser.value(m_backdrop));
            if (backdrop < 0)
                return words("--backdrop is one of %1").arg(backdrops.join(", "));
            options.backdrop = Backdrop(backdrop);
        }
        const auto quantity = colors().indexOf(m_parser.value(m_colorBy));
        if (quantity < 0)
            return words("--color-by is one of %1").arg(colors().join(", "));
        options.colorBy = ColorBy(quantity);
        return {};
    }

    QString takeWindow(Options& options) const
    {
        if (const QString size = m_parser.value(m_size);
            m_parser.isSet(m_size) && !(options.size = sizeFrom(size)))
            return words("--size needs a size like 1280x800, not \"%1\"").arg(size);
        if (const QString code = m_parser.value(m_language);
            m_parser.isSet(m_language) && !(options.language = languageFromCode(code)))
            return words("--language is system, en or fr, not \"%1\"").arg(code);
        if (m_parser.isSet(m_theme)) {
            const auto appearance = appearances.indexOf(m_parser.value(m_theme));
            if (appearance < 0)
                return words("--theme is one of %1").arg(appearances.join(", "));
            options.appearance = ThemeChoice(appearance);
        }
        return {};
    }

    Parser m_parser; // before the options, which it is told of
    const QCommandLineOption m_action =
        add({"action",
             words("Do this as from a menu, once the window is there: \"insert bridle\"."), "ID"});
    const QCommandLineOption m_play = add({"play", words("Start the simulation at once.")});
    const QCommandLineOption m_screenshot =
        add({"screenshot",
             words("Save a picture of the window as FILE (PNG), or of "
                   "the view (also SVG, PDF), and quit."),
             "FILE"});
    const QCommandLineOption m_after = add(
        {"after", words("Take the picture after this much simulated time (0)."), "SECONDS", "0"});
    const QCommandLineOption m_frames = add(
        {"frames",
         words("Take N pictures at equal steps up to that time; %1 in FILE becomes the number."),
         "N", "1"});
    const QCommandLineOption m_viewOnly =
        add({"view-only", words("Only the 3D view, without legend and compass.")});
    const QCommandLineOption m_pictureWidth =
        add({"picture-width", words("Width of a picture of the view alone, for papers: 3000."),
             "PIXELS"});
    const QCommandLineOption m_backdrop =
        add({"backdrop",
             words("What lies behind things in a picture of the view: scenery, white or "
                   "transparent."),
             "NAME"});
    const QCommandLineOption m_legend =
        add({"legend", words("Legend and compass in a picture of the view.")});
    const QCommandLineOption m_pins =
        add({"pins", words("Marks of fixed particles in a picture of the view.")});
    const QCommandLineOption m_size = add({"size", words("Size of the window (1280x800)."), "WxH"});
    const QCommandLineOption m_theme = add(
        {"theme", words("Colours: desktop, light or dark; as chosen in the View menu."), "NAME"});
    const QCommandLineOption m_language = add(
        {"language", words("Language of the window: system, en or fr; as chosen in the View menu."),
         "CODE"});
    const QCommandLineOption m_colorBy = add(
        {"color-by", words("Colour by one of %1.").arg(colors().join(", ")), "NAME", "material"});
    const QCommandLineOption m_select =
        add({"select",
             words("Select the item of this name, or what meets this condition: \"mass < 1 g\"."),
             "WHAT"});
    const QCommandLineOption m_fit =
        add({"fit", words("Fill the picture with the item of this name."), "NAME"});
    const QCommandLineOption m_dock = add(
        {"dock", words("Bring a panel to the front: tuning, table, problems, ...; more than once."),
         "NAME"});
};

} // namespace

std::optional<Options> readOptions(const QStringList& arguments, QString& error)
{
    return OptionReader().read(arguments, error);
}

} // namespace ripstop
