#include "actions/group_menus.h"

#include "actions/menu_row.h"
#include "actions/workbench.h"
#include "document/document.h"
#include "document/plain_text.h"
#include "document/selection.h"
#include "document/words.h"
#include "icons/icon.h"
#include "select/elements.h"
#include "select/group.h"

#include <QInputDialog>
#include <QMainWindow>
#include <QMenu>
#include <QStatusBar>

namespace ripstop {
namespace {

using WithGroup = std::function<void(Id group)>;

QMenu* groupMenu(QMenu& menu, const Workbench& bench, const QString& title, const QString& tip,
                 bool ofSelection, const WithGroup& run)
{
    QMenu* groups = menu.addMenu(icon("group"), title);
    groups->menuAction()->setStatusTip(tip);
    QObject::connect(groups, &QMenu::aboutToShow, groups, [=, &bench = bench] {
        groups->clear();
        for (const Entry& entry : bench.document.scene().items)
            if (const Group* group = std::get_if<Group>(&entry.item))
                groups->addAction(inMenu(QString::fromStdString(group->name)), groups,
                                  [run, id = entry.id] { run(id); });
        if (groups->isEmpty())
            groups->addAction(tr("No groups yet"))->setEnabled(false);
        else if (ofSelection && bench.selection.ids().empty())
            for (QAction* action : groups->actions())
                action->setEnabled(false);
    });
    return groups;
}

void pushIfAny(Document& document, QMainWindow& window, Edit edit, const QString& otherwise)
{
    if (edit.changes.empty())
        window.statusBar()->showMessage(otherwise, 5000);
    else
        document.push(std::move(edit));
}

} // namespace

void addGroupMenus(QMenu& menu, const Workbench& bench)
{
    Document& document = bench.document;
    Selection& selection = bench.selection;
    QMainWindow& window = bench.window;
    groupMenu(menu, bench, tr("By gro&up"), tr("Select the members of a group."), false,
              [&document, &selection](Id group) {
                  selection.set(elementsOf(document.scene(), {group}));
              });
    groupMenu(
        menu, bench, tr("A&dd to group"), tr("Make the selected elements members of a group."),
        true, [&document, &selection, &window](Id group) {
            pushIfAny(document, window, addedToGroup(document.scene(), group, selection.ids()),
                      tr("They all belong to the group already."));
        });
    groupMenu(
        menu, bench, tr("&Remove from group"), tr("Take the selected elements out of a group."),
        true, [&document, &selection, &window](Id group) {
            pushIfAny(document, window, removedFromGroup(document.scene(), group, selection.ids()),
                      tr("None of them belongs to the group."));
        });
}

void groupSelection(const Workbench& bench)
{
    const Scene& scene = bench.document.scene();
    const std::vector<Id> ids = sortedElements(scene, bench.selection.ids()).ids();
    if (ids.empty()) {
        bench.window.statusBar()->showMessage(tr("Select particles, links or panels first."), 5000);
        return;
    }
    bool accepted = false;
    const QString name =
        QInputDialog::getText(&bench.window, tr("Group selection"),
                              shownAsIs(tr("Name of the group of %1:").arg(describe(scene, ids))),
                              QLineEdit::Normal, QString::fromStdString(freeName(scene, "group")),
                              &accepted)
            .trimmed();
    if (!accepted)
        return;
    const std::string chosen = name.isEmpty() ? freeName(scene, "group") : name.toStdString();
    const Id group = scene.nextId;
    bench.document.push(grouped(scene, chosen, ids));
    bench.selection.set({group});
}

} // namespace ripstop
