// Stages: the constructor makes the parts, then docks, actions, the tool bar and the bars over the
// view in this order, because actions reach panels through the docks and the bars take actions by
// their ids; then it connects the parts and restores the layout. Below stand the switch between
// start page and view, the title, and what is dropped on the window. What is kept from run to run
// and from window to window is in main_window_memory.cpp.
#include "editor/main_window.h"

#include "actions/menus.h"
#include "actions/workbench.h"
#include "document/document.h"
#include "document/player.h"
#include "document/recordings.h"
#include "document/selection.h"
#include "editor/brush_bar.h"
#include "editor/draw_bar.h"
#include "editor/empty_hint.h"
#include "editor/focus_return.h"
#include "editor/hand_bar.h"
#include "editor/shown_break.h"
#include "editor/status_line.h"
#include "editor/tool_bars.h"
#include "editor/transform_bar.h"
#include "editor/wheel_guard.h"
#include "editor/window_tour.h"
#include "files/arrivals.h"
#include "files/kept_work.h"
#include "files/run_files.h"
#include "import/import_dialog.h"
#include "inspector/inspector.h"
#include "loads/load_panel.h"
#include "start/start_page.h"
#include "study/study_panel.h"
#include "timeline/timeline.h"
#include "timeline/timeline_strip.h"
#include "transport/control_keys.h"
#include "transport/gamepad.h"
#include "transport/transport.h"
#include "viewport/viewport.h"

#include <QApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>

namespace ripstop {
namespace {

QString droppedFile(const QMimeData* data)
{
    const QList<QUrl> urls = data->urls();
    return urls.size() == 1 ? urls.first().toLocalFile() : QString();
}

} // namespace

MainWindow::MainWindow(Document& document, Selection& selection, Player& player, Memory memory)
    : MainWindow(document, selection, player, memory, {}, nullptr)
{}

MainWindow::MainWindow(Document& document, Selection& selection, Player& player, Memory memory,
                       const DrawSettings& drawSettings, Recordings* recordings)
    : m_document(document)
    , m_selection(selection)
    , m_player(player)
    , m_memory(memory)
    , m_drawSettings(drawSettings)
    , m_recordings(recordings ? recordings : new Recordings(player))
    , m_viewport(new Viewport(document, selection, player))
    , m_start(new StartPage(this))
    , m_middle(new QStackedWidget(this))
    , m_transport(new Transport(document, player, *m_recordings, this))
    , m_status(new StatusLine(*statusBar(), document, selection, player))
    , m_files(new Files(document, player, *m_viewport, *this))
    , m_runFiles(new RunFiles(document, *m_recordings, *m_files, *this))
    , m_arrivals(new Arrivals(
          document, selection, *m_viewport, *m_files, [this] { return isSceneShown(); }, *this))
    , m_keptWork(new KeptWork(document, player, *m_files, *this))
    , m_dialogs(*this, document, selection, *m_viewport)
{
    m_recordings->setParent(this);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    setAcceptDrops(true);
    m_middle->addWidget(m_start);
    m_middle->addWidget(m_viewport);
    setCentralWidget(m_middle);

    buildDocks();
    buildActions();
    buildToolBar();
    buildBarsOfView();
    buildInputs();
    connectStart();
    connectParts();

    resize(1280, 800);
    restoreMemory();
    showStartPage();
    showTitle();
}

MainWindow::~MainWindow() = default;

void MainWindow::buildDocks()
{
    m_docks = std::make_unique<Docks>(
        *this, PanelParts{m_document, m_selection, m_player, *m_recordings,
                          [this](const QString& message) { m_status->say(message); },
                          [this] { return m_files->saveForStudy(); }});
    m_docks->panel<Inspector>().sliders().remember(m_memory == Memory::Keep);
}

void MainWindow::buildActions()
{
    const auto tour = [this] {
        showTour({*this, m_document, *m_files, *m_viewport, *m_transport, *m_docks,
                  [this] { showScene(); }});
    };
    const auto toolChanged = [this] {
        m_handBar->refresh();
        m_brushBar->refresh();
    };
    m_menus = std::make_unique<Menus>(
        Workbench{*this, m_document, m_selection, m_player, *m_recordings, *m_viewport,
                  m_drawSettings, *m_docks, *m_files, *m_runFiles, *m_arrivals, m_dialogs,
                  m_actions, [this] { showStartPage(); }, tour, [this] { resetLayout(); },
                  toolChanged, [this](Language language) { emit languageChosen(language); }});
    m_actions.takeKeys(m_memory == Memory::Keep ? KeyMap::Memory::Keep : KeyMap::Memory::Ignore);
    connect(m_start, &StartPage::tourRequested, this, tour);
}

void MainWindow::buildToolBar()
{
    m_toolBar = addToolBar(tr("Main"));
    m_toolBar->setObjectName("main");
    m_toolBar->setMovable(false);
    m_toolBar->setIconSize(QSize(18, 18));
    fillToolBar(*m_toolBar, m_actions);
    m_toolBar->addWidget(m_transport);
}

// These stand over the view, which owns them. The strip comes last: it hears first of another size
// of the view, so that the bars stand beside it as it is then.
void MainWindow::buildBarsOfView()
{
    m_handBar = new HandBar(m_document, m_player, *m_viewport, m_actions);
    new EmptyHint(m_document, *m_viewport);
    new TransformBar(*m_viewport);
    m_brushBar = new BrushBar(m_document, *m_viewport, m_actions);
    new DrawBar(m_document, *m_viewport, m_drawSettings, m_actions);
    addToolStrip(*m_viewport, m_actions);
}

// What steers besides the menus, and who gets the keys.
void MainWindow::buildInputs()
{
    new FocusReturn(*m_viewport, this);
    new WheelGuard(this);
    auto* keys = new ControlKeys(m_document, m_player, this);
    keys->spare(&m_docks->panel<Timeline>().strip());
    qApp->installEventFilter(keys);
    new Gamepad(m_document, m_player, QStringLiteral("/dev/input"), this);
}

void MainWindow::connectStart()
{
    connect(m_start, &StartPage::openRequested, m_files, &Files::open);
    connect(m_start, &StartPage::newRequested, m_files, &Files::startNew);
    connect(m_start, &StartPage::browseRequested, m_files, &Files::browse);
    connect(m_start, &StartPage::builderRequested, m_arrivals, &Arrivals::startFrom);
    connect(m_start, &StartPage::importRequested, m_arrivals, [this] { m_arrivals->importMesh(); });
    connect(m_files, &Files::recentChanged, this,
            [this] { m_start->setRecent(m_files->recent()); });
}

void MainWindow::connectParts()
{
    connect(m_files, &Files::opened, this, &MainWindow::showScene);
    connect(m_files, &Files::chosen, this, &MainWindow::openAny);
    connect(m_arrivals, &Arrivals::opened, this, &MainWindow::showScene);
    connect(m_keptWork, &KeptWork::opened, this, &MainWindow::showScene);
    connect(m_keptWork, &KeptWork::failed, m_status,
            [this](const QString& why) { m_status->say(why, StatusLine::read); });
    m_status->hear(*m_files);
    m_status->hear(*m_runFiles);
    m_status->hear(*m_arrivals);
    m_status->follow(*m_recordings);
    m_status->follow(*m_viewport);
    connect(&m_docks->panel<StudyPanel>(), &StudyPanel::designWanted, this,
            [this](const QString& file) {
                m_files->open(file);
                m_docks->show("study"); // which others have come before
            });
    connect(&m_docks->panel<LoadPanel>(), &LoadPanel::chosen, m_viewport,
            [this](quint32 element) { m_viewport->centre({Id{element}}); });
    auto* breaks = new ShownBreak(m_player, *m_recordings, m_selection, *m_viewport, *this);
    connect(&m_docks->panel<LoadPanel>(), &LoadPanel::breakChosen, breaks, &ShownBreak::show);
    m_status->hear(*breaks);
    connect(m_recordings, &Recordings::ghostsShown, m_viewport, &Viewport::showGhosts);
    connect(&m_document, &Document::replaced, m_recordings, &Recordings::clear,
            Qt::UniqueConnection); // recordings may have come from a window before
    connect(&m_document, &Document::fileChanged, this, &MainWindow::showTitle);
    connect(qApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState is) {
        if (is == Qt::ApplicationActive)
            m_files->lookAtDisk();
    });
}

bool MainWindow::isSceneShown() const { return m_middle->currentWidget() == m_viewport; }

void MainWindow::showScene()
{
    if (!isSceneShown())
        m_docks->showOpen();
    m_middle->setCurrentWidget(m_viewport);
    m_docks->bringForward();
    m_viewport->setFocus();
}

void MainWindow::showViewOnly()
{
    m_docks->hideAll();
    m_toolBar->hide();
    menuBar()->hide();
    statusBar()->hide();
}

// The start page has the window to itself; docks that were closed stay closed afterwards.
void MainWindow::showStartPage()
{
    if (isSceneShown())
        m_docks->noteClosed();
    m_docks->hideAll();
    m_start->setRecent(m_files->recent());
    m_middle->setCurrentWidget(m_start);
}

void MainWindow::showTitle()
{
    setWindowTitle(tr("%1[*] – Ripstop").arg(m_document.displayName()));
    setWindowFilePath(m_document.file());
    setWindowModified(m_document.isModified());
}

// Several files are let in, so that it can be said at their drop why they are not opened.
void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    const QString file = droppedFile(event->mimeData());
    if (event->mimeData()->urls().size() > 1 || file.endsWith(".json", Qt::CaseInsensitive)
        || ImportDialog::isMesh(file) || RunFiles::isRecording(file))
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    if (event->mimeData()->urls().size() > 1) {
        event->ignore();
        return m_status->say(tr("Several files were dropped, and none was opened: drop one alone."),
                             StatusLine::read);
    }
    event->acceptProposedAction();
    // queued, because the program that drops waits for this event, and questions and dialogs stay
    QTimer::singleShot(0, this, [this, file = droppedFile(event->mimeData())] { openAny(file); });
}

void MainWindow::openAny(const QString& file)
{
    if (StudyPanel::isStudy(file))
        openStudy(file);
    else if (RunFiles::isRecording(file))
        openRun(file);
    else if (ImportDialog::isMesh(file))
        m_arrivals->importMesh(file);
    else
        m_files->open(file);
}

void MainWindow::openStudy(const QString& file)
{
    m_docks->show("study");
    m_docks->panel<StudyPanel>().open(file);
}

void MainWindow::openRun(const QString& file)
{
    m_runFiles->open(file);
    m_docks->show("timeline");
}

} // namespace ripstop
