#include "editor/main_window.h"

#include "actions/dialogs.h"
#include "dialogs/builder_dialog.h"
#include "dialogs/rescue_dialog.h"
#include "document/autosave.h"
#include "document/document.h"
#include "document/event_words.h"
#include "document/measurement.h"
#include "document/player.h"
#include "document/recordings.h"
#include "document/selection.h"
#include "document/words.h"
#include "editor/draw_bar.h"
#include "editor/empty_hint.h"
#include "editor/hand_bar.h"
#include "editor/tour.h"
#include "editor/transform_bar.h"
#include "files/run_files.h"
#include "import/import_dialog.h"
#include "inspector/inspector.h"
#include "inspector/totals.h"
#include "inspector/tuning_panel.h"
#include "outline/outline.h"
#include "plots/plot_panel.h"
#include "problems/problem_list.h"
#include "start/samples.h"
#include "start/start_page.h"
#include "table/sheet_panel.h"
#include "timeline/timeline.h"
#include "timeline/timeline_strip.h"
#include "tools/pointing.h"
#include "tools/tool_strip.h"
#include "transport/control_keys.h"
#include "transport/control_strip.h"
#include "transport/gamepad.h"
#include "transport/transport.h"
#include "viewport/viewport.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QUndoView>

namespace ripstop {
namespace {

constexpr int layoutVersion = 2; // raised when docks change so that an old layout would mislead

QString droppedFile(const QMimeData* data)
{
    const QList<QUrl> urls = data->urls();
    return urls.size() == 1 ? urls.first().toLocalFile() : QString();
}

} // namespace

MainWindow::MainWindow(Document& document, Selection& selection, Player& player, Memory memory)
    : m_document(document)
    , m_selection(selection)
    , m_player(player)
    , m_memory(memory)
    , m_recordings(new Recordings(player, this))
    , m_viewport(new Viewport(document, selection, player))
    , m_start(new StartPage(this))
    , m_middle(new QStackedWidget(this))
    , m_outline(new Outline(document, selection, this))
    , m_inspector(new Inspector(document, selection, this))
    , m_plots(new PlotPanel(document, player, this))
    , m_problems(new ProblemList(document, selection, player, this))
    , m_transport(new Transport(document, player, this))
    , m_tuning(new TuningPanel(document, selection, m_inspector->sliders(), this))
    , m_table(new SheetPanel(
          document, selection, [this] { return measurementOf(m_player.frame()); }, this))
    , m_timeline(new Timeline(*m_recordings, this))
    , m_files(new Files(document, player, *m_viewport, *this))
    , m_runFiles(new RunFiles(document, *m_recordings, *m_files, *this))
    , m_dialogs(*this, document, selection, *m_viewport)
    , m_counts(new QLabel)
    , m_selected(new QLabel)
{
    m_inspector->sliders().remember(memory == Memory::Keep);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    setAcceptDrops(true);
    m_middle->addWidget(m_start);
    m_middle->addWidget(m_viewport);
    setCentralWidget(m_middle);

    buildDocks();
    buildActions();
    buildToolBar();
    buildStatusBar();
    connectParts();
    new EmptyHint(document, *m_viewport); // the view owns these
    new TransformBar(*m_viewport);
    new DrawBar(m_document, *m_viewport, m_drawSettings, *m_actions);
    auto* keys = new ControlKeys(document, player, this);
    keys->spare(&m_timeline->strip());
    qApp->installEventFilter(keys);
    new Gamepad(document, player, QStringLiteral("/dev/input"), this);

    resize(1280, 800);
    restoreLayout();
    showStartPage();
    showTitle();
    showCounts();
}

void MainWindow::buildDocks()
{
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    addDock("outline", tr("Outline"), m_outline, Qt::LeftDockWidgetArea);
    auto* history = new QUndoView(&m_document.history());
    history->setEmptyLabel(tr("The design as it was opened"));
    history->setToolTip(tr("Click a step to go back to it, or forward again."));
    addDock("history", tr("History"), history, Qt::LeftDockWidgetArea);
    tabifyDockWidget(m_docks["outline"], m_docks["history"]);
    m_docks["outline"]->raise();
    addDock("inspector", tr("Inspector"), m_inspector, Qt::RightDockWidgetArea);
    addDock("tuning", tr("Tuning"), m_tuning, Qt::RightDockWidgetArea);
    addDock("plots", tr("Plots"), m_plots, Qt::BottomDockWidgetArea);
    addDock("controls", tr("Controls"), new ControlStrip(m_document, m_player, this),
            Qt::BottomDockWidgetArea);
    addDock("problems", tr("Problems"), m_problems, Qt::BottomDockWidgetArea);
    tabifyDockWidget(m_docks["plots"], m_docks["controls"]);
    addDock("table", tr("Table"), m_table, Qt::BottomDockWidgetArea);
    tabifyDockWidget(m_docks["controls"], m_docks["problems"]);
    tabifyDockWidget(m_docks["problems"], m_docks["table"]);
    addDock("timeline", tr("Timeline"), m_timeline, Qt::BottomDockWidgetArea);
    tabifyDockWidget(m_docks["table"], m_docks["timeline"]);
    tabifyDockWidget(m_docks["inspector"], m_docks["tuning"]);
    m_docks["inspector"]->raise();
    m_docks["plots"]->raise();
    resizeDocks({m_docks["outline"], m_docks["inspector"]}, {250, 300}, Qt::Horizontal);
    resizeDocks({m_docks["plots"]}, {210}, Qt::Vertical);
}

void MainWindow::addDock(const QString& id, const QString& title, QWidget* widget,
                         Qt::DockWidgetArea area)
{
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(id); // restoreState() knows docks by this
    dock->setWidget(widget);
    addDockWidget(area, dock);
    m_docks[id] = dock;
}

bool MainWindow::showDock(const QString& id)
{
    const auto dock = m_docks.find(id);
    if (dock == m_docks.end())
        return false;
    dock->second->show();
    dock->second->raise();
    return true;
}

void MainWindow::buildActions()
{
    const auto keys = m_memory == Memory::Keep ? KeyMap::Memory::Keep : KeyMap::Memory::Ignore;
    m_actions = new Actions({*this,
                             m_document,
                             m_selection,
                             m_player,
                             *m_viewport,
                             *m_outline,
                             *m_files,
                             m_dialogs,
                             *m_tuning,
                             *m_inspector,
                             m_drawSettings,
                             *m_recordings,
                             *m_timeline,
                             *m_runFiles,
                             [this] { showStartPage(); },
                             [this] { importMesh({}); },
                             [this] { showTour(); },
                             [this](const QString& dock) { showDock(dock); },
                             [this](const QString& builder) { insert(builder); },
                             [this] { m_handBar->refresh(); }},
                            keys);
    m_handBar = new HandBar(m_document, m_player, *m_viewport, *m_actions); // the view owns it
    for (const auto& [id, dock] : m_docks)
        m_actions->addDockToggle(dock->toggleViewAction());
}

void MainWindow::buildToolBar()
{
    m_toolBar = addToolBar(tr("Main"));
    m_toolBar->setObjectName("main");
    m_toolBar->setMovable(false);
    m_toolBar->setIconSize(QSize(18, 18));
    for (const char* id : {"open", "save", "", "undo", "redo", "", "move", "rotate", "scale", "",
                           "fit", "home", "follow", "byStrain", "particles"})
        if (*id)
            m_toolBar->addAction((*m_actions)[id]);
        else
            m_toolBar->addSeparator();
    m_toolBar->addSeparator();
    m_toolBar->addWidget(m_transport);

    auto* strip = new ToolStrip(m_viewport);
    for (const QStringList& group :
         {QStringList{"toolPointer", "toolBox", "toolLasso"},
          QStringList{"drawParticles", "drawLinks", "drawPanels"},
          QStringList{"toolGrab", "toolCut", "toolFan"},
          QStringList{"takeParticles", "takeLinks", "takePanels"}, QStringList{"through"}}) {
        QList<QAction*> actions;
        for (const QString& id : group)
            actions << (*m_actions)[id];
        strip->addGroup(actions);
    }
    strip->move(12, 12);
}

void MainWindow::buildStatusBar()
{
    for (QLabel* label : {m_selected, m_counts}) {
        label->setContentsMargins(8, 0, 8, 0);
        statusBar()->addPermanentWidget(label);
    }
}

void MainWindow::connectParts()
{
    connect(m_files, &Files::opened, this, &MainWindow::showScene);
    const auto say = [this](const QString& message) { statusBar()->showMessage(message, 8000); };
    connect(&m_viewport->transformTool(), &TransformTool::said, this, say);
    connect(m_files, &Files::said, this, say);
    connect(m_runFiles, &RunFiles::said, this, say);
    connect(m_plots, &PlotPanel::said, this, say);
    connect(m_recordings, &Recordings::said, this, say);
    connect(m_recordings, &Recordings::reached, this, [this, say](const RunEvent& one, int more) {
        say(describe(one, m_document.scene(), more));
    });
    connect(m_recordings, &Recordings::failed, this, say);
    connect(m_recordings, &Recordings::ghostShown, m_viewport, &Viewport::showGhost);
    m_plots->markEventsOf(*m_recordings);
    connect(&m_document, &Document::replaced, m_recordings, &Recordings::clear);
    connect(m_files, &Files::recentChanged, this,
            [this] { m_start->setRecent(m_files->recent()); });
    connect(m_start, &StartPage::openRequested, m_files, &Files::open);
    connect(m_start, &StartPage::newRequested, m_files, &Files::startNew);
    connect(m_start, &StartPage::browseRequested, m_files, &Files::browse);
    connect(m_start, &StartPage::builderRequested, m_files, &Files::startFrom);
    connect(m_start, &StartPage::importRequested, this, [this] { importMesh({}); });
    connect(m_files, &Files::imported, this, [this](const std::vector<Id>& parts) {
        m_selection.set(parts);
        m_viewport->fit(parts);
    });

    connect(qApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState is) {
        if (is == Qt::ApplicationActive)
            m_files->lookAtDisk();
    });
    connect(m_start, &StartPage::tourRequested, this, &MainWindow::showTour);
    connect(&m_document, &Document::fileChanged, this, &MainWindow::showTitle);
    connect(&m_document, &Document::changed, this, &MainWindow::showCounts);
    connect(&m_document, &Document::replaced, this, &MainWindow::showCounts);
    m_selectedSoon.setSingleShot(true);
    m_selectedSoon.setInterval(50); // ms; a drag may select many times
    connect(&m_selectedSoon, &QTimer::timeout, this, &MainWindow::showSelected);
    connect(&m_selection, &Selection::changed, this, [this] { m_selectedSoon.start(); });
    connect(&m_viewport->pointing(), &Pointing::hoveredChanged, this, [this](Id id) {
        if (id == noId)
            return statusBar()->clearMessage();
        const auto& frame = m_player.frame();
        const QString reading = frame ? readingOf(*frame, id) : QString();
        statusBar()->showMessage(reading.isEmpty() ? summary({id})
                                                   : summary({id}) + " · " + reading);
    });
    connect(m_problems, &ProblemList::countChanged, this, [this](int errors, int warnings) {
        const int count = errors + warnings;
        m_docks["problems"]->setWindowTitle(count ? tr("Problems (%1)").arg(count)
                                                  : tr("Problems"));
        if (errors)
            m_docks["problems"]->raise();
    });
    connect(&m_player, &Player::stopped, this, [this](const QString& why) {
        m_docks["problems"]->show();
        m_docks["problems"]->raise();
        statusBar()->showMessage(why, 15000);
    });
}

void MainWindow::restoreLayout()
{
    m_start->setRecent(m_files->recent());
    if (m_memory == Memory::Ignore)
        return;
    const QSettings settings;
    restoreGeometry(settings.value("window/geometry").toByteArray());
    restoreState(settings.value("window/state").toByteArray(), layoutVersion);
    for (const auto& [id, dock] : m_docks)
        if (dock->isHidden())
            m_hidden.insert(id);
    m_actions->restoreView();
    m_runFiles->restoreMemory();
}

void MainWindow::showScene()
{
    if (m_middle->currentWidget() == m_start)
        for (const auto& [id, dock] : m_docks)
            dock->setVisible(!m_hidden.contains(id));
    m_middle->setCurrentWidget(m_viewport);
    m_docks["outline"]->raise();
    m_docks["plots"]->raise();
    m_viewport->setFocus();
}

void MainWindow::showViewOnly()
{
    for (const auto& [id, dock] : m_docks)
        dock->hide();
    m_toolBar->hide();
    menuBar()->hide();
    statusBar()->hide();
}

void MainWindow::showStartPage()
{
    // The start page has the window to itself; docks that were closed stay closed afterwards.
    if (m_middle->currentWidget() == m_viewport) {
        m_hidden.clear();
        for (const auto& [id, dock] : m_docks)
            if (dock->isHidden())
                m_hidden.insert(id);
    }
    for (const auto& [id, dock] : m_docks)
        dock->hide();
    m_start->setRecent(m_files->recent());
    m_middle->setCurrentWidget(m_start);
}

void MainWindow::showTitle()
{
    setWindowTitle(tr("%1[*] – Ripstop").arg(m_document.displayName()));
    setWindowFilePath(m_document.file());
    setWindowModified(m_document.isModified());
}

void MainWindow::showCounts()
{
    qsizetype particles = 0;
    qsizetype links = 0;
    qsizetype panels = 0;
    forEachPart(m_document.scene(), [&](Id, const Part& part) {
        particles += qsizetype(part.particles.size());
        links += qsizetype(part.links.size());
        panels += qsizetype(part.panels.size());
    });
    m_counts->setText(QStringList{counted(Kind::Particle, particles), counted(Kind::Link, links),
                                  counted(Kind::Panel, panels)}
                          .join(" · "));
    m_selectedSoon.start();
}

void MainWindow::showSelected()
{
    const auto& ids = m_selection.ids();
    if (ids.empty())
        return m_selected->clear();
    m_selected->setText(tr("Selected: %1").arg(summary(ids)));
}

// "3 particles of kite · 0.2 kg"
QString MainWindow::summary(const std::vector<Id>& ids) const
{
    const QString what = describe(m_document.scene(), ids);
    const QString sums = totals(m_document.scene(), ids);
    return sums.isEmpty() ? what : what + " · " + sums;
}

// Over a design, a sample when none is open.
void MainWindow::showTour()
{
    const QStringList samples = sampleFiles().filter("delta_kite");
    if (!m_document.scene().items.empty())
        showScene();
    else if (samples.isEmpty() || !m_files->open(samples.first()))
        return;
    const std::vector<TourStop> stops{
        {m_viewport, tr("The design, and its flight"),
         tr("Drag to turn, wheel to zoom, middle drag to move. Click selects; box and lasso are at "
            "the upper left. Keys G, R and S move, turn and scale what is selected.")},
        {m_docks["outline"], tr("Outline"),
         tr("Everything that the scene is made of: parts, materials, groups, controls, colliders. "
            "The tab History goes back to any step.")},
        {m_docks["inspector"], tr("Inspector"),
         tr("The values of what is selected, one thing or thousands. Type with units (12 cm, "
            "25 g), drag a label sideways, or change a value while the simulation runs.")},
        {m_transport, tr("Fly it"),
         tr("Space plays and pauses, the full stop does one step, Ctrl+R goes back to the "
            "design. Keys of the controls steer; they stand under Controls.")},
        {m_docks["plots"], tr("Measure it"),
         tr("Strain, energy, forces and probes as they happen. Problems of the design stand "
            "beside, each with a click to what it is about.")},
        {menuBar(), tr("Everything else"),
         tr("New from builder begins with a whole kite, glider or parachute; Import makes fabric "
            "of a mesh; Export is for Blender and ParaView. F3 finds any action, F1 shows the "
            "keys.")},
    };
    new Tour(stops, this); // deletes itself
}

void MainWindow::keepWork(const QString& folder)
{
    m_autosave = new Autosave(m_document, m_player.follower(), folder, Autosave::usualDelay, this);
    connect(m_autosave, &Autosave::failed, this,
            [this](const QString& why) { statusBar()->showMessage(why, 15000); });
    const QList<Rescue> found = leftBehind(folder);
    if (found.isEmpty())
        return;
    RescueDialog dialog(found, this);
    if (dialog.exec() != QDialog::Accepted || !m_files->mayDiscard())
        return;
    if (const auto failure = m_autosave->recover(*dialog.chosen()))
        QMessageBox::warning(this, tr("Cannot open what was left behind"),
                             translated(failure->message));
    else
        showScene();
}

// The start page stands for no scene, even if one is open behind it.
void MainWindow::importMesh(const QString& file)
{
    const bool isStart = m_middle->currentWidget() == m_start;
    m_files->importMesh(isStart ? Files::Into::NewScene : Files::Into::OpenScene, file);
}

// The dialog shows what it inserts in the view, so the design is there and not a run.
void MainWindow::insert(const QString& builder)
{
    if (m_middle->currentWidget() == m_start)
        return m_files->startFrom(builder);
    m_viewport->transformTool().goToDesign();
    BuilderDialog dialog(builder, {m_document, m_selection, m_viewport->camera().focus}, this);
    connect(&dialog, &BuilderDialog::shown, m_viewport,
            [this](const std::vector<Id>& bodies) { m_viewport->fit(bodies); });
    const Camera before = m_viewport->camera();
    if (dialog.exec() == QDialog::Rejected)
        m_viewport->look(before); // the preview took it elsewhere
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!m_files->mayDiscard())
        return event->ignore();
    if (m_memory == Memory::Keep) {
        if (m_middle->currentWidget() == m_start)
            showScene(); // the layout to remember is that with docks
        QSettings settings;
        settings.setValue("window/geometry", saveGeometry());
        settings.setValue("window/state", saveState(layoutVersion));
        m_actions->keepView();
    }
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    const QString file = droppedFile(event->mimeData());
    if (file.endsWith(".json", Qt::CaseInsensitive) || ImportDialog::isMesh(file)
        || RunFiles::isRecording(file))
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    const QString file = droppedFile(event->mimeData());
    const bool isRun = RunFiles::isRecording(file);
    if (!isRun && !ImportDialog::isMesh(file)) {
        m_files->open(file);
        return;
    }
    event->acceptProposedAction();
    // later: who drops waits until the event is done, and the dialog stays open
    QMetaObject::invokeMethod(
        this, [this, file, isRun] { isRun ? openRun(file) : importMesh(file); },
        Qt::QueuedConnection);
}

void MainWindow::openRun(const QString& file)
{
    m_runFiles->open(file);
    showDock("timeline");
}

} // namespace ripstop
