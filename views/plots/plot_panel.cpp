#include "plots/plot_panel.h"

#include "base/laws.h"
#include "document/document.h"
#include "document/player.h"
#include "document/words.h"
#include "icons/icon.h"
#include "icons/swatch.h"
#include "io/csv.h"
#include "plots/chart_picture.h"
#include "plots/curve_color.h"
#include "plots/curve_views.h"

#include <QBuffer>
#include <QClipboard>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QSaveFile>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStackedWidget>
#include <QTextStream>
#include <QTreeWidget>

#include <cmath>

namespace ripstop {
namespace {

constexpr int redrawInterval = 33; // ms, about 30 pictures a second
constexpr int listWidth = 210;     // px

QLabel* hint(const QString& text)
{
    auto* label = new QLabel(text);
    label->setAlignment(Qt::AlignCenter);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setWordWrap(true);
    return label;
}

QString shown(double value, const QString& unit)
{
    if (std::isnan(value))
        return QString(QChar(0x2013)); // dash: nothing to read
    const QString number = QLocale().toString(value, 'g', 4);
    return unit.isEmpty() ? number : number + QChar(0x00a0) + unit;
}

} // namespace

PlotPanel::PlotPanel(Document& document, Player& player, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_player(player)
    , m_pages(new QStackedWidget)
    , m_list(new QTreeWidget)
    , m_chartPages(new QStackedWidget)
    , m_chart(new Chart)
    , m_xy(new XyChart)
{
    layOut();
    m_redraw.setSingleShot(true);
    m_redraw.setInterval(redrawInterval);
    connect(&m_redraw, &QTimer::timeout, this, &PlotPanel::draw);
    connect(&document, &Document::changed, this, &PlotPanel::refresh);
    connect(&document, &Document::replaced, this, [this] {
        m_history.clear();
        forgetEarlier();
        setWay({});
        refresh();
    });
    connect(&player, &Player::frameReady, this, &PlotPanel::take);
    connect(m_list, &QTreeWidget::itemChanged, this, &PlotPanel::tick);
    connect(m_chart, &Chart::followed, this, &PlotPanel::drawSoon);
    connect(m_chart, &Chart::hovered, this, [this](std::optional<double> time) {
        m_hovered = time;
        showValues();
    });
    m_chart->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_chart, &QWidget::customContextMenuRequested, this,
            [this](const QPoint& place) { showMenu(m_chart->mapToGlobal(place)); });
    m_xy->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_xy, &QWidget::customContextMenuRequested, this,
            [this](const QPoint& place) { showMenu(m_xy->mapToGlobal(place)); });
    refresh();
    if (player.frame())
        take(player.frame());
}

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

    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(m_chart);
    m_chartPages->addWidget(scroll);
    m_chartPages->addWidget(hint(tr("Tick a probe to plot it.")));
    m_chartPages->addWidget(m_xy);

    auto* splitter = new QSplitter;
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(m_list);
    splitter->addWidget(m_chartPages);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({listWidth, 3 * listWidth});
    m_pages->addWidget(splitter);
    m_pages->addWidget(hint(tr("No probes. Add one in the outline to plot it.")));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_pages);
}

void PlotPanel::refresh()
{
    std::vector<Entry> probes;
    for (const Entry& entry : m_document.scene().items)
        if (std::holds_alternative<Probe>(entry.item))
            probes.push_back(entry);
    if (probes != m_probes) {
        m_probes = std::move(probes);
        rebuildList();
        rebuildCurves();
    }
    m_pages->setCurrentIndex(m_probes.empty() ? 1 : 0);
}

void PlotPanel::rebuildList()
{
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    for (std::size_t i = 0; i < m_probes.size(); ++i) {
        const auto& probe = std::get<Probe>(m_probes[i].item);
        auto* item = new QTreeWidgetItem(m_list, {QString::fromStdString(probe.name)});
        item->setCheckState(0, probe.plotted ? Qt::Checked : Qt::Unchecked);
        item->setIcon(0, swatch(curveColor(int(i), palette())));
        item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        item->setToolTip(0, choiceLabel(choiceNames<Quantity>[std::size_t(probe.quantity)]));
    }
    showValues();
}

void PlotPanel::rebuildCurves()
{
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < m_probes.size(); ++i) {
        const auto& probe = std::get<Probe>(m_probes[i].item);
        if (probe.plotted)
            curves.push_back({std::uint32_t(m_probes[i].id), QString::fromStdString(probe.name),
                              unitOf(m_probes[i].id), curveColor(int(i), palette())});
    }
    m_chart->setCurves(std::move(curves));
    showPage();
    drawSoon();
}

QString PlotPanel::unitOf(Id id) const
{
    if (const auto& frame = m_player.frame())
        for (const Layout::Probe& probe : frame->layout->probes)
            if (probe.id == std::uint32_t(id))
                return QString::fromStdString(probe.unit);
    return {};
}

void PlotPanel::take(const std::shared_ptr<const Frame>& frame)
{
    if (m_player.isLookingBack())
        return showPast(*frame);
    m_chart->setCursor({});
    if (frame->run != m_history.run())
        keepRun();
    m_history.add(*frame);
    if (frame->layout != m_layout) {
        m_layout = frame->layout;
        rebuildCurves(); // units
    }
    drawSoon();
}

// The curves stay; a line stands where one looks.
void PlotPanel::showPast(const Frame& frame)
{
    m_chart->setCursor(frame.time);
    drawSoon();
}

void PlotPanel::drawSoon()
{
    if (isVisible() && !m_redraw.isActive())
        m_redraw.start();
}

void PlotPanel::draw()
{
    if (m_way.of == Way::Of::OverTime)
        m_chart->draw(m_history);
    else
        drawXy();
    showValues();
}

void PlotPanel::drawXy()
{
    const std::vector<Curve>& curves = m_chart->curves();
    QString unit = curves.empty() ? QString() : curves.front().unit;
    for (const Curve& curve : curves)
        if (curve.unit != unit)
            unit = tr("each in its unit");
    if (m_way.of == Way::Of::Spectra)
        return m_xy->show(tr("frequency (Hz)"), tr("amplitude (%1)").arg(unit),
                          spectra(m_history, m_earlier, curves));
    const Probe* across = findItem<Probe>(m_document.scene(), m_way.across);
    if (!across) // it is gone
        return setWay({});
    const QString name = QString::fromStdString(across->name);
    const QString acrossUnit = unitOf(m_way.across);
    m_xy->show(acrossUnit.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, acrossUnit), unit,
               phaseCurves(m_history, m_earlier, curves, std::uint32_t(m_way.across)));
}

void PlotPanel::setWay(const Way& way)
{
    m_way = way;
    showPage();
    drawSoon();
}

void PlotPanel::showPage()
{
    m_chartPages->setCurrentIndex(m_chart->curves().empty()       ? 1
                                  : m_way.of == Way::Of::OverTime ? 0
                                                                  : 2);
}

// A reset, or another start, begins a new run.
void PlotPanel::keepRun()
{
    constexpr std::size_t most = 8; // runs, of which a person can tell the curves apart
    if (m_history.time().size() < 2)
        return;
    m_earlier.push_back({tr("run %1").arg(++m_runs), m_history});
    if (m_earlier.size() > most)
        m_earlier.erase(m_earlier.begin());
    m_chart->setEarlier(m_earlier);
}

void PlotPanel::forgetEarlier()
{
    m_earlier.clear();
    m_runs = 0;
    m_chart->setEarlier(m_earlier);
    drawSoon();
}

// What the probes read at the time under the mouse, or now.
void PlotPanel::showValues()
{
    const bool past = m_hovered && !m_history.time().empty();
    const std::size_t sample = past ? m_history.nearest(*m_hovered) : 0;
    m_list->setHeaderLabels(
        {tr("Probe"), past ? tr("at %1 s").arg(QLocale().toString(m_history.time()[sample], 'f', 2))
                           : tr("now")});
    const auto& frame = m_player.frame();
    for (std::size_t i = 0; i < m_probes.size(); ++i) {
        const auto id = std::uint32_t(m_probes[i].id);
        double value = std::nan("");
        if (past) {
            const auto values = m_history.valuesOf(id);
            if (sample < values.size())
                value = values[sample];
        } else if (frame) {
            const auto& probes = frame->layout->probes;
            for (std::size_t p = 0; p < probes.size(); ++p)
                if (probes[p].id == id)
                    value = frame->probe[p];
        }
        const QSignalBlocker quiet(m_list);
        m_list->topLevelItem(int(i))->setText(1, shown(value, unitOf(m_probes[i].id)));
    }
    m_list->viewport()->update(); // its signals were blocked
}

void PlotPanel::tick(QTreeWidgetItem* item)
{
    const int row = m_list->indexOfTopLevelItem(item);
    const Entry& entry = m_probes[std::size_t(row)];
    const auto& probe = std::get<Probe>(entry.item);
    const bool plotted = item->checkState(0) == Qt::Checked;
    if (plotted == probe.plotted)
        return;
    // Not at once: the edit makes the list anew, and with it the item that is still speaking.
    const auto push = [this, id = entry.id, plotted] {
        const auto* ticked = findItem<Probe>(m_document.scene(), id);
        const Property* property = findProperty(Kind::Probe, "plotted");
        if (ticked && ticked->plotted != plotted)
            m_document.push({(plotted ? "Plot " : "Do not plot ") + ticked->name,
                             {SetValues{property, {id}, {plotted}}}});
    };
    QMetaObject::invokeMethod(this, push, Qt::QueuedConnection);
}

void PlotPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        rebuildList();
        rebuildCurves();
    }
}

void PlotPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    drawSoon();
}

void PlotPanel::clear()
{
    m_history.clear();
    drawSoon();
}

// --- the context menu ------------------------------------------------------------------------

void PlotPanel::showMenu(const QPoint& place)
{
    QMenu menu(this);
    QAction* whole = menu.addAction(tr("Show the whole run"));
    whole->setCheckable(true);
    whole->setChecked(m_chart->showsWholeRun());
    whole->setToolTip(tr("Off, the latest half minute is shown."));
    connect(whole, &QAction::toggled, m_chart, &Chart::setWholeRun);
    QAction* follow = menu.addAction(tr("Follow the run"), m_chart, &Chart::follow);
    follow->setEnabled(!m_chart->follows());
    addWays(menu);
    menu.addSeparator();
    menu.addAction(icon(QStringLiteral("table")), tr("Save as CSV\u2026"), this,
                   &PlotPanel::saveCsv);
    menu.addAction(icon(QStringLiteral("picture")), tr("Save picture\u2026"), this,
                   &PlotPanel::savePicture);
    menu.addAction(tr("Copy the table"), this, &PlotPanel::copyTable);
    menu.addAction(tr("Copy the picture"), this,
                   [this] { QGuiApplication::clipboard()->setPixmap(pictureOf(plotInSight())); });
    menu.addSeparator();
    menu.addAction(icon(QStringLiteral("delete")), tr("Clear"), this, &PlotPanel::clear);
    QAction* forget = menu.addAction(tr("Clear earlier runs"), this, &PlotPanel::forgetEarlier);
    forget->setEnabled(!m_earlier.empty());
    menu.exec(place);
}

void PlotPanel::addWays(QMenu& menu)
{
    QAction* logarithmic = menu.addAction(tr("Logarithmic values"));
    logarithmic->setCheckable(true);
    logarithmic->setChecked(m_chart->isLogarithmic());
    connect(logarithmic, &QAction::toggled, this, [this](bool on) {
        m_chart->setLogarithmic(on);
        m_xy->setLogarithmic(on);
    });
    QMenu* against = menu.addMenu(tr("Curves against"));
    const auto add = [&](QMenu& to, const QString& text, const Way& way) {
        QAction* action = to.addAction(text, this, [this, way] { setWay(way); });
        action->setCheckable(true);
        action->setChecked(way == m_way);
    };
    add(*against, tr("time"), {});
    for (const Entry& entry : m_probes)
        add(*against, QString::fromStdString(std::get<Probe>(entry.item).name),
            {Way::Of::Against, entry.id});
    add(menu, tr("Spectra"), {Way::Of::Spectra, {}});
}

QCustomPlot& PlotPanel::plotInSight()
{
    return m_way.of == Way::Of::OverTime ? m_chart->plot() : m_xy->plot();
}

void PlotPanel::copyTable() const
{
    QBuffer text;
    text.open(QIODevice::WriteOnly);
    writeCsv(text, '\t'); // as spreadsheets paste it
    QGuiApplication::clipboard()->setText(QString::fromUtf8(text.data()));
}

QString PlotPanel::suggestedFile(const char* suffix) const
{
    const QString name = m_document.displayName().remove(QStringLiteral(".ripstop.json"));
    const QString folder = m_document.file().isEmpty()
                               ? QDir::homePath()
                               : QFileInfo(m_document.file()).absolutePath();
    return QDir(folder).filePath(name + QLatin1String(suffix));
}

void PlotPanel::saveCsv()
{
    const QString name = QFileDialog::getSaveFileName(this, tr("Save the curves"),
                                                      suggestedFile(".csv"), tr("CSV (*.csv)"));
    if (name.isEmpty())
        return;
    QSaveFile file(name);
    const bool opened = file.open(QIODevice::WriteOnly);
    if (opened)
        writeCsv(file);
    if (!opened || !file.commit())
        QMessageBox::warning(this, tr("Save the curves"),
                             tr("%1 cannot be written: %2.").arg(name, file.errorString()));
}

void PlotPanel::savePicture()
{
    const QString name =
        QFileDialog::getSaveFileName(this, tr("Save the picture"), suggestedFile(".png"),
                                     tr("PNG (*.png);;SVG (*.svg);;PDF (*.pdf)"));
    if (!name.isEmpty() && !ripstop::savePicture(plotInSight(), name))
        QMessageBox::warning(this, tr("Save the picture"), tr("%1 cannot be written.").arg(name));
}

void PlotPanel::writeCsv(QIODevice& device, char separator) const
{
    QTextStream out(&device);
    out << "time (s)";
    for (const Curve& curve : m_chart->curves()) {
        const QString name =
            curve.unit.isEmpty() ? curve.name : curve.name + " (" + curve.unit + ')';
        out << separator << QString::fromStdString(csvCell(name.toStdString(), separator));
    }
    out << '\n';
    const auto time = m_history.time();
    for (std::size_t i = 0; i < time.size(); ++i) {
        out << QString::number(time[i], 'g', QLocale::FloatingPointShortest);
        for (const Curve& curve : m_chart->curves()) {
            const auto values = m_history.valuesOf(curve.probe);
            out << separator;
            if (i < values.size() && !std::isnan(values[i]))
                out << QString::number(values[i], 'g', QLocale::FloatingPointShortest);
        }
        out << '\n';
    }
}

} // namespace ripstop
