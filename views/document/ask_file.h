// Asks for a place to write to. It is used by all that saves or exports; the dialog is modal, and
// the function has to be called on the thread of the window. Nothing is written here.
#pragma once

#include <QString>

class QWidget;

namespace ripstop {

// Asks where to write. A name without an ending gets `suffix` ("png") before the dialog asks
// whether an existing file may be replaced. The name is empty when the user cancels.
QString askWhereToSave(QWidget* parent, const QString& title, const QString& suggested,
                       const QString& filter, const QString& suffix);

} // namespace ripstop
