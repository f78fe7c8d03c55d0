// addGroup() makes a button for each action. arrange() then places all groups: below each other
// with a line between them, and in a new column where a group, or a single button of a long one,
// has no room in the height of the view. paintEvent() paints the card and the lines.
#include "tools/tool_strip.h"

#include <QAction>
#include <QEvent>
#include <QPainter>
#include <QToolButton>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int inset = 4;     // pixels
constexpr int iconSide = 20; // pixels
constexpr int rounding = 8;  // pixels
constexpr int between = 2;   // pixels, of two buttons
constexpr int gap = 3;       // pixels, on either side of a line between groups
constexpr int apart = 12;    // pixels, from the strip to what stands beside it

} // namespace

ToolStrip::ToolStrip(QWidget* view)
    : QFrame(view)
{
    setCursor(Qt::ArrowCursor);
    view->installEventFilter(this);
}

void ToolStrip::addGroup(const QList<QAction*>& actions)
{
    QList<QToolButton*> group;
    for (QAction* action : actions) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setIconSize(QSize(iconSide, iconSide));
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::NoFocus); // keys stay with the view
        group.push_back(button);
    }
    m_groups.push_back(group);
    arrange();
}

bool ToolStrip::eventFilter(QObject*, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        arrange();
    return false;
}

void ToolStrip::moveEvent(QMoveEvent* event)
{
    QFrame::moveEvent(event);
    arrange();
}

void ToolStrip::arrange()
{
    const int room = parentWidget()->height() - 2 * y() - inset;
    int left = inset, top = inset, right = inset, bottom = inset;
    const auto startColumn = [&] {
        left = right + between;
        top = inset;
    };
    m_lines.clear();
    for (const QList<QToolButton*>& group : m_groups) {
        int tall = 0;
        for (const QToolButton* button : group)
            tall += button->sizeHint().height() + between;
        if (top > inset && top + 2 * gap + tall > room) {
            startColumn();
        } else if (top > inset) {
            m_lines.push_back({left, top + gap - 1, right - left, 1});
            top += 2 * gap;
        }
        for (QToolButton* button : group) {
            const QSize size = button->sizeHint();
            if (top > inset && top + size.height() > room)
                startColumn();
            button->setGeometry({{left, top}, size});
            right = std::max(right, left + size.width());
            bottom = std::max(bottom, top + size.height());
            top += size.height() + between;
        }
    }
    resize(right + inset, bottom + inset);
    update();
}

void ToolStrip::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor card = palette().color(QPalette::Window);
    card.setAlphaF(0.86F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(card);
    painter.drawRoundedRect(rect(), rounding, rounding);

    QColor line = palette().color(QPalette::WindowText);
    line.setAlphaF(0.25F);
    for (const QRect& place : m_lines)
        painter.fillRect(place, line);
}

int besideTools(const QWidget& view, const QRect& place)
{
    for (const QObject* child : view.children())
        if (const auto* tools = qobject_cast<const ToolStrip*>(child);
            tools && tools->isVisible() && tools->geometry().intersects(place))
            return tools->geometry().right() + apart;
    return place.x();
}

} // namespace ripstop
