#include "viewport/tool_strip.h"

#include <QAction>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

namespace ripstop {
namespace {

constexpr int inset = 4;     // pixels
constexpr int iconSide = 20; // pixels
constexpr int rounding = 8;  // pixels
constexpr int gap = 3;       // pixels, on either side of a line between groups

} // namespace

ToolStrip::ToolStrip(QWidget* parent)
    : QFrame(parent)
    , m_column(new QVBoxLayout(this))
{
    m_column->setContentsMargins(inset, inset, inset, inset);
    m_column->setSpacing(2);
    setCursor(Qt::ArrowCursor);
}

void ToolStrip::addGroup(const QList<QAction*>& actions)
{
    if (m_column->count() > 0) {
        m_column->addSpacing(2 * gap);
    }
    for (QAction* action : actions) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setIconSize(QSize(iconSide, iconSide));
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::NoFocus); // keys stay with the view
        m_column->addWidget(button);
    }
    adjustSize();
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
    for (int i = 0; i < m_column->count(); ++i)
        if (QLayoutItem* item = m_column->itemAt(i); item->spacerItem())
            painter.fillRect(rounding, item->geometry().center().y(), width() - 2 * rounding, 1,
                             line);
}

} // namespace ripstop
