// The keys of actions as this user wants them.
//
// What differs from the usual keys is kept in the settings from run to run, under the name of the
// action's object; tests and pictures ignore the settings (Memory::Ignore). A key belongs to one
// action at a time. Actions makes it once all actions have been added; the dialog of keys changes
// it.
#pragma once

#include <QKeySequence>
#include <QObject>

#include <map>
#include <vector>

class QAction;

namespace ripstop {

class KeyMap final : public QObject
{
    Q_OBJECT

public:
    enum class Memory { Keep, Ignore };

    KeyMap(const std::vector<QAction*>& actions, Memory memory, QObject* parent);

    const std::vector<QAction*>& actions() const { return m_actions; }
    QKeySequence usual(const QAction& action) const { return m_usual.at(&action); }
    QAction* holder(const QKeySequence& keys) const; // null when no action has them

    void set(QAction& action, const QKeySequence& keys); // another one that has them loses them
    void resetAll();

signals:
    void changed();

private:
    static void show(QAction& action, const QKeySequence& keys);
    // shows them from now on, and keeps them for the next run
    void wear(QAction& action, const QKeySequence& keys);

    std::vector<QAction*> m_actions;
    std::map<const QAction*, QKeySequence> m_usual;
    Memory m_memory;
};

} // namespace ripstop
