// The menus of the window, made of the tables of rows (menu_row.h), and what keeps them as things
// are: enabled, checked and worded.
//
// The main window makes them once, after the docks, whose toggles stand in the View menu. The
// actions of the rows go to the Actions of the workbench.
#pragma once

#include <QObject>
#include <QString>

#include <map>
#include <memory>
#include <vector>

class QAction;
class QActionGroup;
class QMenu;

namespace ripstop {

class Actions;
struct MenuRow;
struct Workbench;

class Menus final : public QObject
{
    Q_OBJECT

public:
    explicit Menus(const Workbench& bench);
    ~Menus() override;

    // What the View menu shows and hides, from run to run.
    void keepView() const;
    void restoreView();

    // What another window has switched on and chosen.
    void takeOver(const Actions& before);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QMenu& menu(const QString& path);
    void add(const MenuRow& row);
    void addFilled();
    void keepCurrent();
    // Says what is needed for an action that cannot be taken now, in its help ("What's this?"):
    // the menu shows it as a tip, and so does the search of actions.
    static void enable(QAction& action, bool can, const QString& needed);
    void fillRecent();
    void fillTemplates();

    std::unique_ptr<Workbench> m_bench; // rows keep references into it
    std::map<QString, QMenu*> m_menus;  // by their paths
    std::map<QString, QActionGroup*> m_groups;
    std::vector<QAction*> m_needSelection;
    std::vector<QAction*> m_viewToggles;
    QMenu* m_recent = nullptr;
    QMenu* m_templates = nullptr;
};

} // namespace ripstop
