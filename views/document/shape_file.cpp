#include "document/shape_file.h"

#include "derived/collider_shape.h"
#include "document/document.h"
#include "document/words.h"

#include <QDir>
#include <QFileDialog>

namespace ripstop {

QString askShapeFile(QWidget* parent, const Document& document, ColliderShape shape)
{
    const bool isMesh = rowOf(shape).madeOf == MadeOf::Triangles;
    const QString folder = QString::fromStdString(document.scene().folder.path);
    const QString file = QFileDialog::getOpenFileName(
        parent, isMesh ? words("Choose a mesh") : words("Choose a picture of heights"), folder,
        isMesh ? words(
            "Meshes (*.obj *.stl *.ply *.gltf *.glb *.dae *.off *.vtp *.vtu);;All files (*)")
               : words("Pictures (*.png *.pgm);;All files (*)"));
    return file.isEmpty() ? file : namedFrom(folder, file);
}

QString askPictureFile(QWidget* parent, const Document& document)
{
    const QString folder = QString::fromStdString(document.scene().folder.path);
    const QString file =
        QFileDialog::getOpenFileName(parent, words("Choose a picture for the fabric"), folder,
                                     words("Pictures (*.png *.jpg *.jpeg);;All files (*)"));
    return file.isEmpty() ? file : namedFrom(folder, file);
}

QString namedFrom(const QString& folder, const QString& file)
{
    if (folder.isEmpty())
        return file;
    const QString relative = QDir(QDir(folder).absolutePath()).relativeFilePath(file);
    return relative.startsWith(QStringLiteral("..")) ? file : relative;
}

} // namespace ripstop
