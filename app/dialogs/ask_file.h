#pragma once

#include <QString>

class QWidget;

namespace ripstop {

// Asks where to write. A name without an ending gets `suffix` ("png") before the dialog asks
// whether an existing file may be replaced. Empty when the user thinks better of it.
QString askWhereToSave(QWidget* parent, const QString& title, const QString& suggested,
                       const QString& filter, const QString& suffix);

} // namespace ripstop
