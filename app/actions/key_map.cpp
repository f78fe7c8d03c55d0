#include "actions/key_map.h"

#include <QAction>
#include <QSettings>

#include <algorithm>

namespace ripstop {
namespace {

QString settingOf(const QAction& action) { return "keys/" + action.objectName(); }

} // namespace

KeyMap::KeyMap(const std::vector<QAction*>& actions, Memory memory, QObject* parent)
    : QObject(parent)
    , m_actions(actions)
    , m_memory(memory)
{
    for (QAction* action : m_actions) {
        m_usual[action] = action->shortcut();
        const QVariant kept =
            memory == Memory::Keep ? QSettings().value(settingOf(*action)) : QVariant();
        show(*action, kept.isValid() ? QKeySequence(kept.toString()) : action->shortcut());
    }
}

QAction* KeyMap::holder(const QKeySequence& keys) const
{
    const auto found = std::ranges::find_if(m_actions, [&](const QAction* action) {
        return !keys.isEmpty() && action->shortcut() == keys;
    });
    return found == m_actions.end() ? nullptr : *found;
}

void KeyMap::set(QAction& action, const QKeySequence& keys)
{
    if (QAction* other = holder(keys); other && other != &action)
        wear(*other, {});
    wear(action, keys);
    emit changed();
}

void KeyMap::resetAll()
{
    for (QAction* action : m_actions)
        wear(*action, m_usual[action]);
    emit changed();
}

// The tip is the status tip with the keys behind it.
void KeyMap::show(QAction& action, const QKeySequence& keys)
{
    action.setShortcut(keys);
    const QString tip = action.statusTip();
    const QString text = keys.toString(QKeySequence::NativeText);
    action.setToolTip(text.isEmpty() ? tip : tr("%1 (%2)").arg(tip, text));
}

void KeyMap::wear(QAction& action, const QKeySequence& keys)
{
    show(action, keys);
    if (m_memory == Memory::Ignore)
        return;
    QSettings settings;
    if (keys == m_usual[&action])
        settings.remove(settingOf(action));
    else
        settings.setValue(settingOf(action), keys.toString());
}

} // namespace ripstop
