// The sample scenes that come with the program.
#pragma once

#include <QPixmap>
#include <QString>
#include <QStringList>

namespace ripstop {

struct Sample
{
    QString file;
    QString name;  // "delta_kite", from the file's name
    QString title; // from the scene's settings, or made from the name
    QString note;  // the first line of the scene's notes
};

// The folder of the samples: "scenes" beside the program, where an installation puts them, or in
// the source tree that the program was built in. Empty when there is none.
QString samplesFolder();

QStringList sampleFiles(const QString& folder = samplesFolder()); // in order of name
bool isSample(const QString& file);

// Reads no more of the scene than its title and its notes. A file that cannot be read still has a
// name and a title.
Sample readSample(const QString& file);

// The picture of a sample, or nothing when it has none.
QPixmap pictureOf(const Sample& sample);

} // namespace ripstop
