// The dock of plots: live curves of the probes of the scene, in one panel for each Plot that the
// scene has, or in a single panel that belongs to no Plot.
//
// A list at the side says which probes the chosen panel draws and what they read: now, or at the
// time under the mouse. Runs that are over stay as thin curves, at most eight of them, until they
// are cleared. Panels that the scene keeps are changed by edits, so that undo covers them; the
// panel that belongs to no Plot is changed in place.
//
// While a recording is looked back at that is not of the run that goes on, the curves are those of
// that recording, and the run is one of the thin ones.
//
// It is a widget: only the window's thread uses it. Seven sources share it: plot_panel.cpp, the
// list in plot_list.cpp, the context menu in plot_menu.cpp, the edits of panels in
// plot_arrangement.cpp, the bands of certificates in plot_bands.cpp, the past of new probes in
// plot_past.cpp, and recordings that are looked back at in plot_played.cpp.
#pragma once

#include "document/worker.h"
#include "plots/error_bands.h"
#include "plots/plot_view.h"
#include "recording/probe_past.h"
#include "scene/scene.h"

#include <QTimer>

#include <atomic>
#include <map>

class QIODevice;
class QMenu;
class QScrollArea;
class QSplitter;
class QStackedWidget;
class QTreeWidget;
class QTreeWidgetItem;

namespace ripstop {

class Document;
class Player;
class Recordings;

class PlotPanel final : public QWidget
{
    Q_OBJECT

public:
    PlotPanel(Document& document, Player& player, QWidget* parent = nullptr);
    ~PlotPanel() override;

    // Goes on with what another panel has drawn, which is about to go.
    void takeOver(const PlotPanel& before);

    const History& history() const { return m_history; }
    void clear(); // forgets the samples until now; the run goes on
    const std::vector<EarlierRun>& earlier() const { return m_earlier; }
    void forgetEarlier();

    // Marks what happens in the run that is drawn, as its recording has it, and shades how far its
    // values may be off, as certificates of recordings and of the design have it.
    void follow(const Recordings& recordings);
    void showErrorBands(bool shown); // they are, at first
    // Of the samples that are drawn; as of the latest drawing.
    const ErrorBands& errorBands() const { return m_bands; }

    // Draws what it has put off, so that a picture of the window shows one moment.
    void catchUp();

    // --- panels ---
    int viewCount() const { return int(m_views.size()); }
    PlotView& view(int number) { return *m_views[std::size_t(number)]; }
    PlotView& view() { return *m_views[m_current]; } // the chosen one
    Chart& chart() { return view().chart(); }
    void choose(int number);
    void addPlot();  // another one beside those there are; the scene keeps all of them then
    void keepPlot(); // makes the panel that belongs to no Plot one of the scene
    void removePlot(int number);
    void change(const Plot& wanted); // changes the chosen panel: by an edit when the scene has it

    // The curves that the chosen panel draws: a header with units, a row for each sample.
    void writeCsv(QIODevice& device, char separator = ',') const;
    bool hasValues() const; // that would be in that table
    std::unique_ptr<QMenu> contextMenu();

signals:
    void said(const QString& words); // for the status bar

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void layOut();
    void refresh(); // which probes and plots there are
    void rebuildViews();
    PlotView* newView();
    std::vector<Curve> curvesOf(const Plot& plot) const;
    const Plot& plotOf(std::size_t view) const;
    AxisWords acrossOf(const Plot& plot) const;
    void takeSample(const ProbeSample& sample);
    void take(const std::shared_ptr<const Frame>& frame);
    void showPast(const Frame& frame);
    void draw();
    void drawSoon();
    void keepRun();
    void giveEarlier();
    void takeEvents(const Recordings& recordings);
    void giveMarks();

    // certificates (plot_bands.cpp)
    void takeCertificates();
    const ErrorBands* shownBands() const { return m_wantsBands ? &m_bands : nullptr; }
    QString errorText(std::uint32_t probe, std::optional<double> time) const;
    void addBands(QMenu& menu);

    // the past of probes that a run went without (plot_past.cpp)
    struct PastWish
    {
        std::shared_ptr<const Recording> recording;
        std::vector<Entry> probes;
        int number = 0; // of the reading of a recording that is looked back at
    };
    struct PastFound
    {
        std::uint64_t run = 0;
        int number = 0; // of the wish
        std::vector<Layout::Probe> probes;
        ProbePast past;
    };
    static PastFound findPast(const PastWish& wish, const Progress& progress);
    void askPast();
    void takePast();
    QString nameOf(const Entry& probe) const; // and since when it is known, if not from the start

    // a recording that is looked back at (plot_played.cpp)
    const History& shownHistory() const { return m_played ? m_playedHistory : m_history; }
    std::vector<EarlierRun> shownEarlier() const; // the other runs, drawn thin
    void takePlayed(const Frame& frame);
    void leavePlayed();
    void fillPlayed(const Certificate& certificate, const Frame& frame);
    void readPlayed();
    void takeReading();
    bool isReading() const { return m_isOfFrames && m_playedHistory.time().empty(); }
    void noteTears();                           // of the recording
    QString lackOf(const PlotView& view) const; // why it has no curve, or empty

    // the list of probes (plot_list.cpp)
    void rebuildList();
    void showValues();
    void tick(QTreeWidgetItem* item);       // draws a probe, or not
    bool isDrawn(const Entry& probe) const; // in the chosen panel
    QString unitOf(Id probe) const;         // as the newest frame has it

    // the context menu (plot_menu.cpp)
    void showMenu(const QPoint& place);
    void addWays(QMenu& menu);
    void addRanges(QMenu& menu);
    void addPanels(QMenu& menu);
    void addOutput(QMenu& menu);
    void rename();
    void copyTable() const;
    void saveCsv();
    void savePicture();
    QString suggestedFile(const char* suffix) const;

    Document& m_document;
    Player& m_player;
    std::vector<Entry> m_probes;            // as the list shows them
    std::vector<Entry> m_plots;             // of the scene
    Plot m_own;                             // what is shown when the scene has none
    std::vector<PlotView*> m_views;         // [m_plots], or one
    std::size_t m_current = 0;              // of m_views
    std::shared_ptr<const Layout> m_layout; // of the newest frame
    History m_history;
    std::vector<EarlierRun> m_earlier;
    int m_runs = 0; // that have been kept, for their names
    std::uint64_t m_eventRun = 0;
    std::vector<RunEvent> m_events;  // of that run
    std::optional<double> m_hovered; // s
    QTimer m_redraw;
    const Recordings* m_recordings = nullptr;                // null until follow()
    std::map<std::uint64_t, std::vector<Entry>> m_pastAsked; // by run: probes that were asked for
    ErrorBands m_bands;
    bool m_wantsBands = true;
    // The recording that is looked back at, unless it is of the run that goes on; null: none is.
    std::shared_ptr<const Recording> m_played;
    std::shared_ptr<const Certificate> m_playedCertificate; // of it; null: it has none
    History m_playedHistory;
    std::optional<EarlierRun> m_left; // the run that goes on, meanwhile, where it has curves
    bool m_isOfFrames = false;        // m_playedHistory comes from its frames

    QStackedWidget* m_pages;
    QTreeWidget* m_list;
    QSplitter* m_panels;

    std::atomic<bool> m_isOver = false;
    std::atomic<int> m_reading = 0;           // number of the newest; earlier ones end early
    Worker<PastWish, PastFound> m_pastFinder; // last: these end before what they use
    Worker<PastWish, PastFound> m_reader;
};

} // namespace ripstop
