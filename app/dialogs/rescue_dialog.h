#pragma once

#include "document/rescue.h"

#include <QDialog>

#include <optional>

class QPushButton;
class QTreeWidget;

namespace ripstop {

// Shows the work that was left behind, and which of it is to be opened. What is neither opened nor
// deleted is asked about again next time.
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
