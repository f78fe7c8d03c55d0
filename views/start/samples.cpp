#include "start/samples.h"

#include "scene/property.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

namespace ripstop {
namespace {

constexpr int generations = 4; // from build/release/bin up to the source tree, and one to spare
constexpr qint64 longest = 64 * 1024 * 1024; // bytes; a sample is far shorter

QString suffix() { return QStringLiteral(".ripstop.json"); }

// A text of a scene's settings. The file is not read as a scene, because that takes long.
template <auto member>
QString textIn(const QJsonObject& settings)
{
    const std::string_view key = propertyOf<member>().key;
    return settings.value(QLatin1String(key.data(), qsizetype(key.size()))).toString();
}

} // namespace

QString samplesFolder()
{
    const QDir program(QCoreApplication::applicationDirPath());
    QStringList places{QStringLiteral("scenes"), QStringLiteral("../share/ripstop/scenes")};
    for (int up = 1; up <= generations; ++up)
        places << QStringLiteral("../").repeated(up) + QStringLiteral("scenes");
    for (const QString& place : places) {
        const QString folder = QDir::cleanPath(program.filePath(place));
        if (!sampleFiles(folder).isEmpty())
            return folder;
    }
    return {};
}

QStringList sampleFiles(const QString& folder)
{
    QStringList files;
    if (folder.isEmpty())
        return files;
    const QDir dir(folder);
    for (const QString& name : dir.entryList({QChar('*') + suffix()}, QDir::Files, QDir::Name))
        files << dir.filePath(name);
    return files;
}

bool isSample(const QString& file)
{
    const QString folder = samplesFolder();
    return !folder.isEmpty()
           && QFileInfo(file).canonicalPath() == QFileInfo(folder).canonicalFilePath();
}

Sample readSample(const QString& file)
{
    Sample sample;
    sample.file = file;
    sample.name = QFileInfo(file).fileName();
    if (sample.name.endsWith(suffix()))
        sample.name.chop(suffix().size());

    QFile source(file);
    QJsonObject settings;
    if (source.size() < longest && source.open(QIODevice::ReadOnly))
        settings = QJsonDocument::fromJson(source.readAll())
                       .object()
                       .value(QStringLiteral("settings"))
                       .toObject();
    sample.title = textIn<&Settings::title>(settings);
    sample.note = textIn<&Settings::notes>(settings).section('\n', 0, 0);
    if (sample.title.isEmpty() && !sample.name.isEmpty()) {
        sample.title = QString(sample.name).replace('_', ' ');
        sample.title[0] = sample.title.at(0).toUpper();
    }
    return sample;
}

QPixmap pictureOf(const Sample& sample)
{
    return QPixmap(QStringLiteral(":/samples/%1.png").arg(sample.name));
}

} // namespace ripstop
