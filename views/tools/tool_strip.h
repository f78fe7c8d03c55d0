// The tools of the view and what they take, in a column over its corner.
//
// The buttons show actions of the window, which decide what they do. In a low view the groups that
// have no room below stand beside; the strip arranges itself again whenever the view or its own
// place changes.
#pragma once

#include <QFrame>

class QAction;
class QToolButton;

namespace ripstop {

class ToolStrip final : public QFrame
{
    Q_OBJECT

public:
    explicit ToolStrip(QWidget* view);

    // Adds a group after what is there already, with a line between.
    void addGroup(const QList<QAction*>& actions);

protected:
    bool eventFilter(QObject* view, QEvent* event) override;
    void moveEvent(QMoveEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void arrange();

    QList<QList<QToolButton*>> m_groups;
    QList<QRect> m_lines; // between them
};

// The left edge, in pixels of the view, of what would stand at this place, had the strip of the
// view not come down so far.
int besideTools(const QWidget& view, const QRect& place);

} // namespace ripstop
