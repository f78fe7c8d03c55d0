// The window that is on the screen, and another one in its place when the language changes.
//
// Texts are said once, when a widget is made. So a change of language makes the whole window anew
// around the same document, selection, player and recordings, and the new one takes over what the
// old one shows and holds: places and sizes, camera, tool, curves, studies, kept work. Nothing is
// lost and nothing is asked; a run goes on meanwhile. main() has one of these; it belongs to the
// thread of the window.
#pragma once

#include "editor/main_window.h"
#include "language/language.h"

#include <QObject>

#include <memory>

namespace ripstop {

class WindowHost final : public QObject
{
    Q_OBJECT

public:
    WindowHost(Document& document, Selection& selection, Player& player, MainWindow::Memory memory,
               Translation& translation);

    MainWindow& window() { return *m_window; } // until the language changes

    // From here on. Waits while a dialog stands that has to be answered first.
    void speak(Language language);

private:
    void hear();

    Document& m_document;
    Translation& m_translation;
    std::unique_ptr<MainWindow> m_window;
};

} // namespace ripstop
