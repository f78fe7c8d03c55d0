// Copies of work that is in no file yet, so that a crash costs seconds of it and not hours.
//
// A copy is NAME.ripstop.json with NAME.about beside it, which says whose it is, and NAME.lock,
// which the program that writes it holds. A copy whose lock nobody holds was left behind.
#pragma once

#include <QDateTime>
#include <QList>
#include <QString>

namespace ripstop {

// Where the parts of one copy are.
struct RescuePlace
{
    QString folder;
    QString name;

    QString scene() const;
    QString about() const;
    QString lock() const;
    void remove() const;
};

// Work that was left behind.
struct Rescue
{
    RescuePlace place;
    QString file;  // that it is a later state of; empty: it was never saved
    QString title; // as the window called it
    QDateTime written;

    bool isOlderThanFile() const; // somebody has saved the file since
};

QString rescueFolder(); // of this user

QList<Rescue> leftBehind(const QString& folder); // the newest first

} // namespace ripstop
