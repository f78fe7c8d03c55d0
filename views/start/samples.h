// The sample scenes that come with the program: where they are, what they are called, and their
// pictures. A missing folder or file is no error: lists are empty, and a sample that cannot be read
// still has a name. The functions read files, and pictures need the window's thread, as any QPixmap
// does.
#pragma once

#include <QPixmap>
#include <QString>
#include <QStringList>

namespace ripstop {

// What the start page shows of one sample.
struct Sample
{
    QString file;  // its path
    QString name;  // "delta_kite", from the file's name
    QString title; // from the scene's settings, or made from the name
    QString note;  // the first line of the scene's notes
};

// The folder of the samples: "scenes" beside the program, where an installation puts them, or in
// the source tree that the program was built in. Empty when there is none.
QString samplesFolder();

QStringList sampleFiles(const QString& folder = samplesFolder()); // in order of name
bool isSample(const QString& file); // whether it lies in samplesFolder()

// Reads no more of the scene than its title and its notes. A file that cannot be read still has a
// name and a title.
Sample readSample(const QString& file);

// The picture of a sample, or nothing when it has none.
QPixmap pictureOf(const Sample& sample);

} // namespace ripstop
