// Stages, in the order of the sections below:
//   time and place   the part of the run that is shown, and how its times become pixels and back
//   painting         from back to front: the band of what is kept, the axis, events in lanes by
//                    their kind, bookmarks, and the marker of the instant that is shown
//   mouse and keys   a drag pauses the playback and seeks; the wheel zooms about the mouse; keys
//                    that would be shortcuts of the window belong to the strip while it has the
//                    focus
#include "timeline/timeline_strip.h"

#include "document/event_words.h"
#include "document/plain_text.h"
#include "document/recordings.h"

#include <QEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <cmath>

namespace ripstop {
namespace {

constexpr int margin = 10;     // px, left and right
constexpr int axisHeight = 18; // px, of the numbers
constexpr int near = 4;        // px, of the mouse to a mark
constexpr int leap = 10;       // frames, with Shift

bool isDark(const QPalette& palette) { return palette.color(QPalette::Window).lightnessF() < 0.5; }

// 1, 2 or 5 times a power of ten, so that marks are far enough apart to be read.
double tickOf(double length, int width)
{
    constexpr int apart = 70; // px
    const double least = std::max(1e-3, length * apart / std::max(1, width));
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= least)
            return step * power;
    return 10.0 * power;
}

QString timeText(double time, double tick)
{
    const int decimals = std::clamp(int(std::ceil(-std::log10(tick) - 1e-9)), 0, 3);
    return QLocale().toString(time, 'f', decimals);
}

// With these keys another one means something to the window.
bool isShortcut(const QKeyEvent& event)
{
    return event.modifiers() & (Qt::ControlModifier | Qt::AltModifier);
}

} // namespace

TimelineStrip::TimelineStrip(Recordings& recordings, QWidget* parent)
    : QWidget(parent)
    , m_recordings(recordings)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(tr("Timeline"));
    setCursor(Qt::PointingHandCursor);
    connect(&recordings, &Recordings::listChanged, this, &TimelineStrip::refresh);
    connect(&recordings, &Recordings::grew, this, &TimelineStrip::refresh);
    connect(&recordings, &Recordings::moved, this, qOverload<>(&QWidget::update));
    connect(&recordings, &Recordings::stateChanged, this, qOverload<>(&QWidget::update));
    refresh();
}

QSize TimelineStrip::sizeHint() const { return {600, 74}; }
QSize TimelineStrip::minimumSizeHint() const { return {200, 56}; }

void TimelineStrip::refresh()
{
    const auto& recording = m_recordings.current();
    takeRun();
    m_events = recording ? recording->events() : std::vector<RunEvent>();
    m_last = recording ? whole() : Span{0.0, 0.0};
    update();
}

// --- time and place ----------------------------------------------------------------------------

TimelineStrip::Span TimelineStrip::whole() const
{
    const auto& recording = m_recordings.current();
    if (!recording || recording->frameCount() == 0)
        return m_kept.length() > 0.0 ? m_kept : Span();
    const double from = recording->timeOf(0);
    const double to = std::max(recording->timeOf(recording->frameCount() - 1), from + 0.5);
    if (m_kept.length() > 0.0)
        return {std::min(m_kept.from, from), std::max(m_kept.to, to)};
    return {from, to};
}

// A branch takes over the axis, so that the mark of where one looks stays where it is.
void TimelineStrip::takeRun()
{
    const auto& recording = m_recordings.current();
    if (recording == m_run.lock())
        return;
    const bool branches = recording && !recording->origin().empty() && m_last.length() > 0.0;
    m_kept = branches ? m_last : Span{0.0, 0.0};
    m_run = recording;
    m_zoomed = false;
}

TimelineStrip::Span TimelineStrip::shown() const { return m_zoomed ? m_zoom : whole(); }

double TimelineStrip::timeAt(int x) const
{
    const Span span = shown();
    return span.from + span.length() * (x - margin) / std::max(1, width() - 2 * margin);
}

int TimelineStrip::placeOf(double time) const
{
    const Span span = shown();
    const double share = std::clamp((time - span.from) / span.length(), -10.0, 10.0);
    return margin + int(std::lround(share * (width() - 2 * margin)));
}

QString TimelineStrip::tipAt(int x) const
{
    QStringList lines;
    const auto& recording = m_recordings.current();
    if (!recording)
        return {};
    for (const Bookmark& bookmark : recording->bookmarks())
        if (std::abs(placeOf(bookmark.time) - x) <= near)
            lines << tr("%1 s: bookmark \u201c%2\u201d")
                         .arg(QLocale().toString(bookmark.time, 'f', 3),
                              QString::fromStdString(bookmark.name));
    constexpr int most = 6;
    qsizetype left = 0;
    const int designs = int(recording->designCount());
    const auto scene = designs > 0 ? recording->design(designs - 1).base : nullptr;
    const Scene nobody;
    for (const RunEvent& event : m_events)
        if (std::abs(placeOf(event.time) - x) <= near) {
            if (lines.size() < most)
                lines << describe(event, scene ? *scene : nobody);
            else
                ++left;
        }
    if (left > 0)
        lines << tr("and %1 more").arg(left);
    return shownAsIs(lines.join('\n'));
}

// --- painting ----------------------------------------------------------------------------------

void TimelineStrip::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    const auto& recording = m_recordings.current();
    if (!recording || recording->frameCount() == 0) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(margin, 0, -margin, 0), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Nothing is recorded yet. Play (Space), and every moment is kept here "
                            "to look back at."));
        return;
    }
    paintKept(painter);
    paintAxis(painter);
    paintEvents(painter);
    paintBookmarks(painter);
    paintHere(painter);
    if (hasFocus()) {
        painter.setPen(palette().color(QPalette::Highlight));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void TimelineStrip::paintKept(QPainter& painter) const
{
    const Span all = whole();
    const auto& recording = m_recordings.current();
    const int left = placeOf(all.from);
    const int right = placeOf(recording->timeOf(recording->frameCount() - 1));
    const int top = axisHeight;
    const QRect band(left, top, std::max(1, right - left), height() - top - 4);
    QColor fill = palette().color(QPalette::Highlight);
    fill.setAlpha(isDark(palette()) ? 60 : 38);
    painter.fillRect(band, fill);
    if (const auto& loop = m_recordings.loop()) {
        fill.setAlpha(110);
        const int from = placeOf(loop->from);
        painter.fillRect(QRect(from, top, std::max(2, placeOf(loop->to) - from), 6), fill);
    }
}

void TimelineStrip::paintAxis(QPainter& painter) const
{
    const Span span = shown();
    const double tick = tickOf(span.length(), width() - 2 * margin);
    QColor line = palette().color(QPalette::Text);
    line.setAlpha(60);
    for (auto i = std::int64_t(std::ceil(span.from / tick - 1e-9)); double(i) * tick <= span.to;
         ++i) {
        const int x = placeOf(double(i) * tick);
        painter.setPen(line);
        painter.drawLine(x, axisHeight, x, height() - 4);
        painter.setPen(palette().color(QPalette::Text));
        const QRect box(x - 40, 0, 80, axisHeight);
        const QString text = timeText(double(i) * tick, tick);
        const int room = painter.fontMetrics().horizontalAdvance(text) / 2 + 2;
        if (x - room >= 0 && x + room <= width())
            painter.drawText(box, Qt::AlignCenter, text);
    }
}

void TimelineStrip::paintEvents(QPainter& painter) const
{
    // kinds that may come together stand below each other, so that none hides another
    static constexpr std::array lanes{0, 1, 1, 2, 0, 3, 3, 4, 4};
    static_assert(lanes.size() == runEventNames.size());
    constexpr int laneCount = 5;
    const int top = axisHeight + 8;
    const int room = std::max(3 * laneCount, height() - top - 4);
    for (const RunEvent& event : m_events) {
        const int x = placeOf(event.time);
        if (x < 0 || x > width())
            continue;
        const int laneTop = top + lanes[std::size_t(event.kind)] * room / laneCount;
        painter.fillRect(QRect(x - 1, laneTop, 3, std::max(3, room / laneCount - 1)),
                         eventColor(event.kind, palette()));
    }
}

void TimelineStrip::paintBookmarks(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Bookmark& bookmark : m_recordings.current()->bookmarks()) {
        const double x = placeOf(bookmark.time) + 0.5;
        const double y = axisHeight;
        painter.setPen(Qt::NoPen);
        painter.setBrush(palette().color(QPalette::Text));
        painter.drawPolygon(
            QPolygonF({{x - 4, y}, {x + 4, y}, {x + 4, y + 11}, {x, y + 7}, {x - 4, y + 11}}));
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
}

void TimelineStrip::paintHere(QPainter& painter) const
{
    const int x = placeOf(m_recordings.time());
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor color = m_recordings.isLookingBack() ? palette().color(QPalette::Highlight)
                                                      : palette().color(QPalette::Text);
    painter.setPen(QPen(color, 2));
    painter.drawLine(x, axisHeight - 2, x, height() - 2);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawPolygon(QPolygonF(
        {{x - 6.0, axisHeight - 9.0}, {x + 6.0, axisHeight - 9.0}, {double(x), axisHeight + 1.0}}));
    painter.setRenderHint(QPainter::Antialiasing, false);
}

// --- mouse and keys ----------------------------------------------------------------------------

void TimelineStrip::scrub(int x)
{
    m_recordings.pause();
    m_recordings.seekTime(timeAt(x));
}

void TimelineStrip::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        scrub(event->pos().x());
}

void TimelineStrip::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() & Qt::LeftButton)
        scrub(event->pos().x());
}

void TimelineStrip::mouseDoubleClickEvent(QMouseEvent*)
{
    m_zoomed = false;
    update();
}

void TimelineStrip::wheelEvent(QWheelEvent* event)
{
    const Span all = whole();
    Span span = shown();
    const double turns = event->angleDelta().y() / 120.0;
    const double at = std::clamp(timeAt(int(event->position().x())), all.from, all.to);
    const double length = std::clamp(span.length() * std::pow(0.8, turns), 0.02, all.length());
    const double share = (at - span.from) / span.length();
    span.from = std::clamp(at - share * length, all.from, all.to - length);
    span.to = span.from + length;
    m_zoom = span;
    m_zoomed = length < all.length();
    update();
}

void TimelineStrip::keyPressEvent(QKeyEvent* event)
{
    const auto& recording = m_recordings.current();
    if (isShortcut(*event))
        return QWidget::keyPressEvent(event);
    const std::ptrdiff_t step = event->modifiers() & Qt::ShiftModifier ? leap : 1;
    const auto end = recording ? std::ptrdiff_t(recording->frameCount()) : 0;
    switch (event->key()) {
    case Qt::Key_Left:
        return m_recordings.move(-step);
    case Qt::Key_Right:
        return m_recordings.move(step);
    case Qt::Key_Home:
        return m_recordings.move(-end);
    case Qt::Key_End:
        return m_recordings.move(end);
    case Qt::Key_PageUp:
        return void(m_recordings.toEvent(Recordings::Way::Back));
    case Qt::Key_PageDown:
        return void(m_recordings.toEvent(Recordings::Way::Forward));
    default:
        QWidget::keyPressEvent(event);
    }
}

bool TimelineStrip::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) { // keys belong to it while it has the focus
        const auto* pressed = static_cast<QKeyEvent*>(event);
        for (const int mine : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Home, Qt::Key_End,
                               Qt::Key_PageUp, Qt::Key_PageDown})
            if (pressed->key() == mine && !isShortcut(*pressed))
                event->accept();
        return QWidget::event(event);
    }
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString tip = tipAt(help->pos().x());
    QToolTip::showText(help->globalPos(),
                       tip.isEmpty() ? tr("Drag to look back. Left and right: a frame, with Shift "
                                          "ten. Page up and down: events. Wheel: zoom.")
                                     : tip,
                       this);
    return true;
}

} // namespace ripstop
