#include "actions/actions.h"

#include <QAction>

namespace ripstop {

void Actions::add(QAction& action)
{
    m_byId[action.objectName()] = &action;
    m_all.push_back(&action);
}

void Actions::takeKeys(KeyMap::Memory memory)
{
    m_keys = std::make_unique<KeyMap>(m_all, memory, nullptr);
}

QAction* Actions::find(const QString& id) const
{
    const auto found = m_byId.find(id);
    return found == m_byId.end() ? nullptr : found->second;
}

} // namespace ripstop
