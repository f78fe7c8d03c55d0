// The constructor stacks three pages (curves over time, the hint, curves against something else)
// under a bar with the name. setPlot() takes what is to be drawn and chooses the page; draw() gives
// the page in sight its curves, and computes phase curves and spectra only when they are the ones
// in sight, because a spectrum takes a transform of the whole run.
#include "plots/plot_view.h"

#include "icons/icon.h"
#include "plots/chart_style.h"
#include "plots/curve_views.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include <algorithm>

namespace ripstop {
namespace {

enum Page { OverTime, Hint, Across };

bool shareAUnit(const std::vector<Curve>& curves)
{
    return std::ranges::all_of(curves, [&](const Curve& one) {
        return one.unit == curves.front().unit && one.isShare == curves.front().isShare;
    });
}

} // namespace

PlotView::PlotView(QWidget* parent)
    : QWidget(parent)
    , m_bar(new QWidget)
    , m_name(new QLabel)
    , m_close(new QToolButton)
    , m_pages(new QStackedWidget)
    , m_hint(new QLabel)
    , m_chart(new Chart)
    , m_xy(new XyChart)
{
    m_close->setAutoRaise(true);
    m_close->setIcon(icon(QStringLiteral("close")));
    m_close->setIconSize({12, 12});
    m_close->setAccessibleName(tr("Remove this plot"));
    m_close->setToolTip(tr("Remove this plot from the scene. Undo brings it back."));
    auto* bar = new QHBoxLayout(m_bar);
    bar->setContentsMargins(6, 0, 2, 0);
    bar->addWidget(m_name, 1);
    bar->addWidget(m_close);

    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(m_chart);
    for (QLabel* label : {m_name, m_hint})
        label->setTextFormat(Qt::PlainText);
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setForegroundRole(QPalette::PlaceholderText);
    m_hint->setWordWrap(true);
    for (QWidget* page : {static_cast<QWidget*>(scroll), static_cast<QWidget*>(m_hint),
                          static_cast<QWidget*>(m_xy)})
        m_pages->addWidget(page);

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_bar);
    layout->addWidget(m_pages, 1);
    m_bar->hide();

    connect(m_close, &QToolButton::clicked, this, &PlotView::removeWanted);
    connect(m_chart, &Chart::followed, this, &PlotView::drawWanted);
    for (QCustomPlot* plot : {&m_chart->plot(), &m_xy->plot()})
        connect(plot, &QCustomPlot::mousePress, this, &PlotView::chosen);
    for (QWidget* asked : {static_cast<QWidget*>(m_chart), static_cast<QWidget*>(m_xy),
                           static_cast<QWidget*>(m_hint), m_bar}) {
        asked->setContextMenuPolicy(Qt::CustomContextMenu);
        connect(asked, &QWidget::customContextMenuRequested, this,
                [this, asked](const QPoint& place) { emit menuWanted(asked->mapToGlobal(place)); });
    }
}

void PlotView::setPlot(const Plot& plot, std::vector<Curve> curves, const AxisWords& across)
{
    m_plot = plot;
    m_across = across;
    m_chart->setPlot(plot);
    m_chart->setCurves(std::move(curves));
    m_xy->setLogarithmic(plot.logarithmic);
    m_xy->setRange(plot.low, plot.high);
    m_name->setText(QString::fromStdString(plot.name));
    showPage();
}

void PlotView::setLack(const QString& why)
{
    m_lack = why;
    showPage();
}

void PlotView::showPage()
{
    const bool lacksProbe = m_plot.axis == PlotAxis::Probe && m_across.name.isEmpty();
    m_hint->setText(lacksProbe ? tr("Choose the probe that the curves are against: right click.")
                    : curves().empty() ? tr("Tick a probe to plot it.")
                                       : m_lack);
    m_pages->setCurrentIndex(!m_hint->text().isEmpty()       ? Hint
                             : m_plot.axis == PlotAxis::Time ? OverTime
                                                             : Across);
}

void PlotView::setTitle(Title title)
{
    m_title = title;
    m_bar->setVisible(title != Title::Hidden);
    styleTitle();
}

void PlotView::styleTitle()
{
    QFont font = this->font();
    font.setBold(m_title == Title::Current);
    m_name->setFont(font);
    m_bar->setAutoFillBackground(m_title == Title::Current);
    m_bar->setBackgroundRole(QPalette::AlternateBase);
}

void PlotView::draw(const History& history, const ErrorBands* bands,
                    const std::vector<EarlierRun>& earlier)
{
    if (m_pages->currentIndex() == OverTime)
        return m_chart->draw(history, bands);
    if (m_pages->currentIndex() == Hint)
        return;
    // Curves of one unit have it on their axis, others beside their names.
    std::vector<Curve> named = curves();
    const bool shared = shareAUnit(named);
    for (Curve& curve : named)
        curve.name = shared ? curve.name : withUnit(curve.name, curve.unit);
    AxisWords values;
    if (shared)
        values = {{}, named.front().unit, named.front().isShare};
    if (m_plot.axis == PlotAxis::Frequency) {
        values.name = tr("amplitude");
        return m_xy->show({tr("frequency"), QStringLiteral("Hz")}, values,
                          spectra(history, earlier, named));
    }
    m_xy->show(m_across, values,
               phaseCurves(history, earlier, named, std::uint32_t(m_plot.against)));
}

QCustomPlot& PlotView::plotInSight() const
{
    return m_plot.axis == PlotAxis::Time ? m_chart->plot() : m_xy->plot();
}

double PlotView::drawingTime() const { return plotInSight().replotTime(true); }

std::optional<std::pair<double, double>> PlotView::valueRange() const
{
    return m_plot.axis == PlotAxis::Time ? m_chart->valueRange()
                                         : std::optional(m_xy->valueRange());
}

void PlotView::mousePressEvent(QMouseEvent* event)
{
    emit chosen();
    event->accept();
}

void PlotView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        styleTitle();
}

} // namespace ripstop
