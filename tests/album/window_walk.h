// Goes through everything that the window can show, and knows none of it by name: panels, menus
// and actions are those that the window has, dialogs are what comes when an action is done, and
// what a button with an ellipsis opens from there.
#pragma once

#include "app/window_shop.h"

#include <QActionGroup>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTimer>
#include <QtTest>

#include <functional>
#include <set>

namespace ripstop {

class WindowWalk
{
public:
    // It is told at each turn what is in front, and returns true once that may go.
    using Look = std::function<bool(const QString& name, QWidget& inFront)>;

    WindowWalk(WindowShop& shop, Look look)
        : m_shop(shop)
        , m_look(std::move(look))
    {
        m_timer.setInterval(20);
        QObject::connect(&m_timer, &QTimer::timeout, [this] { lookAtOpened(); });
    }

    // Shows the window as it stands.
    void window(const QString& name)
    {
        QElapsedTimer clock;
        clock.start();
        do
            QTest::qWait(20);
        while (!m_look(name, m_shop.window) && clock.elapsed() < longest);
    }

    void panels(const QString& name)
    {
        for (auto* dock : m_shop.window.findChildren<QDockWidget*>()) {
            m_shop.window.docks().show(dock->objectName());
            window(name + ' ' + dock->objectName());
            for (auto* tabs : dock->findChildren<QTabWidget*>())
                for (int i = 1; i < tabs->count(); ++i) {
                    tabs->setCurrentIndex(i);
                    window(name + ' ' + dock->objectName() + ' ' + plain(tabs->tabText(i)));
                    tabs->setCurrentIndex(0);
                }
        }
    }

    void menus()
    {
        for (QAction* title : m_shop.window.menuBar()->actions())
            menu("menu", *title->menu(),
                 m_shop.window.menuBar()->mapToGlobal(
                     m_shop.window.menuBar()->actionGeometry(title).bottomLeft()));
    }

    // Shows what comes on a right click, once for each kind of place.
    void contextMenus()
    {
        std::set<QString> done;
        for (auto* dock : m_shop.window.findChildren<QDockWidget*>()) {
            m_shop.window.docks().show(dock->objectName());
            QTest::qWait(20);
            for (auto* place : dock->findChildren<QWidget*>()) {
                const QString kind = dock->objectName() + ' ' + place->metaObject()->className();
                const bool has = place->contextMenuPolicy() == Qt::CustomContextMenu
                                 || place->contextMenuPolicy() == Qt::ActionsContextMenu;
                if (!has || !place->isVisible() || !done.insert(kind).second)
                    continue;
                const QPoint at(10, 10);
                during("right click " + kind, [&] {
                    QContextMenuEvent event(QContextMenuEvent::Mouse, at, place->mapToGlobal(at));
                    QApplication::sendEvent(place, &event);
                });
            }
        }
    }

    // Triggers each action, with the first of these selections for which what it opens can be
    // accepted, or else with the last. `restore` brings back the scene before each. Returns those
    // that opened nothing.
    std::vector<QAction*> actions(const std::vector<std::vector<Id>>& selections,
                                  const std::function<void()>& restore)
    {
        std::vector<QAction*> silent;
        for (QAction* action : m_shop.window.actions().all()) {
            bool opened = false;
            const auto* group = action->actionGroup();
            QAction* before = group ? group->checkedAction() : nullptr;
            for (const std::vector<Id>& ids : selections) {
                restore();
                m_shop.selection.set(ids);
                m_canAccept = false;
                if (action->isEnabled())
                    opened |= during(action->objectName(), [&] { action->trigger(); });
                if (m_canAccept)
                    break;
            }
            if (!opened)
                silent.push_back(action);
            if (before && before != action) // such as the theme, which all that follows has
                before->trigger();
        }
        restore();
        return silent;
    }

    // Switches on each tool, of which one is in use at a time, and each of what the view shows.
    void tools(const QString& name)
    {
        for (QAction* action : m_shop.window.actions().all()) {
            if (!action->isCheckable() || !action->isEnabled() || action->isChecked())
                continue;
            const auto* group = action->actionGroup();
            QAction* before = group ? group->checkedAction() : action;
            action->trigger();
            window(name + " use " + action->objectName());
            before->trigger();
        }
    }

    // Does this, looks at all that opens meanwhile, and closes it. False when nothing opened.
    bool during(const QString& name, const std::function<void()>& act)
    {
        m_name = name;
        m_opened = 0;
        m_pressed.clear();
        m_front = nullptr;
        m_timer.start();
        act();
        QTest::qWait(1); // what is put off until the events are done
        while (inFront())
            QTest::qWait(m_timer.interval());
        m_timer.stop();
        return m_opened > 0;
    }

    static QString plain(QString text) { return text.remove('&').remove(QChar(0x2026)); }

private:
    static constexpr int longest = 4000; // ms that one thing is looked at

    QList<QWidget*> openDialogs() const
    {
        QList<QWidget*> open;
        for (QWidget* one : QApplication::topLevelWidgets())
            if (one->isVisible() && one != &m_shop.window
                && (qobject_cast<QDialog*>(one) || qobject_cast<QMenu*>(one)))
                open << one;
        return open;
    }

    QWidget* inFront() const
    {
        if (QWidget* popup = QApplication::activePopupWidget())
            return popup;
        if (QWidget* modal = QApplication::activeModalWidget())
            return modal;
        const QList<QWidget*> open = openDialogs();
        return open.isEmpty() ? nullptr : open.last();
    }

    void menu(const QString& name, QMenu& menu, QPoint place)
    {
        const QString called = name + ' ' + plain(menu.title());
        during(called, [&] { menu.popup(place); });
        menu.popup(place);
        const auto rows = menu.actions();
        std::vector<std::pair<QMenu*, QPoint>> deeper;
        for (QAction* row : rows)
            if (row->menu())
                deeper.emplace_back(row->menu(),
                                    menu.mapToGlobal(menu.actionGeometry(row).topRight()));
        menu.close();
        for (const auto& [inner, at] : deeper)
            this->menu(called, *inner, at);
    }

    void lookAtOpened()
    {
        QWidget* front = inFront();
        if (!front)
            return;
        if (front != m_front) {
            m_front = front;
            m_since.start();
        }
        if (!m_looked.contains(front)) {
            const QString name = m_opened ? m_name + ' ' + QString::number(m_opened) : m_name;
            if (!m_look(name, *front) && m_since.elapsed() < longest)
                return;
            m_looked.insert(front);
            if (m_opened++ == 0)
                m_canAccept = canAccept(*front);
        }
        if (pressNext(*front))
            return;
        m_looked.erase(front);
        if (auto* dialog = qobject_cast<QDialog*>(front))
            dialog->reject();
        if (inFront() == front)
            front->close();
    }

    // A button that promises a dialog. It is pressed when this turn is over: what it opens may
    // run a loop of its own.
    bool pressNext(QWidget& dialog)
    {
        for (auto* button : dialog.findChildren<QPushButton*>())
            if (button->isVisible() && button->isEnabled() && button->text().contains(QChar(0x2026))
                && m_pressed.insert(button->text()).second) {
                QMetaObject::invokeMethod(button, &QPushButton::click, Qt::QueuedConnection);
                return true;
            }
        return false;
    }

    static bool canAccept(const QWidget& dialog)
    {
        const auto* buttons = dialog.findChild<QDialogButtonBox*>();
        const auto* ok = buttons ? buttons->button(QDialogButtonBox::Ok) : nullptr;
        return !ok || ok->isEnabled();
    }

    WindowShop& m_shop;
    Look m_look;
    QTimer m_timer;
    QElapsedTimer m_since; // since the one in front came there
    QString m_name;
    QWidget* m_front = nullptr;
    std::set<QWidget*> m_looked;
    std::set<QString> m_pressed; // buttons
    int m_opened = 0;
    bool m_canAccept = false;
};

} // namespace ripstop
