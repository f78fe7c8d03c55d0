// The tree of everything in the scene: settings, parts with their tables, materials, groups,
// colliders, winds, controls, probes and plots.
//
// What is selected here is selected everywhere, and the other way round. It also adds, renames,
// hides and removes items, each as one edit; a search leaves only the rows that have a text in name
// or detail.
#pragma once

#include "scene/property.h"

#include <QWidget>

#include <functional>
#include <utility>
#include <vector>

class QLineEdit;
class QAction;
class QMenu;
class QTreeView;

namespace ripstop {

class Document;
class OutlineFilter;
class OutlineModel;
class Selection;

class Outline final : public QWidget
{
    Q_OBJECT

public:
    Outline(Document& document, Selection& selection, QWidget* parent = nullptr);

    QMenu* addMenu() const { return m_addMenu; } // one action per kind of item that can be added
    void addNew(Kind kind); // one of addableKinds that is no collider, and selects it
    void renameCurrent();
    void removeSelected(); // asks when more goes than what is selected
    void focusSearch();

    // What the menu of a part that a builder has made offers first.
    void setPartActions(std::vector<QAction*> actions) { m_partActions = std::move(actions); }

    // Asks the user; a dialog unless it is replaced.
    std::function<bool(const QString& question)> confirm;

private:
    void buildTree();
    void buildAddMenu();
    void showContextMenu(const QPoint& place);
    void takeFromTree();  // tree -> Selection
    void showSelection(); // Selection -> tree
    void search(const QString& text);
    void takeSearch(); // by Enter in the search box
    void addCollider(ColliderShape shape);
    void add(Kind kind, Entry entry);
    bool eventFilter(QObject* watched, QEvent* event) override;

    Document& m_document;
    Selection& m_selection;
    OutlineModel* m_model;
    OutlineFilter* m_filter;
    QLineEdit* m_search;
    QTreeView* m_tree;
    QMenu* m_addMenu;
    std::vector<QAction*> m_partActions;
    bool m_syncing = false; // the tree follows the selection, not the other way round
};

} // namespace ripstop
