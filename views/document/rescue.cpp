#include "document/rescue.h"

#include "io/scene_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>
#include <QStandardPaths>

#include <algorithm>

namespace ripstop {
namespace {

QString sceneEnding()
{
    return QString::fromLatin1(sceneExtension.data(), qsizetype(sceneExtension.size()));
}

QJsonObject read(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                          : QJsonObject();
}

bool isHeld(const RescuePlace& place)
{
    QLockFile lock(place.lock());
    lock.setStaleLockTime(0); // held as long as its program lives, however long that is
    return !lock.tryLock();
}

} // namespace

QString RescuePlace::scene() const { return QDir(folder).filePath(name + sceneEnding()); }
QString RescuePlace::about() const { return QDir(folder).filePath(name + ".about"); }
QString RescuePlace::lock() const { return QDir(folder).filePath(name + ".lock"); }

void RescuePlace::remove() const
{
    QFile::remove(scene());
    QFile::remove(about());
}

bool Rescue::isOlderThanFile() const
{
    return !file.isEmpty() && QFileInfo(file).lastModified() > written;
}

QString rescueFolder()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation))
        .filePath("unsaved");
}

QList<Rescue> leftBehind(const QString& folder)
{
    QList<Rescue> found;
    const QDir dir(folder);
    for (const QFileInfo& scene : dir.entryInfoList({"*" + sceneEnding()}, QDir::Files)) {
        const RescuePlace place{folder, scene.fileName().chopped(sceneEnding().size())};
        if (isHeld(place))
            continue;
        const QJsonObject about = read(place.about());
        const QString title = about["title"].toString();
        found << Rescue{place, about["file"].toString(), title.isEmpty() ? place.name : title,
                        scene.lastModified()};
    }
    std::ranges::stable_sort(
        found, [](const Rescue& a, const Rescue& b) { return a.written > b.written; });
    return found;
}

} // namespace ripstop
