// The program of the editor: it reads the command line and puts document, selection, player and
// window together.
//
// Stages: questions such as --help are answered without a window; then the surface format is set,
// which VTK needs before the application exists; then language, arguments and theme; then whether
// there is a display with OpenGL; then the scene and what is to be selected. A mistake ends the
// program with a sentence and an exit code of docs/command-line.md before a window appears. A
// recording is read with its design then, and shown once the window is there. Document, selection,
// player and window stand on the stack in this order, so that the window goes first. What asks
// questions of its own (kept work, a mesh, an action) is queued until the event loop runs.
#include "base/program_version.h"
#include "document/document.h"
#include "document/measurement.h"
#include "document/player.h"
#include "document/recordings.h"
#include "document/rescue.h"
#include "document/selection.h"
#include "document/words.h"
#include "editor/allocator_settings.h"
#include "editor/display_check.h"
#include "editor/end_signals.h"
#include "editor/main_window.h"
#include "editor/options.h"
#include "editor/screenshot.h"
#include "editor/table_texts.h"
#include "editor/window_host.h"
#include "files/arrivals.h"
#include "files/kept_work.h"
#include "files/run_files.h"
#include "icons/icon.h"
#include "language/language.h"
#include "look/scene_frame.h"
#include "study/study.h"
#include "study/study_panel.h"
#include "viewport/viewport.h"

#include <QAction>
#include <QApplication>
#include <QSurfaceFormat>

#include <algorithm>
#include <clocale>
#include <cstdio>
#include <optional>
#include <span>
#include <string_view>

using namespace ripstop;

namespace {

// Qt takes over the locale of the session, and with it the comma that numbers of shaders, files and
// messages would get. What the screen shows is written by QLocale, which does not ask here.
void keepDecimalPoint() { std::setlocale(LC_NUMERIC, "C"); }

int refuse(const QString& message, int exitCode)
{
    std::fprintf(stderr, "ripstop: %s\n", qPrintable(message));
    return exitCode;
}

// Returns nothing when no item has that name.
std::vector<Id> itemCalled(const QString& name, const Scene& scene)
{
    for (const Entry& entry : scene.items)
        if (!name.isEmpty() && nameOf(entry.item) == name.toStdString())
            return {entry.id};
    return {};
}

// Finds an item by its name, or all elements that meet a condition in the design.
Result<std::vector<Id>> meant(const QString& text, const Scene& scene)
{
    if (text.isEmpty())
        return std::vector<Id>();
    if (std::vector<Id> item = itemCalled(text, scene); !item.empty())
        return item;
    const auto ids = matching(scene, measurementOf(sceneFrame(scene)), text.toStdString());
    if (!ids)
        return Failure("no item of the scene is called \"%1\", and it is no condition: %2",
                       text.toStdString(), ids.message());
    return ids;
}

std::optional<Failure> openSceneOfStudy(Document& document, const QString& file)
{
    const auto study = readStudy(pathOf(file));
    if (!study)
        return study.failure();
    return document.open(QString::fromStdString((study->folder / study->scene).string()));
}

// Opens what is named on the command line, if anything is; of a recording its design, as the
// recording itself needs a window to be shown in.
std::optional<Failure> openNamed(Document& document, const QString& file,
                                 std::optional<OpenedRecording>& recording)
{
    if (file.isEmpty())
        return std::nullopt;
    if (StudyPanel::isStudy(file))
        return openSceneOfStudy(document, file);
    if (!RunFiles::isRecording(file))
        return document.open(file);
    auto opened = RunFiles::openDesign(document, file);
    if (!opened)
        return opened.failure();
    recording = std::move(*opened);
    return std::nullopt;
}

// Whether the command line only asks what needs no window. Such questions are answered also where
// no window can be opened.
bool asksOnly(int argc, char** argv)
{
    const std::span<char*> arguments(argv, std::size_t(argc));
    return std::any_of(arguments.begin(), arguments.end(), [](std::string_view one) {
        return one == "-h" || one == "--help" || one == "--help-all" || one == "-v"
               || one == "--version" || one == "--table-texts";
    });
}

} // namespace

int main(int argc, char** argv)
{
    QCoreApplication::setApplicationName("Ripstop");
    QCoreApplication::setOrganizationName("Ripstop");
    QGuiApplication::setDesktopFileName("org.ripstop.Ripstop"); // resources/desktop
    QCoreApplication::setApplicationVersion(QString::fromStdString(programVersion()));
    QString error;
    if (asksOnly(argc, argv)) {
        const QCoreApplication asked(argc, argv);
        keepDecimalPoint();
        if (asked.arguments().contains("--table-texts")) // for scripts/translations
            return std::puts(qPrintable(tableTexts().join('\n'))) < 0;
        const Translation translation(keptLanguage());
        (void)readOptions(asked.arguments(), error); // prints the answer and ends the program
    }

    setUpAllocator();
    QSurfaceFormat format; // has to be set before the application exists
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);

    auto check = std::make_optional<DisplayCheck>();
    QApplication application(argc, argv);
    keepDecimalPoint();
    check.reset();
    QApplication::setWindowIcon(applicationIcon());
    Translation translation(keptLanguage());

    const std::optional<Options> options = readOptions(application.arguments(), error);
    if (!options)
        return refuse(error, 2);
    applyThemeChoice(application, options->appearance.value_or(keptThemeChoice()));
    if (options->language)
        translation.install(*options->language);
    const bool stays = options->screenshot.isEmpty();
    if (const QString lack = lackOfOpenGl(); !lack.isEmpty()) {
        if (stays)
            showLack(lack);
        return refuse(lack, noDisplay);
    }

    Document document;
    std::optional<OpenedRecording> recording;
    if (const auto failure = openNamed(document, options->scene, recording))
        return refuse(translated(failure->message), 1);
    if (!options->fit.isEmpty() && itemCalled(options->fit, document.scene()).empty())
        return refuse(QString("no item of the scene is called \"%1\"").arg(options->fit), 1);
    const Result<std::vector<Id>> selected = meant(options->select, document.scene());
    if (!selected)
        return refuse(QString::fromStdString(selected.message().english()), 1);
    Selection selection(document);
    Player player(document);
    WindowHost host(document, selection, player,
                    stays ? MainWindow::Memory::Keep : MainWindow::Memory::Ignore, translation);
    MainWindow& window = host.window(); // as long as no event is handled
    if (options->size)
        window.resize(*options->size);
    if (!options->scene.isEmpty())
        window.showScene();
    if (StudyPanel::isStudy(options->scene))
        window.openStudy(options->scene);
    if (options->viewOnly)
        window.showViewOnly();
    window.viewport().setColorBy(options->colorBy);
    if (recording)
        window.docks().show("timeline");
    for (const QString& dock : options->docks)
        if (!window.docks().show(dock))
            return refuse(QString("no panel is called \"%1\"").arg(dock), 1);
    selection.set(*selected);
    window.show();

    const EndSignals ends([&](int signal) {
        host.window().keptWork().leave();
        QApplication::exit(128 + signal);
    });
    if (recording) // queued, because it may have to be said that it is damaged
        QMetaObject::invokeMethod(
            &host,
            [&] {
                host.window().runFiles().show(*recording, options->scene);
                if (stays && options->play)
                    host.window().recordings().play();
            },
            Qt::QueuedConnection);
    std::optional<Screenshot> screenshot;
    if (!stays)
        screenshot.emplace(*options, itemCalled(options->fit, document.scene()), window, player);
    else if (options->play && !recording)
        player.play();
    if (stays)
        QMetaObject::invokeMethod(
            &host, [&] { host.window().keptWork().keepIn(rescueFolder()); }, Qt::QueuedConnection);
    if (!options->mesh.isEmpty()) // queued, because the dialog needs the window below it
        QMetaObject::invokeMethod(
            &host, [&] { host.window().arrivals().importMesh(options->mesh); },
            Qt::QueuedConnection);
    if (!options->action.isEmpty()) {
        QAction* action = window.actions().find(options->action);
        if (!action)
            return refuse(QString("no action is called \"%1\"").arg(options->action), 1);
        QMetaObject::invokeMethod(action, &QAction::trigger, Qt::QueuedConnection);
    }
    return QApplication::exec();
}
