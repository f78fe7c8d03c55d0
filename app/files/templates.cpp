#include "files/templates.h"

#include "io/scene_file.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUrl>

namespace ripstop {
namespace {

QString ending()
{
    return QString::fromLatin1(sceneExtension.data(), qsizetype(sceneExtension.size()));
}

QDir folder()
{
    return {QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation))
                .filePath("templates")};
}

} // namespace

QStringList templateFiles()
{
    QStringList files;
    for (const QFileInfo& file : folder().entryInfoList({"*" + ending()}, QDir::Files, QDir::Name))
        files << file.absoluteFilePath();
    return files;
}

// A name may hold characters that the name of a file may not; they become hyphens.
QString templateFile(const QString& name)
{
    QString safe = name;
    for (const char sign : {'/', '\\', ':', '*', '?', '"', '<', '>', '|'})
        safe.replace(QLatin1Char(sign), QLatin1Char('-'));
    return folder().filePath(safe + ending());
}

QString templateName(const QString& file) { return QFileInfo(file).fileName().remove(ending()); }

void showTemplateFolder()
{
    QDir().mkpath(folder().path());
    QDesktopServices::openUrl(QUrl::fromLocalFile(folder().path()));
}

} // namespace ripstop
