// Lists the work that a crash left behind, and asks which of it is to be opened.
//
// KeptWork opens it when the window is on the screen. Opening is done by the caller; deleting is
// done here, at once, after a question. What is neither opened nor deleted is asked about again at
// the next start.
#pragma once

#include "document/rescue.h"

#include <QDialog>

#include <optional>

class QPushButton;
class QTreeWidget;

namespace ripstop {

class RescueDialog final : public QDialog
{
    Q_OBJECT

public:
    RescueDialog(const QList<Rescue>& found, QWidget* parent);

    std::optional<Rescue> chosen() const;

private:
    void fill();
    void keepCurrent();
    void removeChosen();

    QList<Rescue> m_found;
    QTreeWidget* m_table;
    QPushButton* m_open;
    QPushButton* m_delete;
};

} // namespace ripstop
