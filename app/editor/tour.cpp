// Stages: the constructor builds the bubble, covers the window and goes to the first stop. goTo()
// finds the next visible stop in the direction of travel and fills the bubble; arrange() puts the
// bubble beside the place, where there is room, or inside it. paintEvent() shades what is around
// the place. The event filter follows the size of the window and takes keys before shortcuts and
// controls of the scene get them.
#include "editor/tour.h"

#include <QApplication>
#include <QFrame>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int leastWidth = 360; // px, of the bubble
constexpr int gap = 12;         // px, between a place and its bubble
constexpr QColor shade(0, 0, 0, 120);

} // namespace

Tour::Tour(std::vector<TourStop> stops, QWidget* window)
    : QWidget(window)
    , m_stops(std::move(stops))
    , m_bubble(new QFrame(this))
    , m_title(new QLabel)
    , m_text(new QLabel)
    , m_count(new QLabel)
    , m_back(new QPushButton(tr("&Back", "to the stop before")))
    , m_next(new QPushButton)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setFocusPolicy(Qt::StrongFocus);
    QFont large = font();
    large.setPointSizeF(1.2 * large.pointSizeF());
    large.setWeight(QFont::DemiBold);
    m_title->setFont(large);
    m_text->setWordWrap(true);
    m_count->setForegroundRole(QPalette::PlaceholderText);
    auto* end = new QPushButton(tr("&End the tour"));
    m_next->setDefault(true);
    connect(m_back, &QPushButton::clicked, this, [this] { goTo(m_stop - 1); });
    connect(m_next, &QPushButton::clicked, this, [this] { goTo(m_stop + 1); });
    connect(end, &QPushButton::clicked, this, &QWidget::close);

    m_bubble->setFrameShape(QFrame::StyledPanel);
    m_bubble->setAutoFillBackground(true);
    m_bubble->setBackgroundRole(QPalette::Base);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_count);
    buttons->addStretch(1);
    buttons->addWidget(end);
    buttons->addWidget(m_back);
    buttons->addWidget(m_next);
    auto* layout = new QVBoxLayout(m_bubble);
    layout->setContentsMargins(16, 14, 16, 12);
    layout->setSpacing(10);
    layout->addWidget(m_title);
    layout->addWidget(m_text);
    layout->addLayout(buttons);

    window->installEventFilter(this);
    qApp->installEventFilter(this);
    resize(window->size());
    show();
    raise();
    setFocus();
    goTo(0);
}

void Tour::goTo(int stop)
{
    const int step = stop < m_stop ? -1 : 1;
    while (stop >= 0 && stop < int(m_stops.size())
           && (!m_stops[std::size_t(stop)].place || !m_stops[std::size_t(stop)].place->isVisible()))
        stop += step; // passes over panels that the user has closed
    if (stop >= int(m_stops.size())) {
        close();
        return;
    }
    if (stop < 0)
        return;
    m_stop = stop;
    m_title->setText(m_stops[std::size_t(stop)].title);
    m_text->setText(m_stops[std::size_t(stop)].text);
    m_count->setText(tr("%1 of %2").arg(stop + 1).arg(m_stops.size()));
    m_back->setEnabled(stop > 0);
    m_next->setText(stop + 1 == int(m_stops.size()) ? tr("&Done") : tr("&Next"));
    arrange();
}

QRect Tour::place() const
{
    const QWidget* widget = m_stop < 0 ? nullptr : m_stops[std::size_t(m_stop)].place.data();
    if (!widget)
        return {};
    return {widget->mapTo(parentWidget(), QPoint(0, 0)), widget->size()};
}

// Puts the bubble beside the place where there is room, and inside it elsewhere.
void Tour::arrange()
{
    QLayout& inside = *m_bubble->layout();
    inside.activate(); // with the words of this stop
    const int width = std::max(leastWidth, inside.totalMinimumSize().width()); // languages differ
    m_bubble->setFixedSize(width, inside.totalHeightForWidth(width));
    const QRect at = place();
    const QSize size = m_bubble->size();
    const QRect room = rect().adjusted(gap, gap, -gap, -gap);
    const bool isBelow = at.bottom() + gap + size.height() < room.bottom();
    QPoint corner = at.center() - QPoint(size.width() / 2, size.height() / 2);
    if (isBelow && at.height() < size.height()) // the place is a bar
        corner = {at.left() + gap, at.bottom() + gap};
    else if (at.right() + gap + size.width() < room.right())
        corner = {at.right() + gap, at.top() + gap};
    else if (at.left() - gap - size.width() > room.left())
        corner = {at.left() - gap - size.width(), at.top() + gap};
    else if (isBelow)
        corner = {at.left() + gap, at.bottom() + gap};
    else if (at.top() - gap - size.height() > room.top())
        corner = {at.left() + gap, at.top() - gap - size.height()};
    corner.setX(
        std::clamp(corner.x(), room.left(), std::max(room.left(), room.right() - size.width())));
    corner.setY(
        std::clamp(corner.y(), room.top(), std::max(room.top(), room.bottom() - size.height())));
    m_bubble->move(corner);
    update();
}

void Tour::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath around;
    around.addRect(rect());
    QPainterPath bright;
    bright.addRoundedRect(place(), 4, 4);
    painter.fillPath(around.subtracted(bright), shade);
    painter.setPen(QPen(palette().highlight(), 2));
    painter.drawPath(bright);
}

bool Tour::take(int key)
{
    switch (key) {
    case Qt::Key_Escape:
        close();
        return true;
    case Qt::Key_Left:
    case Qt::Key_Backspace:
        goTo(m_stop - 1);
        return true;
    case Qt::Key_Right:
    case Qt::Key_Space:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        goTo(m_stop + 1);
        return true;
    default:
        return false;
    }
}

// A click beside the bubble must not reach what lies below the shade.
void Tour::mousePressEvent(QMouseEvent* event) { event->accept(); }

// Keys are taken here before the controls of the scene, which filter events as well.
bool Tour::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize) {
        resize(parentWidget()->size());
        arrange();
    }
    if (watched == this && event->type() == QEvent::ShortcutOverride)
        event->accept();
    if (watched == this && event->type() == QEvent::KeyPress)
        return take(static_cast<QKeyEvent*>(event)->key());
    return QWidget::eventFilter(watched, event);
}

} // namespace ripstop
