#include "document/ask_file.h"

#include <QFileDialog>
#include <QFileInfo>

namespace ripstop {

QString askWhereToSave(QWidget* parent, const QString& title, const QString& suggested,
                       const QString& filter, const QString& suffix)
{
    QFileDialog dialog(parent, title, QFileInfo(suggested).path(), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(QFileInfo(suggested).fileName());
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

} // namespace ripstop
