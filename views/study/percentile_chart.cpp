// A band is the graph of its upper percentile, filled down to that of the lower one.
#include "study/percentile_chart.h"

#include "plots/chart_style.h"
#include "plots/curve_color.h"
#include "study/shown_value.h"

#include <QEvent>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr std::size_t medianPlace = 2;
constexpr double nearBand = 24.0; // px

QVector<double> one(std::vector<double> numbers) { return {numbers.begin(), numbers.end()}; }

} // namespace

PercentileChart::PercentileChart(QWidget* parent)
    : QWidget(parent)
    , m_plot(makePlot(*this))
    , m_x(new SpokenAxis(*m_plot->xAxis))
    , m_y(new SpokenAxis(*m_plot->yAxis))
{
    putLegendAbove(*m_plot);
    for (QCPGraph*& line : m_lines)
        line = m_plot->addGraph();
    const std::size_t last = m_lines.size() - 1;
    for (std::size_t i = 0; i < medianPlace; ++i)
        m_lines[last - i]->setChannelFillGraph(m_lines[i]);
    m_lines[last]->setName(tr("5 to 95 %"));
    m_lines[last - 1]->setName(tr("25 to 75 %"));
    m_lines[medianPlace]->setName(tr("median"));
    m_failed = m_plot->addGraph();
    m_failed->setLineStyle(QCPGraph::lsNone);
    m_failed->setName(tr("ended early"));
    setMinimumSize(180, 150);
    connect(m_plot, &QCustomPlot::mousePress, this, [this](const QMouseEvent* event) {
        if (event->button() != Qt::LeftButton || m_bands.empty())
            return;
        const auto away = [&](const StudyBand& band) {
            return std::abs(m_plot->xAxis->coordToPixel(band.x) - event->pos().x());
        };
        const auto nearest = std::ranges::min_element(m_bands, {}, away);
        if (away(*nearest) < nearBand)
            emit picked(nearest->points, pickingOf(event->modifiers()));
    });
    restyle();
}

void PercentileChart::show(const StudyColumn& variable, const StudyColumn& reading,
                           const StudyFlights& flights)
{
    m_bands = bandsOf(variable, reading, flights);
    m_hasBands =
        std::ranges::any_of(m_bands, [](const StudyBand& band) { return band.counted > 1; });
    m_x->say(wordsOfHeading(QString::fromStdString(variable.title)));
    m_y->say(wordsOfHeading(QString::fromStdString(reading.title)));
    fitAxes(variable, reading);
    draw();
}

void PercentileChart::fitAxes(const StudyColumn& variable, const StudyColumn& reading)
{
    m_x->setLogarithmic(variable.isLogarithmic);
    if (!variable.labels.empty()) {
        const QSharedPointer<QCPAxisTickerText> names(new QCPAxisTickerText);
        for (std::size_t i = 0; i < variable.labels.size(); ++i)
            names->addTick(double(i), QString::fromStdString(variable.labels[i]));
        m_plot->xAxis->setTicker(names);
    }
    if (const auto span = spanOf(variable.value))
        m_plot->xAxis->setRange(variable.isLogarithmic
                                    ? QCPRange(0.95 * span->least, 1.05 * span->largest)
                                    : withAir({span->least, span->largest}));
    if (const auto span = spanOf(reading.value))
        m_plot->yAxis->setRange(withAir({span->least, span->largest}));
}

void PercentileChart::draw()
{
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        std::vector<double> x, y;
        for (const StudyBand& band : m_bands) {
            x.push_back(band.x);
            y.push_back(band.value[i]);
        }
        m_lines[i]->setData(one(x), one(y), true);
        m_lines[i]->setVisible(m_hasBands || i == medianPlace);
    }
    QVector<double> x, y;
    for (const StudyBand& band : m_bands)
        if (band.failed > 0) {
            x << band.x;
            y << m_plot->yAxis->range().lower;
        }
    m_failed->setData(x, y);
    m_failed->setVisible(!x.isEmpty());
    nameBands();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

// What is shown, in one line where that has room.
void PercentileChart::nameBands()
{
    std::vector<QCPAbstractPlottable*> shown;
    if (m_hasBands)
        shown = {m_lines[medianPlace], m_lines[3], m_lines[4]};
    if (m_hasBands && m_failed->visible())
        shown.push_back(m_failed);
    fitLegend(*m_plot->legend, shown, width(), 2);
}

void PercentileChart::resizeEvent(QResizeEvent*) { nameBands(); }

void PercentileChart::restyle()
{
    stylePlot(*m_plot, *this);
    styleLegend(*m_plot->legend, *this);
    const QColor color = curveColor(0, palette());
    const auto faint = [&](int alpha) {
        return QColor(color.red(), color.green(), color.blue(), alpha);
    };
    m_lines[medianPlace]->setPen(QPen(color, 2.0));
    m_lines[medianPlace]->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssDisc, color, color, 6));
    for (std::size_t i = 0; i < m_lines.size(); ++i)
        if (i != medianPlace)
            m_lines[i]->setPen(QPen(faint(110), 1.0));
    m_lines[4]->setBrush(faint(45));
    m_lines[3]->setBrush(faint(85));
    m_failed->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssCross, QPen(QColor(220, 50, 40), 2.0), Qt::NoBrush, 9));
}

void PercentileChart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        restyle();
        m_plot->replot(QCustomPlot::rpQueuedReplot);
    }
    QWidget::changeEvent(event);
}

} // namespace ripstop
