// ripstop-cli, called as scripts call it.
#pragma once

#include "model/files.h"

#include <QByteArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <QtTest>

namespace ripstop {

struct Outcome
{
    int exitCode = -1;
    QByteArray out;
    QString error;

    QJsonObject json() const { return QJsonDocument::fromJson(out).object(); }
};

inline Outcome call(const QStringList& arguments)
{
    QProcess process;
    process.start(CLI_PROGRAM, arguments);
    if (!process.waitForFinished(120000))
        return {-1, {}, process.errorString()};
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -2,
            process.readAllStandardOutput(), QString(process.readAllStandardError())};
}

inline QString scene(const char* name) { return QString(SCENES_DIR "/%1.ripstop.json").arg(name); }

} // namespace ripstop
