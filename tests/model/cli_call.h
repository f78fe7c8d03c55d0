// Calls ripstop-cli as scripts call it, in a process of its own, and gives back exit code, output
// and error text; JSON output can be read as an object.
//
// A call that cannot be started or takes longer than two minutes has the exit code -1, a crash has
// -2. scene() names a file of the sample scenes.
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
