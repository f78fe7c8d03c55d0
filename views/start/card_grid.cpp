// The cards keep their order and their size; only the number of columns depends on the width, and
// with it the height that the layout is told (heightForWidth). place() sets them out after each
// change of size. eventFilter() sees the keys of all cards before they do, to move the focus by one
// card or by one row.
#include "start/card_grid.h"

#include "start/card.h"

#include <QKeyEvent>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int gap = 14; // px

} // namespace

CardGrid::CardGrid(QWidget* parent)
    : QWidget(parent)
{
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void CardGrid::add(Card* card)
{
    card->setParent(this);
    card->installEventFilter(this);
    card->show();
    m_cards.push_back(card);
    place();
    updateGeometry();
}

int CardGrid::columns(int width) const
{
    return std::max(1, (width + gap) / (Card::cardSize(fontMetrics()).width() + gap));
}

int CardGrid::heightForWidth(int width) const
{
    const int perRow = columns(width);
    const int rows = (int(m_cards.size()) + perRow - 1) / perRow;
    return std::max(0, rows * (Card::cardSize(fontMetrics()).height() + gap) - gap);
}

QSize CardGrid::sizeHint() const
{
    const int width = 3 * (Card::cardSize(fontMetrics()).width() + gap) - gap;
    return {width, heightForWidth(width)};
}

QSize CardGrid::minimumSizeHint() const
{
    const QSize one = Card::cardSize(fontMetrics());
    return {one.width(), one.height()};
}

void CardGrid::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    place();
}

void CardGrid::place()
{
    const QSize size = Card::cardSize(fontMetrics());
    const int perRow = columns(width());
    for (int i = 0; i < int(m_cards.size()); ++i)
        m_cards[std::size_t(i)]->setGeometry((i % perRow) * (size.width() + gap),
                                             (i / perRow) * (size.height() + gap), size.width(),
                                             size.height());
}

bool CardGrid::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    const auto found = std::find(m_cards.begin(), m_cards.end(), watched);
    int move = 0;
    switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Left:
        move = -1;
        break;
    case Qt::Key_Right:
        move = +1;
        break;
    case Qt::Key_Up:
        move = -columns(width());
        break;
    case Qt::Key_Down:
        move = +columns(width());
        break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        (*found)->click();
        return true;
    default:
        return QWidget::eventFilter(watched, event);
    }
    const auto next = (found - m_cards.begin()) + move;
    if (next >= 0 && next < std::ptrdiff_t(m_cards.size()))
        m_cards[std::size_t(next)]->setFocus(Qt::TabFocusReason);
    return true;
}

} // namespace ripstop
