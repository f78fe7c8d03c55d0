// ripstop-cli, called as scripts call it.
#pragma once

#include <QByteArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QString>
#include <QStringList>

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

} // namespace ripstop
