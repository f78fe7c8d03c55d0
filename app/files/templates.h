// Designs of the user to begin new ones from: scene files in a folder of their own.
#pragma once

#include <QString>
#include <QStringList>

namespace ripstop {

QStringList templateFiles(); // by name
QString templateFile(const QString& name);
QString templateName(const QString& file);
void showTemplateFolder(); // in the desktop's file manager

} // namespace ripstop
