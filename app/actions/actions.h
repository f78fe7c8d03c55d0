// The actions of the window: everything that a user can do from a menu, a tool bar or a key.
//
// The menus make them of their rows; bars, tests and the command line find them here by the ids of
// the rows.
#pragma once

#include "actions/key_map.h"

#include <QString>

#include <map>
#include <memory>
#include <vector>

class QAction;

namespace ripstop {

class Actions final
{
public:
    void add(QAction& action); // the name of the object is the id

    // Once all have been added: they get the keys that this user has given them.
    void takeKeys(KeyMap::Memory memory);
    KeyMap& keys() const { return *m_keys; }

    QAction* operator[](const QString& id) const { return m_byId.at(id); }
    QAction* find(const QString& id) const;                    // null when there is none
    const std::vector<QAction*>& all() const { return m_all; } // in the order of their rows

private:
    std::map<QString, QAction*> m_byId;
    std::vector<QAction*> m_all;
    std::unique_ptr<KeyMap> m_keys;
};

} // namespace ripstop
