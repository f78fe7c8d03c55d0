#pragma once

#include <QFrame>

class QAction;
class QVBoxLayout;

namespace ripstop {

// The tools of the view and what they take, in a column over its corner.
class ToolStrip final : public QFrame
{
    Q_OBJECT

public:
    explicit ToolStrip(QWidget* parent = nullptr);

    // Below what is there already, with a line between.
    void addGroup(const QList<QAction*>& actions);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QVBoxLayout* m_column;
};

} // namespace ripstop
