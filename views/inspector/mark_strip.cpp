// trackX() asks the style where the middle of the handle is at a place of the bar, so that ticks
// stand below it. labels() places names in two rows without overlap, beginning with the mark that
// is nearest to the value; painting, tool tips and clicks use the same places.
#include "inspector/mark_strip.h"

#include "document/plain_text.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ripstop {
namespace {

constexpr int tickHeight = 4;  // px
constexpr int reachOfTick = 5; // px, within which a drag snaps and a click takes
constexpr int gap = 5;         // px, between names
constexpr int rows = 2;        // of names

// The part of a style option that QSlider keeps to itself, by what it tells of itself.
QStyleOptionSlider optionOf(const QSlider& bar)
{
    QStyleOptionSlider option;
    option.initFrom(&bar);
    option.subControls = QStyle::SC_None;
    option.orientation = bar.orientation();
    option.maximum = bar.maximum();
    option.minimum = bar.minimum();
    option.sliderPosition = bar.minimum();
    option.sliderValue = bar.minimum();
    option.state |= QStyle::State_Horizontal;
    return option;
}

} // namespace

MarkStrip::MarkStrip(QSlider& bar, QWidget* parent)
    : QWidget(parent)
    , m_bar(bar)
{
    setMouseTracking(true); // the pointer shows what a click takes
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void MarkStrip::show(std::vector<SliderMark> marks, double value)
{
    m_marks = std::move(marks);
    m_value = value;
    update();
}

int MarkStrip::trackX(double place) const
{
    const QStyleOptionSlider option = optionOf(m_bar);
    const QStyle& style = *m_bar.style();
    const QRect groove =
        style.subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderGroove, &m_bar);
    const QRect handle =
        style.subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, &m_bar);
    const double way = groove.width() - handle.width();
    return m_bar.x() - x() + groove.x() + handle.width() / 2 + int(std::lround(place * way));
}

int MarkStrip::xOf(const SliderMark& mark) const { return trackX(mark.place); }

std::optional<double> MarkStrip::nearTo(int position) const
{
    const double share =
        double(position - m_bar.minimum()) / double(m_bar.maximum() - m_bar.minimum());
    const int x = trackX(share);
    const SliderMark* nearest = nullptr;
    int least = reachOfTick + 1;
    for (const SliderMark& mark : m_marks)
        if (const int way = std::abs(xOf(mark) - x); way < least) {
            least = way;
            nearest = &mark;
        }
    return nearest ? std::optional(nearest->value) : std::nullopt;
}

QFont MarkStrip::smallFont() const
{
    QFont small = font();
    small.setPointSizeF(std::max(0.85 * small.pointSizeF(), 6.5));
    return small;
}

int MarkStrip::nameHeight() const { return QFontMetrics(smallFont()).ascent() + 2; }

QSize MarkStrip::sizeHint() const { return {40, tickHeight + rows * nameHeight()}; }

QSize MarkStrip::minimumSizeHint() const { return sizeHint(); }

// The mark nearest to the value first, then always the one that is farthest from all before it, so
// that the names that find room are spread along the track.
std::vector<std::size_t> MarkStrip::inOrderOfNaming() const
{
    std::vector<std::size_t> rest(m_marks.size());
    std::iota(rest.begin(), rest.end(), std::size_t(0));
    std::vector<std::size_t> order;
    const auto fromValue = [&](std::size_t i) { return std::abs(m_marks[i].value - m_value); };
    const auto fromNamed = [&](std::size_t i) {
        int least = width();
        for (const std::size_t named : order)
            least = std::min(least, std::abs(xOf(m_marks[named]) - xOf(m_marks[i])));
        return -least;
    };
    while (!rest.empty()) {
        const auto next = order.empty() ? std::ranges::min_element(rest, {}, fromValue)
                                        : std::ranges::min_element(rest, {}, fromNamed);
        order.push_back(*next);
        rest.erase(next);
    }
    return order;
}

std::vector<MarkStrip::Label> MarkStrip::labels() const
{
    QFont bold = smallFont();
    bold.setBold(true); // as the widest that it may become
    const QFontMetrics metrics(bold);
    std::vector<Label> labels;
    for (const std::size_t i : inOrderOfNaming()) {
        const int wide = metrics.horizontalAdvance(m_marks[i].name);
        const int left = std::clamp(xOf(m_marks[i]) - wide / 2, 0, std::max(0, width() - wide));
        for (int row = 0; row < rows; ++row) {
            const QRect place(left, tickHeight + row * nameHeight(), wide, nameHeight());
            const bool isFree = std::ranges::none_of(labels, [&](const Label& label) {
                return label.place.adjusted(-gap, 0, gap, 0).intersects(place);
            });
            if (!isFree)
                continue;
            labels.push_back({i, place});
            break;
        }
    }
    return labels;
}

void MarkStrip::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QColor pale = palette().color(QPalette::PlaceholderText);
    const QColor strong = palette().color(QPalette::WindowText);
    const auto isPresent = [&](const SliderMark& mark) { return mark.value == m_value; };
    for (const SliderMark& mark : m_marks) {
        painter.setPen(QPen(isPresent(mark) ? strong : pale, isPresent(mark) ? 2.0 : 1.0));
        painter.drawLine(xOf(mark), 0, xOf(mark), tickHeight - 1);
    }
    QFont names = smallFont();
    for (const Label& label : labels()) {
        const SliderMark& mark = m_marks[label.mark];
        names.setBold(isPresent(mark));
        painter.setFont(names);
        painter.setPen(isPresent(mark) ? strong : pale);
        painter.drawText(label.place, Qt::AlignHCenter | Qt::AlignVCenter | Qt::TextDontClip,
                         mark.name);
    }
}

const SliderMark* MarkStrip::markAt(const QPoint& point) const
{
    for (const Label& label : labels())
        if (label.place.contains(point))
            return &m_marks[label.mark];
    const SliderMark* nearest = nullptr;
    int least = reachOfTick + 1;
    for (const SliderMark& mark : m_marks)
        if (const int way = std::abs(xOf(mark) - point.x()); way < least) {
            least = way;
            nearest = &mark;
        }
    return nearest;
}

void MarkStrip::mousePressEvent(QMouseEvent* event)
{
    if (const SliderMark* mark = markAt(event->pos()))
        emit chosen(mark->value);
}

void MarkStrip::mouseMoveEvent(QMouseEvent* event)
{
    setCursor(markAt(event->pos()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

bool MarkStrip::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (const SliderMark* mark = markAt(help->pos()))
            QToolTip::showText(help->globalPos(), shownAsIs(mark->tip), this);
        else
            QToolTip::hideText();
        return true;
    }
    return QWidget::event(event);
}

} // namespace ripstop
