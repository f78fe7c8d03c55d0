// Pictures of everything that the window can show, to be looked at.
//
//     xvfb-run build/release/bin/ripstop-album FOLDER [--size WxH] [--theme NAME] [--language CODE]
//                                                 [--only PART]
//     xvfb-run build/release/bin/ripstop-album FOLDER --studies [as above]
//     xvfb-run build/release/bin/ripstop-album FOLDER --manual
//
// Leaves FOLDER/THEME-WxH/*.png for each size and theme (1280x800 and 1920x1080, light and dark,
// unless some are named), in English unless a language is, and says where a text is cut off or a
// window does not fit.
#include "album/manual.h"
#include "album/moments.h"
#include "album/picture.h"
#include "language/language.h"
#include "theme/theme_choice.h"

#include <QCommandLineParser>
#include <QRegularExpression>
#include <QSettings>
#include <QTemporaryDir>

#include <cstdio>

using namespace ripstop;

namespace {

// Saves what is in front when it stands still.
class Photographer
{
public:
    Photographer(MainWindow& window, const QString& folder, const QString& only)
        : m_window(window)
        , m_folder(folder)
        , m_only(only)
    {}

    bool operator()(const QString& name, QWidget& inFront)
    {
        if (!name.contains(m_only))
            return true;
        const QImage picture = pictureOf(m_window);
        if (name != m_name || picture != m_picture) {
            m_turns = name == m_name ? m_turns + 1 : 0;
            m_name = name;
            m_picture = picture;
            if (m_turns < mostTurns)
                return false;
        }
        QString file = name;
        static const QRegularExpression odd("[^A-Za-z0-9]+");
        picture.save(m_folder.filePath(file.replace(odd, "_") + ".png"));
        for (const QString& fault : faultsOf(inFront))
            std::printf("%s: %s: %s\n", qPrintable(m_folder.dirName()), qPrintable(name),
                        qPrintable(fault));
        std::fflush(stdout);
        m_name.clear();
        return true;
    }

private:
    static constexpr int mostTurns = 12; // what moves for ever has its picture taken all the same

    MainWindow& m_window;
    QDir m_folder;
    QString m_only;
    QString m_name;
    QImage m_picture;
    int m_turns = 0;
};

using Show = void (*)(WindowShop&, const WindowWalk::Look&);

void fill(Show show, const QString& folder, const QString& theme, QSize size, const QString& only)
{
    const QString name = QString("%1-%2x%3").arg(theme).arg(size.width()).arg(size.height());
    QDir().mkpath(QDir(folder).filePath(name));
    WindowShop shop;
    shop.window.resize(size);
    shop.window.show();
    QApplication::setActiveWindow(&shop.window); // Xvfb has no window manager to do it
    show(shop, Photographer(shop.window, QDir(folder).filePath(name), only));
}

} // namespace

int main(int argc, char** argv)
{
    prepareViews();
    QApplication application(argc, argv);
    QApplication::setApplicationName("RipstopAlbum");
    // What the walk chooses is nobody's choice, and the next album must not begin with it.
    const QTemporaryDir settings;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addPositionalArgument("FOLDER", "Where the pictures go.");
    const QCommandLineOption size("size", "1280x800 and 1920x1080 unless named.", "WxH");
    const QCommandLineOption theme("theme", "light and dark unless named.", "NAME");
    const QCommandLineOption language("language", "English unless named.", "CODE", "en");
    const QCommandLineOption only("only", "What has this in its name.", "PART");
    const QCommandLineOption manual("manual", "The pictures of the manual instead.");
    const QCommandLineOption studies("studies", "The panel of studies alone.");
    parser.addOptions({size, theme, language, only, manual, studies});
    parser.process(application);
    const auto spoken = languageFromCode(parser.value(language));
    if (parser.positionalArguments().size() != 1 || !spoken)
        parser.showHelp(2);
    const Translation translation(*spoken);
    if (parser.isSet(manual)) {
        applyThemeChoice(application, ThemeChoice::Light);
        takeManualPictures(parser.positionalArguments().first());
        return 0;
    }
    const QStringList themes =
        parser.isSet(theme) ? parser.values(theme) : QStringList{"light", "dark"};
    const QStringList sizes =
        parser.isSet(size) ? parser.values(size) : QStringList{"1280x800", "1920x1080"};
    for (const QString& one : themes) {
        const ThemeChoice choice = one == "dark" ? ThemeChoice::Dark : ThemeChoice::Light;
        keepThemeChoice(choice); // the menu goes back to it after each of its rows
        applyThemeChoice(application, choice);
        for (const QString& pixels : sizes)
            fill(parser.isSet(studies) ? showStudies : showEverything,
                 parser.positionalArguments().first(), one,
                 QSize(pixels.section('x', 0, 0).toInt(), pixels.section('x', 1).toInt()),
                 parser.value(only));
    }
    return 0;
}
