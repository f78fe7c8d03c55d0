// Stages: the constructor goes through the rows of all sources and makes menus and actions of
// them, then adds what is known only when the window runs (recent files, templates, groups,
// docks), gives letters to entries and connects what keeps them current. keepCurrent() enables,
// words and checks actions after each change of history, selection, run or tool. keepView() and
// restoreView() carry the toggles of the View menu from run to run.
#include "actions/menus.h"

#include "actions/actions.h"
#include "actions/group_menus.h"
#include "actions/menu_rows.h"
#include "actions/mnemonics.h"
#include "actions/workbench.h"
#include "docks/docks.h"
#include "document/document.h"
#include "document/plain_text.h"
#include "document/player.h"
#include "document/selection.h"
#include "files/files.h"
#include "files/templates.h"
#include "icons/icon.h"
#include "outline/outline.h"
#include "tools/pointing.h"
#include "tools/transform_tool.h"
#include "viewport/viewport.h"

#include <QAction>
#include <QActionGroup>
#include <QFileInfo>
#include <QHelpEvent>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QToolTip>

#include <algorithm>
#include <array>

namespace ripstop {
namespace {

// Menus appear in the order in which rows first name them, and the rows of a menu in theirs. The
// keys dialog lists all in this order.
constexpr std::array<MenuRows (*)(const Workbench&), 15> sources{
    fileRows,     editRows, selectRows, insertRows,   designRows, drawRows,    viewRows, themeRows,
    languageRows, runRows,  tuningRows, timelineRows, toolRows,   measureRows, helpRows};

// What colours by each quantity, in the order of ColorBy. The view says by which, and the menu
// follows.
constexpr std::array colorings{"byMaterial", "byStrain",    "byTension",  "bySpeed",
                               "byLoad",     "byTear",      "byStress",   "byWrinkles",
                               "byMargin",   "byStiffness", "byStrength", "byGrain"};
static_assert(colorings.size() == colorByCount);

// Whether the row shows or hides something in the view, or is one of the ways of colouring it.
bool isOfView(const MenuRow& row)
{
    static constexpr std::array menus{"&View", "&View/&Colours", "&View/Sho&w"};
    const auto isNamed = [&](const char* menu) { return qstrcmp(menu, row.menu) == 0; };
    return row.toggle != Toggle::No && std::ranges::any_of(menus, isNamed);
}

} // namespace

Menus::Menus(const Workbench& bench)
    : m_bench(std::make_unique<Workbench>(bench))
{
    for (const auto& rows : sources)
        for (const MenuRow& row : rows(*m_bench))
            add(row);
    addFilled();
    bench.docks.panel<Outline>().setPartActions({bench.actions["parameters"]});
    giveMnemonics(bench.window.menuBar()->actions());
    keepMnemonics(bench.window.menuBar()->actions());

    connect(&bench.document.history(), &QUndoStack::indexChanged, this, &Menus::keepCurrent);
    connect(&bench.selection, &Selection::changed, this, &Menus::keepCurrent);
    connect(&bench.player, &Player::stateChanged, this, &Menus::keepCurrent);
    connect(&bench.viewport.transformTool(), &TransformTool::changed, this, &Menus::keepCurrent);
    connect(&bench.viewport, &Viewport::menuWanted, this,
            [this](const QPoint& place) { showViewMenu(*m_bench, place); });
    connect(&bench.files, &Files::recentChanged, this, &Menus::fillRecent);
    connect(&bench.viewport.pointing(), &Pointing::toolLeft, this,
            [this] { m_bench->actions["toolPointer"]->setChecked(true); });
    connect(&bench.viewport, &Viewport::colorByChanged, this, &Menus::keepCurrent);
    fillRecent();
    keepCurrent();
    bench.viewport.setParticlesShown(bench.actions["particles"]->isChecked());
}

Menus::~Menus() = default;

// A menu such as "&Select/By &type" is made when its path is first named.
QMenu& Menus::menu(const QString& path)
{
    QMenu*& place = m_menus[path];
    const QString name = tr(qPrintable(path.section('/', -1)));
    if (!place)
        place = path.contains('/') ? menu(path.section('/', 0, -2)).addMenu(name)
                                   : m_bench->window.menuBar()->addMenu(name);
    place->installEventFilter(this);
    return *place;
}

void Menus::add(const MenuRow& row)
{
    QMenu& place = menu(row.menu);
    if (!row.id) {
        place.addSeparator();
        return;
    }
    QAction* action = place.addAction(row.icon ? icon(row.icon) : QIcon(), row.text, this, row.run);
    action->setObjectName(row.id);
    action->setShortcut(row.keys);
    action->setStatusTip(row.tip);
    action->setCheckable(row.toggle != Toggle::No);
    action->setChecked(row.toggle == Toggle::On);
    if (row.group) {
        QActionGroup*& group = m_groups[row.group];
        if (!group)
            group = new QActionGroup(this);
        group->addAction(action);
    }
    m_bench->actions.add(*action);
    if (row.needs == Needs::Selection)
        m_needSelection.push_back(action);
    if (isOfView(row))
        m_viewToggles.push_back(action);
}

// What no row says, because it is there only when the window runs: files, groups and docks.
void Menus::addFilled()
{
    const Actions& actions = m_bench->actions;
    QMenu& file = menu("&File");
    m_recent = new QMenu(tr("Open &recent"), &m_bench->window);
    m_recent->setIcon(icon("recent"));
    file.insertMenu(actions["start"], m_recent);
    m_templates = new QMenu(tr("New from te&mplate"), &m_bench->window);
    file.insertMenu(actions["open"], m_templates);
    connect(m_templates, &QMenu::aboutToShow, this, &Menus::fillTemplates);
    addGroupMenus(menu("&Select"), *m_bench);
    QMenu* panels = menu("&View").addMenu(tr("Panels and &docks"));
    panels->addActions(m_bench->docks.toggles());
}

void Menus::enable(QAction& action, bool can, const QString& needed)
{
    action.setEnabled(can);
    action.setWhatsThis(can ? QString() : needed);
}

// Menus pass over what is grey, so that the status bar says nothing of it.
bool Menus::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QObject::eventFilter(watched, event);
    const auto& at = static_cast<const QHelpEvent&>(*event);
    auto* menu = static_cast<QMenu*>(watched); // only they are watched
    const QAction* action = menu->actionAt(at.pos());
    if (!action || action->isEnabled() || action->whatsThis().isEmpty())
        return QObject::eventFilter(watched, event);
    QToolTip::showText(at.globalPos(), action->whatsThis(), menu);
    return true;
}

void Menus::keepCurrent()
{
    const Actions& actions = m_bench->actions;
    const QUndoStack& history = m_bench->document.history();
    enable(*actions["undo"], history.canUndo(), tr("Nothing has been changed yet."));
    actions["undo"]->setText(history.canUndo() ? tr("&Undo: %1").arg(inMenu(history.undoText()))
                                               : tr("&Undo"));
    enable(*actions["redo"], history.canRedo(), tr("Nothing has been undone."));
    actions["redo"]->setText(history.canRedo() ? tr("&Redo: %1").arg(inMenu(history.redoText()))
                                               : tr("&Redo"));
    for (QAction* action : m_needSelection)
        enable(*action, !m_bench->selection.ids().empty(),
               tr("Select something first: in the view, in the outline or with the menu Select."));
    const Shaping shaping = m_bench->viewport.transformTool().shaping();
    actions["move"]->setChecked(shaping == Shaping::Move);
    actions["rotate"]->setChecked(shaping == Shaping::Turn);
    actions["scale"]->setChecked(shaping == Shaping::Scale);
    actions[colorings[std::size_t(m_bench->viewport.colorBy())]]->setChecked(true);
    const bool playing = m_bench->player.isPlaying();
    actions["play"]->setText(playing ? tr("&Pause") : tr("&Play"));
    actions["play"]->setIcon(icon(playing ? "pause" : "play"));
}

void Menus::keepView() const
{
    QSettings settings;
    for (const QAction* action : m_viewToggles)
        settings.setValue("view/" + action->objectName(), action->isChecked());
}

void Menus::restoreView()
{
    const QSettings settings;
    for (QAction* action : m_viewToggles) {
        // one of a group: it is only switched on
        const bool isOne = action->actionGroup() != nullptr;
        const bool kept =
            settings.value("view/" + action->objectName(), action->isChecked()).toBool();
        if (kept != action->isChecked() && (kept || !isOne))
            action->trigger();
    }
}

void Menus::takeOver(const Actions& before)
{
    for (const QAction* other : before.all()) {
        QAction* action = m_bench->actions.find(other->objectName());
        const bool isOne = action && action->actionGroup(); // it is only switched on
        if (action && other->isChecked() != action->isChecked() && (other->isChecked() || !isOne))
            action->trigger();
    }
}

void Menus::fillTemplates()
{
    m_templates->clear();
    for (const QString& file : m_bench->files.templates())
        m_templates->addAction(inMenu(templateName(file)), this,
                               [this, file] { m_bench->files.startFromTemplate(file); });
    if (m_templates->isEmpty())
        m_templates->addAction(tr("None yet: File, Save as template"))->setEnabled(false);
    m_templates->addSeparator();
    m_templates->addAction(tr("Show the &folder"), this, [] { showTemplateFolder(); });
}

void Menus::fillRecent()
{
    m_recent->clear();
    for (const QString& file : m_bench->files.recent())
        m_recent
            ->addAction(inMenu(QFileInfo(file).fileName()), this,
                        [this, file] { m_bench->files.open(file); })
            ->setToolTip(shownAsIs(file));
    enable(*m_recent->menuAction(), !m_recent->isEmpty(),
           tr("No scene has been opened or saved yet."));
}

} // namespace ripstop
