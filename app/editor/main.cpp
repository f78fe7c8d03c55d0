#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "editor/main_window.h"
#include "editor/options.h"
#include "editor/screenshot.h"
#include "icons/icon.h"
#include "viewport/viewport.h"

#include <QApplication>
#include <QSurfaceFormat>

#include <cstdio>

using namespace ripstop;

namespace {

int refuse(const QString& message, int exitCode)
{
    std::fprintf(stderr, "ripstop: %s\n", qPrintable(message));
    return exitCode;
}

// Nothing when no item is called so.
std::vector<Id> itemCalled(const QString& name, const Scene& scene)
{
    for (const Entry& entry : scene.items)
        if (!name.isEmpty() && nameOf(entry.item) == name.toStdString())
            return {entry.id};
    return {};
}

} // namespace

int main(int argc, char** argv)
{
    QSurfaceFormat format; // before the application exists
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);

    QApplication application(argc, argv);
    QApplication::setApplicationName("Ripstop");
    QApplication::setOrganizationName("Ripstop");
    QApplication::setApplicationVersion(RIPSTOP_VERSION);
    QApplication::setWindowIcon(applicationIcon());

    QString error;
    const std::optional<Options> options = readOptions(application.arguments(), error);
    if (!options)
        return refuse(error, 2);
    applyAppearance(application, options->appearance);

    Document document;
    if (!options->scene.isEmpty())
        if (const auto failure = document.open(options->scene))
            return refuse(QString::fromStdString(failure->message), 1);
    for (const QString& name : {options->select, options->fit})
        if (!name.isEmpty() && itemCalled(name, document.scene()).empty())
            return refuse(QString("no item of the scene is called \"%1\"").arg(name), 1);
    Selection selection(document);
    Player player(document);
    const bool stays = options->screenshot.isEmpty();
    MainWindow window(document, selection, player,
                      stays ? MainWindow::Memory::Keep : MainWindow::Memory::Ignore);
    if (options->size)
        window.resize(*options->size);
    if (!options->scene.isEmpty())
        window.showScene();
    if (options->viewOnly)
        window.showViewOnly();
    window.viewport().setColorBy(options->colorBy);
    selection.set(itemCalled(options->select, document.scene()));
    window.show();

    std::optional<Screenshot> screenshot;
    if (!stays)
        screenshot.emplace(*options, itemCalled(options->fit, document.scene()), window, player);
    else if (options->play)
        player.play();
    if (!options->mesh.isEmpty()) // once the window is there to ask over
        QMetaObject::invokeMethod(
            &window, [&] { window.importMesh(options->mesh); }, Qt::QueuedConnection);
    return QApplication::exec();
}
