// Each way in has a dialog, and afterwards the view goes to what has come: to its fabric, where it
// has some.
#include "files/arrivals.h"

#include "dialogs/builder_dialog.h"
#include "document/document.h"
#include "document/selection.h"
#include "files/files.h"
#include "import/import_dialog.h"
#include "look/subject.h"
#include "tools/transform_tool.h"
#include "viewport/viewport.h"

#include <QDir>
#include <QFileInfo>

#include <utility>

namespace ripstop {

Arrivals::Arrivals(Document& document, Selection& selection, Viewport& viewport, Files& files,
                   std::function<bool()> isOpen, QWidget& window)
    : QObject(&window)
    , m_document(document)
    , m_selection(selection)
    , m_viewport(viewport)
    , m_files(files)
    , m_isOpen(std::move(isOpen))
    , m_window(window)
{}

void Arrivals::startFrom(const QString& builder)
{
    if (!m_files.mayDiscard())
        return;
    BuilderDialog dialog(builder, &m_window);
    if (dialog.exec() != QDialog::Accepted)
        return;
    Scene scene = dialog.scene();
    const QString title = QString::fromStdString(scene.settings.title);
    m_document.replace(std::move(scene), title);
    emit opened();
}

// A dialog that is dismissed has changed nothing: a run that is shown goes on, and the camera is
// only moved back where a preview has moved it, since it may follow what flies meanwhile.
void Arrivals::insert(const QString& builder)
{
    if (!m_isOpen())
        return startFrom(builder);
    const Camera before = m_viewport.camera();
    bool hasMoved = false;
    BuilderDialog dialog(builder,
                         {.document = m_document,
                          .selection = m_selection,
                          .focus = before.focus,
                          .showsRun = !m_viewport.transformTool().isAtDesign()},
                         &m_window);
    connect(&dialog, &BuilderDialog::shown, &m_viewport,
            [this, &dialog, &hasMoved](const std::vector<Id>& bodies) {
                m_viewport.fit(subjectOf(m_document.scene(), bodies), dialog.frameGeometry());
                hasMoved = true;
            });
    if (dialog.exec() == QDialog::Rejected) {
        if (hasMoved)
            m_viewport.look(before);
    } else {
        m_viewport.fit(
            subjectOf(m_document.scene(),
                      m_selection.ids())); // with all of the view, now that the dialog is gone
    }
}

void Arrivals::importMesh(const QString& file)
{
    const bool isNew = !m_isOpen();
    const QString folder =
        m_document.file().isEmpty() ? QString() : QFileInfo(m_document.file()).path();
    const QString mesh = file.isEmpty() ? ImportDialog::askFile(&m_window, folder) : file;
    if (mesh.isEmpty() || (isNew && !m_files.mayDiscard()))
        return;
    const Scene empty;
    ImportDialog dialog(isNew ? empty : m_document.scene(), mesh, &m_window);
    if (dialog.exec() != QDialog::Accepted)
        return;
    if (isNew) {
        m_document.replace(Scene{}, QFileInfo(dialog.file()).completeBaseName());
        emit opened();
    }
    m_document.push(dialog.result().edit);
    m_selection.set(dialog.result().parts);
    m_viewport.fit(dialog.result().parts);
    emit said(tr("Imported %1. Pin what is to be held: nothing holds it yet.")
                  .arg(QDir::toNativeSeparators(dialog.file())));
}

} // namespace ripstop
