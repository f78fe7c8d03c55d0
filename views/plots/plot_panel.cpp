// Stages, in the order of the source:
//   what there is   refresh() compares the probes and plots of the scene with those shown, and
//                   rebuilds list and panels only when they differ, because an edit of anything
//                   comes here
//   panels          which of them the list and the menu are about
//   frames          samples and frames of the player go into the history; a new run keeps the old
//                   one as an earlier run; drawSoon() waits longer the longer the last drawing
//                   took, so that plots never take more than a third of the window's time
//   events          those of the recording become marks, but only when it is the run that is drawn
// The list of probes is in plot_list.cpp.
#include "plots/plot_panel.h"

#include "base/quantity.h"
#include "document/document.h"
#include "document/event_words.h"
#include "document/player.h"
#include "document/recordings.h"
#include "document/words.h"
#include "plots/chart_style.h"
#include "plots/curve_color.h"
#include "plots/plot_output.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

namespace ripstop {
namespace {

constexpr double quickest = 33.0; // ms, between pictures
constexpr double slowest = 1000.0;
constexpr double shareOfTime = 3.0; // drawing takes at most a third of the window's time
constexpr int listWidth = 210;      // px
constexpr int panelWidth = 240;     // px, at least, beside others

QLabel* hint(const QString& text)
{
    auto* label = new QLabel(text);
    label->setAlignment(Qt::AlignCenter);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setWordWrap(true);
    return label;
}

template <typename T>
std::vector<Entry> allOf(const Scene& scene)
{
    std::vector<Entry> found;
    for (const Entry& entry : scene.items)
        if (std::holds_alternative<T>(entry.item))
            found.push_back(entry);
    return found;
}

} // namespace

PlotPanel::PlotPanel(Document& document, Player& player, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_player(player)
    , m_pages(new QStackedWidget)
    , m_list(new QTreeWidget)
    , m_panels(new QSplitter)
    , m_pastFinder(
          [this](const PastWish& wish) {
              return findPast(wish, [this](double) { return !m_isOver; });
          },
          [this] { QMetaObject::invokeMethod(this, &PlotPanel::takePast, Qt::QueuedConnection); })
    , m_reader(
          [this](const PastWish& wish) {
              return findPast(wish, [&](double) { return !m_isOver && m_reading == wish.number; });
          },
          [this] {
              QMetaObject::invokeMethod(this, &PlotPanel::takeReading, Qt::QueuedConnection);
          })
{
    layOut();
    m_redraw.setSingleShot(true);
    connect(&m_redraw, &QTimer::timeout, this, &PlotPanel::draw);
    connect(&document, &Document::changed, this, &PlotPanel::refresh);
    connect(&document, &Document::replaced, this, [this] {
        m_history.clear();
        m_own = {};
        m_current = 0;
        m_events.clear();
        m_pastAsked.clear();
        forgetEarlier();
        refresh();
    });
    connect(&player, &Player::sampled, this, &PlotPanel::takeSample);
    connect(&player, &Player::frameReady, this, &PlotPanel::take);
    connect(m_list, &QTreeWidget::itemChanged, this, &PlotPanel::tick);
    rebuildViews();
    refresh();
    if (player.frame())
        take(player.frame());
}

PlotPanel::~PlotPanel() { m_isOver = true; }

void PlotPanel::layOut()
{
    m_list->setColumnCount(2);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setAccessibleName(tr("Probes"));
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_list->setToolTip(tr("Tick a probe to plot it."));

    m_panels->setChildrenCollapsible(false);
    auto* scroll = new QScrollArea; // for more panels than have room
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(m_panels);
    auto* splitter = new QSplitter;
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(m_list);
    splitter->addWidget(scroll);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({listWidth, 3 * listWidth});
    m_pages->addWidget(splitter);
    m_pages->addWidget(hint(tr("No probes. Add one in the outline to plot it.")));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_pages);
}

// --- what there is ---------------------------------------------------------------------------

void PlotPanel::refresh()
{
    std::vector<Entry> probes = allOf<Probe>(m_document.scene());
    std::vector<Entry> plots = allOf<Plot>(m_document.scene());
    if (probes != m_probes || plots != m_plots) {
        m_probes = std::move(probes);
        m_plots = std::move(plots);
        rebuildViews();
        rebuildList();
        askPast();
        if (m_isOfFrames)
            readPlayed();
    }
    m_pages->setCurrentIndex(m_probes.empty() ? 1 : 0);
}

const Plot& PlotPanel::plotOf(std::size_t view) const
{
    return m_plots.empty() ? m_own : std::get<Plot>(m_plots[view].item);
}

void PlotPanel::rebuildViews()
{
    const std::size_t count = std::max<std::size_t>(1, m_plots.size());
    while (m_views.size() > count) {
        m_views.back()->deleteLater(); // its signal may be what called this
        m_views.back()->hide();
        m_views.pop_back();
    }
    while (m_views.size() < count)
        m_views.push_back(newView());
    m_current = std::min(m_current, count - 1);
    for (std::size_t i = 0; i < count; ++i) {
        const Plot& plot = plotOf(i);
        m_views[i]->setPlot(plot, curvesOf(plot), acrossOf(plot));
        m_views[i]->setMinimumWidth(count > 1 ? panelWidth : 0);
        m_views[i]->setTitle(m_plots.empty()               ? PlotView::Title::Hidden
                             : count > 1 && i == m_current ? PlotView::Title::Current
                                                           : PlotView::Title::Shown);
        m_views[i]->setLack(lackOf(*m_views[i]));
    }
    giveEarlier();
    giveMarks();
    drawSoon();
}

PlotView* PlotPanel::newView()
{
    auto* view = new PlotView;
    m_panels->addWidget(view);
    const auto number = [this, view] {
        return int(std::ranges::find(m_views, view) - m_views.begin());
    };
    connect(view, &PlotView::chosen, this, [this, number] { choose(number()); });
    connect(view, &PlotView::menuWanted, this, [this, number](const QPoint& place) {
        choose(number());
        showMenu(place);
    });
    connect(view, &PlotView::removeWanted, this, [this, number] { removePlot(number()); });
    connect(view, &PlotView::drawWanted, this, &PlotPanel::drawSoon);
    connect(&view->chart(), &Chart::hovered, this, [this](std::optional<double> time) {
        m_hovered = time;
        for (PlotView* one : m_views)
            one->chart().setHover(time);
        showValues();
    });
    view->show();
    return view;
}

std::vector<Curve> PlotPanel::curvesOf(const Plot& plot) const
{
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < m_probes.size(); ++i) {
        const auto& [id, item] = m_probes[i];
        const auto& probe = std::get<Probe>(item);
        const bool wanted = plot.probes.empty()
                                ? probe.plotted
                                : std::ranges::find(plot.probes, id) != plot.probes.end();
        if (wanted)
            curves.push_back({std::uint32_t(id), nameOf(m_probes[i]), unitOf(id),
                              curveColor(int(i), palette()), isSaidInPercent(probe.quantity)});
    }
    return curves;
}

AxisWords PlotPanel::acrossOf(const Plot& plot) const
{
    const Probe* across = findItem<Probe>(m_document.scene(), plot.against);
    if (!across)
        return {};
    return {QString::fromStdString(across->name), unitOf(plot.against),
            isSaidInPercent(across->quantity)};
}

void PlotPanel::takeOver(const PlotPanel& before)
{
    m_history = before.m_history;
    m_earlier = before.m_earlier;
    m_runs = before.m_runs;
    for (std::size_t i = 0; i < m_earlier.size(); ++i)
        m_earlier[i].name = tr("run %1").arg(m_runs - int(m_earlier.size() - i) + 1);
    m_own = before.m_own;
    m_current = before.m_current;
    m_wantsBands = before.m_wantsBands;
    rebuildViews();
    rebuildList();
}

// --- panels ----------------------------------------------------------------------------------

void PlotPanel::choose(int number)
{
    if (std::size_t(number) >= m_views.size() || m_current == std::size_t(number))
        return;
    m_current = std::size_t(number);
    rebuildViews();
    rebuildList();
}

// --- frames and drawing ----------------------------------------------------------------------

void PlotPanel::takeSample(const ProbeSample& sample)
{
    if (sample.run != m_history.run())
        keepRun();
    m_history.add(sample);
}

void PlotPanel::take(const std::shared_ptr<const Frame>& frame)
{
    if (m_player.isLookingBack())
        return showPast(*frame);
    for (PlotView* view : m_views)
        view->chart().setCursor({});
    leavePlayed();
    if (frame->run != m_history.run())
        keepRun();
    m_history.add(*frame);
    if (frame->layout != m_layout) {
        m_layout = frame->layout;
        rebuildViews(); // the layout says the units of the probes
        askPast();
    }
    drawSoon();
}

// While the user looks back at the run that goes on, the curves stay and a line shows the instant
// that is looked at; another recording brings its own curves.
void PlotPanel::showPast(const Frame& frame)
{
    for (PlotView* view : m_views)
        view->chart().setCursor(frame.time);
    takePlayed(frame);
    if (frame.layout != m_layout) {
        m_layout = frame.layout;
        rebuildViews(); // no frame of a run may have come yet that says the units
    }
    drawSoon();
}

void PlotPanel::drawSoon()
{
    if (!isVisible() || m_redraw.isActive())
        return;
    double drawing = 0.0;
    for (const PlotView* view : m_views)
        drawing += view->drawingTime();
    m_redraw.start(int(std::clamp(shareOfTime * drawing, quickest, slowest)));
}

void PlotPanel::catchUp()
{
    while (isReading()) {
        std::this_thread::yield();
        takeReading();
    }
    if (!m_redraw.isActive())
        return;
    m_redraw.stop();
    draw();
    for (const PlotView* view : m_views)
        view->plotInSight().replot(); // which draw() leaves to the event loop
}

void PlotPanel::draw()
{
    m_bands.match(shownHistory());
    for (PlotView* view : m_views)
        view->draw(shownHistory(), shownBands(), shownEarlier());
    showValues();
}

// A reset, or another start, begins a new run.
void PlotPanel::keepRun()
{
    constexpr std::size_t most = 8; // runs, of which a person can tell the curves apart
    if (m_history.time().size() < 2)
        return;
    m_earlier.push_back({tr("run %1").arg(++m_runs), std::make_shared<const History>(m_history)});
    if (m_earlier.size() > most)
        m_earlier.erase(m_earlier.begin());
    giveEarlier();
}

void PlotPanel::forgetEarlier()
{
    m_earlier.clear();
    m_runs = 0;
    giveEarlier();
    drawSoon();
}

void PlotPanel::giveEarlier()
{
    for (PlotView* view : m_views)
        view->chart().setEarlier(shownEarlier());
}

void PlotPanel::follow(const Recordings& recordings)
{
    m_recordings = &recordings;
    const auto takeAll = [this] {
        takeEvents(*m_recordings);
        takeCertificates();
    };
    connect(&recordings, &Recordings::grew, this, [this] { takeEvents(*m_recordings); });
    connect(&recordings, &Recordings::listChanged, this, takeAll);
    connect(&recordings, &Recordings::certified, this, &PlotPanel::takeCertificates);
    if (m_player.isLookingBack())
        showPast(*m_player.frame());
}

void PlotPanel::takeEvents(const Recordings& recordings)
{
    const auto& recording = recordings.current();
    const std::uint64_t run = recording ? recording->run() : 0;
    std::vector<RunEvent> events = recording ? recording->events() : std::vector<RunEvent>();
    if (run == m_eventRun && events == m_events)
        return;
    m_eventRun = run;
    m_events = std::move(events);
    giveMarks();
}

void PlotPanel::giveMarks()
{
    std::vector<Mark> marks;
    if (m_eventRun == shownHistory().run())
        for (const RunEvent& event : m_events)
            marks.push_back({event.kind, event.time, describe(event, m_document.scene())});
    for (PlotView* view : m_views)
        view->chart().setMarks(marks);
}

void PlotPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        rebuildViews();
        rebuildList();
    }
}

void PlotPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    drawSoon();
}

// Panels stand beside each other in a wide dock, one below the other in a high one.
void PlotPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_panels->setOrientation(width() > height() ? Qt::Horizontal : Qt::Vertical);
}

void PlotPanel::clear()
{
    m_history.clear();
    drawSoon();
}

void PlotPanel::writeCsv(QIODevice& device, char separator) const
{
    writeCurves(device, shownHistory(), m_views[m_current]->curves(), shownBands(), separator);
}

} // namespace ripstop
