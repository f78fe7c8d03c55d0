// The dialog that finds any action of the menus by what is typed, those of panels included.
//
// It lists what the menus hold at the moment when it is made, best match first, and only chooses:
// the caller runs the action after the dialog has closed, as if it came from its menu.
// Dialogs::showPalette() opens it.
#pragma once

#include <QDialog>
#include <QList>

class QAction;
class QLabel;
class QLineEdit;
class QMenu;
class QMenuBar;
class QTreeWidget;

namespace ripstop {

class Palette final : public QDialog
{
    Q_OBJECT

public:
    // A menu that a panel opens, and the dock where what it does is seen.
    struct PanelMenu
    {
        const QMenu* menu; // null while the panel has none
        QString title;
        QString dock;
    };

    Palette(const QMenuBar& menus, const QList<PanelMenu>& others, QWidget* parent);

    QAction* chosen() const; // null when there is none, or it cannot be run now
    QString dock() const;    // where what is chosen is seen; empty when it stands in the menu bar

    // How well an action answers what was typed: 0 not at all. Its name alone counts most, then a
    // name that begins with these words. Else each word has to occur somewhere: a word of the name
    // counts more than one of `others`, which are what other programs call it, and these more than
    // one of its menu or its tip; a whole word more than the beginning of one, and that more than a
    // middle. Of tips only whole words count.
    static int fit(const QString& typed, const QString& name, const QString& menu,
                   const QString& tip, const QString& others = {});

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Entry
    {
        QAction* action;
        QString name;
        QString menu; // "View › Panels and docks"
        QString dock;
    };

    void collect(const QMenu& menu, const QString& path, const QString& dock = {});
    void fill();

    QList<Entry> m_entries;
    QLineEdit* m_typed;
    QTreeWidget* m_list;
    QLabel* m_none; // while nothing answers what is typed
};

} // namespace ripstop
