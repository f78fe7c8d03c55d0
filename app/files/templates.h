// The templates of the user: scene files in a folder of their own, from which new designs begin.
//
// The folder is "templates" among the data of the program; it is made when something is first
// saved or the folder is shown. Files are read and written by files.h; here are only their names
// and places.
#pragma once

#include <QString>
#include <QStringList>

namespace ripstop {

QStringList templateFiles(); // full paths, sorted by name
QString templateFile(const QString& name);
QString templateName(const QString& file);
void showTemplateFolder(); // in the desktop's file manager

} // namespace ripstop
