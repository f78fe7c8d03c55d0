// An event filter that lets the keys of the scene's controls steer, wherever the focus is. The main
// window makes it and installs it on the application.
//
// A press moves the control by one step, and so does each repeat of a key that is held. Keys keep
// their usual meaning in dialogs, menus and wherever text is typed; while a recording is looked
// back at; and, while the design is shown rather than a run, in lists, trees and sliders too. Only
// the window's thread uses it.
#pragma once

#include <QObject>

#include <vector>

class QKeyEvent;
class QWidget;

namespace ripstop {

class Document;
class Player;

// Whether keys are text to this widget: a line, a number, a list to choose from. Null is none.
bool takesText(const QWidget* focus);

class ControlKeys final : public QObject
{
    Q_OBJECT

public:
    ControlKeys(Document& document, Player& player, QObject* parent = nullptr);

    void spare(const QWidget* widget); // the widget keeps all keys while it has the focus

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool maySteer(QObject* watched) const;
    bool isRunning() const;
    bool steer(const QKeyEvent& key, bool press); // true when the key is that of a control

    Document& m_document;
    Player& m_player;
    std::vector<const QWidget*> m_spared;
};

} // namespace ripstop
