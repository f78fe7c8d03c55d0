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

void select(const QString& name, const Document& document, Selection& selection)
{
    for (const Entry& entry : document.scene().items)
        if (nameOf(entry.item) == name.toStdString())
            return selection.set({entry.id});
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
    Selection selection(document);
    Player player(document);
    const bool stays = options->screenshot.isEmpty();
    MainWindow window(document, selection, player,
                      stays ? MainWindow::Memory::Keep : MainWindow::Memory::Ignore);
    if (options->size)
        window.resize(*options->size);
    if (!options->scene.isEmpty())
        window.showScene();
    window.viewport().setColorBy(options->colorBy);
    select(options->select, document, selection);
    window.show();

    std::optional<Screenshot> screenshot;
    if (!stays)
        screenshot.emplace(*options, window, player);
    return QApplication::exec();
}
