// Gives the keys back to the scene when typing ends.
//
// A field keeps the focus after Enter, and with it all keys that are text to it: Space would write
// a space where a person means to play. This event filter of the application hands the focus to the
// view once Enter or Escape has done its work in a field of the main window, of a dock or of a
// dialog that stays open beside the window. A value that was refused keeps the focus, so that it
// can be mended; Enter in a text of several lines begins a line, and Ctrl+Enter ends it. Fields of
// modal dialogs keep their keys. Escape in a list or a tree is for the tool of the view before it
// is the shortcut that selects nothing, as it is where the view has the focus. The main window
// makes it; only its thread uses it.
#pragma once

#include <QObject>

class QKeyEvent;
class QWidget;

namespace ripstop {

class FocusReturn final : public QObject
{
    Q_OBJECT

public:
    explicit FocusReturn(QWidget& view, QObject* parent = nullptr);

    void giveBack(); // to the view, where that is shown

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool isOurs(const QWidget& field) const;
    bool leavesTool(const QWidget& list, QKeyEvent& key); // the view has taken the key
    void finish(QWidget& field, const QKeyEvent& key);

    QWidget& m_view;
    bool m_delivers = false; // the key that is on its way to its field
};

} // namespace ripstop
