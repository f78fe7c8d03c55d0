// An application sees a key twice, on its way to the window and then to the widget with the focus,
// and before that once more as a question whether it is a shortcut. eventFilter() takes the
// question and the press, maySteer() decides from focus, window and player whether keys steer now,
// and steer() finds the controls that have the key. The question is answered too, but only the
// press moves a control.
#include "transport/control_keys.h"

#include "document/document.h"
#include "document/player.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QKeyEvent>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QMainWindow>
#include <QPlainTextEdit>
#include <QTabBar>
#include <QTextEdit>

#include <algorithm>

namespace ripstop {
namespace {

template <typename... Types>
bool isAny(const QWidget* widget)
{
    return (qobject_cast<const Types*>(widget) || ...);
}

bool movesByKeys(const QWidget* focus)
{
    return isAny<QAbstractItemView, QAbstractSlider, QTabBar>(focus);
}

// "+" is pressed with Shift on many keyboards: Shift only counts where it does not choose the
// character itself.
bool shiftChooses(int key)
{
    const bool isLetter = key >= Qt::Key_A && key <= Qt::Key_Z;
    return key > Qt::Key_Space && key < Qt::Key_Escape && !isLetter;
}

bool matches(const QKeyEvent& event, const std::string& text)
{
    if (text.empty())
        return false;
    const QKeySequence sequence(QString::fromStdString(text));
    if (sequence.count() != 1)
        return false;
    const QKeyCombination wanted = sequence[0];
    if (wanted.key() == Qt::Key_unknown || int(wanted.key()) != event.key())
        return false;
    Qt::KeyboardModifiers counting = ~(Qt::KeypadModifier | Qt::GroupSwitchModifier);
    if (shiftChooses(event.key()))
        counting &= ~Qt::KeyboardModifiers(Qt::ShiftModifier);
    return (wanted.keyboardModifiers() & counting) == (event.modifiers() & counting);
}

} // namespace

bool takesText(const QWidget* focus)
{
    return isAny<QLineEdit, QAbstractSpinBox, QTextEdit, QPlainTextEdit, QComboBox,
                 QKeySequenceEdit>(focus);
}

ControlKeys::ControlKeys(Document& document, Player& player, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_player(player)
{}

void ControlKeys::spare(const QWidget* widget) { m_spared.push_back(widget); }

bool ControlKeys::eventFilter(QObject* watched, QEvent* event)
{
    const bool press = event->type() == QEvent::KeyPress;
    // a key that steers must not trigger a shortcut of a menu either
    if (!press && event->type() != QEvent::ShortcutOverride)
        return false;
    if (!maySteer(watched) || !steer(*static_cast<QKeyEvent*>(event), press))
        return false;
    event->accept();
    return true;
}

// An application sees a key twice: on its way to the window, then to the widget with the focus.
bool ControlKeys::maySteer(QObject* watched) const
{
    if (QApplication::activePopupWidget() || QApplication::activeModalWidget())
        return false;
    const auto* target = qobject_cast<const QWidget*>(watched);
    if (!target)
        target = watched->isWindowType() ? QApplication::activeWindow() : nullptr;
    if (!target || !isAny<QMainWindow, QDockWidget>(target->window()))
        return false;
    const QWidget* focus = QApplication::focusWidget();
    if (m_player.isLookingBack() || std::ranges::find(m_spared, focus) != m_spared.end())
        return false; // a recording cannot be steered
    return !takesText(focus) && (isRunning() || !movesByKeys(focus));
}

bool ControlKeys::isRunning() const
{
    return m_player.isPlaying() || (m_player.frame() && m_player.frame()->underWay);
}

bool ControlKeys::steer(const QKeyEvent& key, bool press)
{
    bool found = false;
    for (const Entry& entry : m_document.scene().items) {
        const Control* control = std::get_if<Control>(&entry.item);
        if (!control)
            continue;
        const int direction = matches(key, control->keyMore)   ? +1
                              : matches(key, control->keyLess) ? -1
                                                               : 0;
        if (direction == 0)
            continue;
        found = true;
        if (press)
            m_player.nudge(entry.id, direction);
    }
    return found;
}

} // namespace ripstop
