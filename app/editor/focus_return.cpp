// eventFilter() chooses the keys that end typing, finish() delivers one to its field before it
// takes the focus away, in one go: a Space that is pressed right after Enter is for the scene
// already. Escape is a shortcut of a menu too, so the question whether it is one is answered as
// well; from a list both go to the view first.
#include "editor/focus_return.h"

#include "inspector/value_edit.h"
#include "transport/control_keys.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPointer>
#include <QTextEdit>

namespace ripstop {
namespace {

bool hasLines(const QWidget& field)
{
    return qobject_cast<const QPlainTextEdit*>(&field) || qobject_cast<const QTextEdit*>(&field);
}

bool endsTyping(const QKeyEvent& key, const QWidget& field)
{
    if (key.key() == Qt::Key_Escape)
        return true;
    const bool isEnter = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    return isEnter && (!hasLines(field) || key.modifiers().testFlag(Qt::ControlModifier));
}

// The delegate of a table ends the editing of its cells by itself, and the table lets the keys of
// the scene pass.
bool isInCell(const QWidget& field)
{
    for (const QWidget* above = field.parentWidget(); above; above = above->parentWidget())
        if (qobject_cast<const QAbstractItemView*>(above))
            return true;
    return false;
}

bool isRefused(const QWidget& field)
{
    const auto* edit = qobject_cast<const ValueEdit*>(&field);
    return edit && edit->isBroken();
}

// Leaving a line commits its text, which Escape must not.
void takeBack(QWidget& field, const QString& typed)
{
    auto* line = qobject_cast<QLineEdit*>(&field);
    if (line && line->text() == typed)
        while (line->isUndoAvailable())
            line->undo();
}

} // namespace

FocusReturn::FocusReturn(QWidget& view, QObject* parent)
    : QObject(parent)
    , m_view(view)
{
    qApp->installEventFilter(this);
}

void FocusReturn::giveBack()
{
    if (!m_view.isVisible())
        return;
    if (!m_view.isActiveWindow())
        m_view.window()->activateWindow();
    m_view.setFocus(Qt::OtherFocusReason);
}

bool FocusReturn::eventFilter(QObject* watched, QEvent* event)
{
    const bool isPress = event->type() == QEvent::KeyPress;
    const bool isQuestion = event->type() == QEvent::ShortcutOverride; // comes with each delivery
    if ((!isPress && !isQuestion) || (isPress && m_delivers) || !watched->isWidgetType())
        return false;
    auto& field = *static_cast<QWidget*>(watched);
    auto& key = *static_cast<QKeyEvent*>(event);
    if (qobject_cast<QAbstractItemView*>(&field))
        return leavesTool(field, key);
    if (!takesText(&field) || !endsTyping(key, field) || !isOurs(field) || isInCell(field))
        return false;
    key.accept();
    if (isPress)
        finish(field, key);
    return true;
}

// Of the window of the view, or of one above it that lets it be used meanwhile.
bool FocusReturn::isOurs(const QWidget& field) const
{
    if (QApplication::activePopupWidget() || QApplication::activeModalWidget())
        return false;
    for (const QWidget* window = field.window(); window;
         window = window->parentWidget() ? window->parentWidget()->window() : nullptr)
        if (window == m_view.window())
            return true;
    return false;
}

bool FocusReturn::leavesTool(const QWidget& list, QKeyEvent& key)
{
    if (key.key() != Qt::Key_Escape || !list.hasFocus() || !isOurs(list))
        return false;
    const bool was = key.isAccepted();
    key.ignore();
    QApplication::sendEvent(&m_view, &key);
    const bool isTaken = key.isAccepted();
    key.setAccepted(isTaken || was);
    return isTaken;
}

void FocusReturn::finish(QWidget& field, const QKeyEvent& key)
{
    const QPointer<QWidget> still(&field);
    const auto* line = qobject_cast<const QLineEdit*>(&field);
    const QString typed = line ? line->text() : QString();
    QKeyEvent copy(key.type(), key.key(), key.modifiers(), key.text(), key.isAutoRepeat());
    m_delivers = true;
    QApplication::sendEvent(&field, &copy);
    m_delivers = false;
    if (!still || !field.hasFocus()) // the field is gone, or has sent the keys elsewhere
        return giveBack();
    if (key.key() == Qt::Key_Escape)
        takeBack(field, typed);
    else if (isRefused(field))
        return;
    giveBack();
}

} // namespace ripstop
