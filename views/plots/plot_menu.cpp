// The context menu of the plots dock. showMenu() puts it together from sections: how the curves of
// the chosen panel are drawn, its ranges, the panels themselves, and output to files and the
// clipboard. Each choice changes a copy of the Plot that is shown and hands it to
// PlotPanel::change(), which makes an edit of it when the scene keeps that Plot.
#include "document/ask_file.h"
#include "document/document.h"
#include "document/plain_text.h"
#include "icons/icon.h"
#include "plots/chart_picture.h"
#include "plots/plot_panel.h"

#include <QBuffer>
#include <QClipboard>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QSaveFile>

namespace ripstop {
namespace {

// Adds an action that changes a copy of the plot that is shown when it is triggered.
template <typename Change>
QAction* addChoice(QMenu& menu, PlotPanel& panel, const QString& text, bool checked, Change change)
{
    QAction* action = menu.addAction(text);
    action->setCheckable(true);
    action->setChecked(checked);
    QObject::connect(action, &QAction::triggered, &panel, [&panel, change] {
        Plot plot = panel.view().plot();
        change(plot);
        panel.change(plot);
    });
    return action;
}

} // namespace

void PlotPanel::showMenu(const QPoint& place) { contextMenu()->exec(place); }

std::unique_ptr<QMenu> PlotPanel::contextMenu()
{
    auto made = std::make_unique<QMenu>(this);
    QMenu& menu = *made;
    menu.setToolTipsVisible(true);
    QAction* follow = menu.addAction(tr("Follow the run"), &chart(), &Chart::follow);
    follow->setEnabled(!chart().follows());
    addWays(menu);
    addRanges(menu);
    addBands(menu);
    menu.addSeparator();
    addPanels(menu);
    menu.addSeparator();
    addOutput(menu);
    menu.addSeparator();
    menu.addAction(icon(QStringLiteral("delete")), tr("Clear"), this, &PlotPanel::clear);
    QAction* forget = menu.addAction(tr("Clear earlier runs"), this, &PlotPanel::forgetEarlier);
    forget->setEnabled(!m_earlier.empty());
    return made;
}

void PlotPanel::addWays(QMenu& menu)
{
    const Plot& now = plotOf(m_current);
    QMenu* against = menu.addMenu(tr("Curves against"));
    addChoice(*against, *this, tr("time"), now.axis == PlotAxis::Time,
              [](Plot& plot) { plot.axis = PlotAxis::Time; });
    for (const Entry& entry : m_probes) {
        const Id id = entry.id;
        addChoice(*against, *this, inMenu(QString::fromStdString(std::get<Probe>(entry.item).name)),
                  now.axis == PlotAxis::Probe && now.against == id, [id](Plot& plot) {
                      plot.axis = PlotAxis::Probe;
                      plot.against = id;
                  });
    }
    const bool spectra = now.axis == PlotAxis::Frequency;
    addChoice(menu, *this, tr("Spectra"), spectra, [spectra](Plot& plot) {
        plot.axis = spectra ? PlotAxis::Time : PlotAxis::Frequency;
    });
    addChoice(menu, *this, tr("Logarithmic values"), now.logarithmic,
              [](Plot& plot) { plot.logarithmic = !plot.logarithmic; });
}

void PlotPanel::addRanges(QMenu& menu)
{
    const Plot& now = plotOf(m_current);
    if (now.axis == PlotAxis::Time)
        addChoice(menu, *this, tr("Show the whole run"), now.seconds == 0.0, [](Plot& plot) {
            plot.seconds = plot.seconds == 0.0 ? Plot().seconds : 0.0;
        })->setToolTip(tr("Off, the latest half minute is shown."));
    const auto shown = view().valueRange();
    QAction* keep = addChoice(menu, *this, tr("Keep this range of values"), now.low || now.high,
                              [shown](Plot& plot) {
                                  const bool kept = plot.low || plot.high;
                                  plot.low = kept ? std::nullopt : std::optional(shown->first);
                                  plot.high = kept ? std::nullopt : std::optional(shown->second);
                              });
    keep->setEnabled(shown.has_value());
    keep->setToolTip(tr("Off, the axis fits the curves. Needs curves of one unit."));
}

void PlotPanel::addPanels(QMenu& menu)
{
    menu.addAction(icon(QStringLiteral("add")), tr("Add a plot"), this, &PlotPanel::addPlot)
        ->setToolTip(tr("Another panel, with curves of its own. The scene keeps it."));
    if (m_plots.empty()) {
        menu.addAction(tr("Keep this plot in the scene"), this, &PlotPanel::keepPlot)
            ->setToolTip(tr("It is saved with the scene and comes back with it."));
        return;
    }
    const Plot& now = plotOf(m_current);
    std::vector<Id> drawn;
    for (const Curve& curve : view().curves())
        drawn.push_back(Id{curve.probe});
    addChoice(
        menu, *this, tr("Probes of its own"), !now.probes.empty(),
        [drawn](Plot& plot) { plot.probes = plot.probes.empty() ? drawn : std::vector<Id>(); })
        ->setToolTip(tr("Off, the plot has all probes that are ticked for plots without their "
                        "own."));
    menu.addAction(tr("Rename the plot\u2026"), this, &PlotPanel::rename);
    menu.addAction(icon(QStringLiteral("delete")), tr("Remove this plot"), this,
                   [this] { removePlot(int(m_current)); });
}

void PlotPanel::rename()
{
    Plot plot = plotOf(m_current);
    bool accepted = false;
    const QString name =
        QInputDialog::getText(this, tr("Rename the plot"), tr("Name:"), QLineEdit::Normal,
                              QString::fromStdString(plot.name), &accepted);
    if (!accepted || name.trimmed().isEmpty())
        return;
    plot.name = name.trimmed().toStdString();
    change(plot);
}

void PlotPanel::addOutput(QMenu& menu)
{
    QAction* save = menu.addAction(icon(QStringLiteral("table")), tr("Save as CSV\u2026"), this,
                                   &PlotPanel::saveCsv);
    menu.addAction(icon(QStringLiteral("picture")), tr("Save picture\u2026"), this,
                   &PlotPanel::savePicture);
    QAction* copy = menu.addAction(tr("Copy the table"), this, &PlotPanel::copyTable);
    for (QAction* table : {save, copy}) {
        table->setEnabled(hasValues());
        if (!table->isEnabled())
            table->setToolTip(tr("There is no value to write: what is plotted has read nothing."));
    }
    menu.addAction(tr("Copy the picture"), this, [this] {
        QGuiApplication::clipboard()->setPixmap(pictureOf(view().plotInSight()));
    });
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
    const QString name = askWhereToSave(this, tr("Save the curves"), suggestedFile(".csv"),
                                        tr("CSV (*.csv)"), QStringLiteral("csv"));
    if (name.isEmpty())
        return;
    QSaveFile file(name);
    const bool opened = file.open(QIODevice::WriteOnly);
    if (opened)
        writeCsv(file);
    if (opened && file.commit())
        emit said(tr("Saved %1").arg(QDir::toNativeSeparators(name)));
    else
        QMessageBox::warning(this, tr("Save the curves"),
                             tr("%1 cannot be written: %2.").arg(name, file.errorString()));
}

void PlotPanel::savePicture()
{
    const QString name =
        askWhereToSave(this, tr("Save the picture"), suggestedFile(".png"),
                       tr("PNG (*.png);;SVG (*.svg);;PDF (*.pdf)"), QStringLiteral("png"));
    if (name.isEmpty())
        return;
    if (ripstop::savePicture(view().plotInSight(), name))
        emit said(tr("Saved %1").arg(QDir::toNativeSeparators(name)));
    else
        QMessageBox::warning(this, tr("Save the picture"), tr("%1 cannot be written.").arg(name));
}

} // namespace ripstop
