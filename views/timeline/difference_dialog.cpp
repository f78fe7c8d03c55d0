// Plot draws the two curves and says which row the mouse is over. The constructor posts the one job
// to the worker at once; a timer shows how far it is; take() brings its list, or why there is none,
// to the window; describe() says in words what the curves mean or what they are at one time. The
// destructor cancels the work, and the worker, as the last member, is joined before what it uses
// goes.
#include "timeline/difference_dialog.h"

#include "document/spoken.h"
#include "document/words.h"

#include <QLabel>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QProgressBar>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <functional>

namespace ripstop {
namespace {

constexpr int left = 64;   // px, for the numbers of the value axis
constexpr int bottom = 26; // px, for those of the time axis
constexpr int top = 10;
constexpr int right = 14;
constexpr int ticks = 5; // at most, between round numbers

QString lengthText(double length) { return spokenText(length, "m", 3); }

} // namespace

// Two curves over time: the farthest particle, and the root mean square of all.
class DifferenceDialog::Plot final : public QWidget
{
public:
    explicit Plot(const std::vector<RunDistance>& list)
        : m_list(list)
    {
        setMouseTracking(true);
        setMinimumSize(420, 220);
        setAutoFillBackground(true);
        setBackgroundRole(QPalette::Base);
    }
    std::function<void(std::optional<std::size_t>)> hovered;
    std::function<void(std::size_t)> clicked;

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        if (m_list.empty())
            return;
        const QRectF area = place();
        const double high = highest();
        QColor grid = palette().color(QPalette::Text);
        grid.setAlpha(50);
        const QColor ink = palette().color(QPalette::Text);
        const SpokenScale metres = spokenScale(high, "m");
        const double rise = roundStep(high / metres.factor / ticks) * metres.factor;
        for (double value = 0.0; value <= high * (1.0 + 1e-9); value += rise) {
            const double y = area.bottom() - value / high * area.height();
            painter.setPen(grid);
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
            painter.setPen(ink);
            painter.drawText(QRectF(0, y - 10, left - 6, 20), Qt::AlignRight | Qt::AlignVCenter,
                             metres.atStep(value, rise) + QChar(0x00a0) + metres.unit);
        }
        const double from = m_list.front().time;
        const double step = roundStep(length() / ticks);
        for (double n = std::ceil(from / step - 1e-9); n * step <= from + length() + 1e-9; ++n) {
            const double x = area.left() + (n * step - from) / length() * area.width();
            painter.setPen(grid);
            painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
            painter.setPen(ink);
            painter.drawText(QRectF(x - 40, area.bottom() + 4, 80, 20), Qt::AlignCenter,
                             tr("%1 s").arg(SpokenScale().atStep(n * step, step)));
        }
        painter.setRenderHint(QPainter::Antialiasing);
        draw(painter, &RunDistance::most, palette().color(QPalette::Highlight));
        draw(painter, &RunDistance::rms, palette().color(QPalette::Text));
    }
    void mouseMoveEvent(QMouseEvent* event) override
    {
        if (!m_list.empty())
            hovered(rowAt(event->position().x()));
    }
    void mousePressEvent(QMouseEvent* event) override
    {
        if (!m_list.empty())
            clicked(rowAt(event->position().x()));
    }
    void leaveEvent(QEvent*) override { hovered({}); }

private:
    QRectF place() const { return QRectF(rect()).adjusted(left, top, -right, -bottom); }
    double length() const { return std::max(1e-9, m_list.back().time - m_list.front().time); }
    double highest() const
    {
        double high = 1e-9;
        for (const RunDistance& row : m_list)
            high = std::max(high, row.most);
        return high;
    }
    void draw(QPainter& painter, double RunDistance::*value, const QColor& color) const
    {
        const QRectF area = place();
        const double high = highest();
        QPolygonF curve;
        for (const RunDistance& row : m_list)
            curve << QPointF(area.left()
                                 + (row.time - m_list.front().time) / length() * area.width(),
                             area.bottom() - row.*value / high * area.height());
        painter.setPen(QPen(color, 1.6));
        painter.drawPolyline(curve);
    }
    std::size_t rowAt(double x) const
    {
        const QRectF area = place();
        const double time = m_list.front().time + (x - area.left()) / area.width() * length();
        const auto found = std::partition_point(
            m_list.begin(), m_list.end(), [&](const RunDistance& row) { return row.time < time; });
        return std::min(std::size_t(found - m_list.begin()), m_list.size() - 1);
    }

    const std::vector<RunDistance>& m_list;
};

DifferenceDialog::DifferenceDialog(std::shared_ptr<Recording> a, std::shared_ptr<Recording> b,
                                   QWidget* parent)
    : QDialog(parent)
    , m_a(std::move(a))
    , m_b(std::move(b))
    , m_text(new QLabel)
    , m_bar(new QProgressBar)
    , m_plot(new Plot(m_list))
    , m_worker(
          [this](const int&) {
              const auto list = compareRuns(*m_a, *m_b, 0.0, [this](double share) {
                  m_share = share;
                  return !m_cancelled;
              });
              return list ? Outcome{*list, {}} : Outcome{{}, list.message()};
          },
          [this] {
              QMetaObject::invokeMethod(this, &DifferenceDialog::take, Qt::QueuedConnection);
          })
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(
        tr("%1 and %2: distance of their particles")
            .arg(QString::fromStdString(m_a->name()), QString::fromStdString(m_b->name())));
    m_bar->setRange(0, 1000);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_plot, 1);
    layout->addWidget(m_bar);
    layout->addWidget(m_text);
    m_plot->hovered = [this](std::optional<std::size_t> row) { describe(row); };
    m_plot->clicked = [this](std::size_t row) { emit picked(m_list[row].time); };
    auto* look = new QTimer(this);
    connect(look, &QTimer::timeout, this, &DifferenceDialog::showProgress);
    look->start(50);
    resize(640, 360);
    describe({});
    m_worker.post(0);
}

DifferenceDialog::~DifferenceDialog() { m_cancelled = true; }

void DifferenceDialog::showProgress() { m_bar->setValue(int(1000 * m_share)); }

void DifferenceDialog::take()
{
    const auto outcome = m_worker.take();
    if (!outcome)
        return;
    m_done = true;
    m_list = outcome->list;
    m_bar->hide();
    if (!outcome->failure.empty())
        m_text->setText(translated(outcome->failure));
    else if (m_list.front().particles == 0)
        m_text->setText(tr("The two have no particle in common: they are of other designs."));
    else
        describe({});
    m_plot->update();
}

void DifferenceDialog::describe(std::optional<std::size_t> row)
{
    if (m_list.empty()) {
        if (!m_done)
            m_text->setText(tr("Measuring\u2026"));
        return;
    }
    if (!row) {
        m_text->setText(tr("Coloured: the particle that is farthest off. Plain: the root mean "
                           "square of all %1. Click to look at that time.")
                            .arg(m_list.front().particles));
        return;
    }
    const RunDistance& there = m_list[*row];
    m_text->setText(tr("%1 s: %2 root mean square, %3 at most (particle %4)")
                        .arg(QLocale().toString(there.time, 'f', 3), lengthText(there.rms),
                             lengthText(there.most))
                        .arg(there.farthest));
}

} // namespace ripstop
