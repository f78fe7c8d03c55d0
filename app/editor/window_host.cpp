#include "editor/window_host.h"

#include "document/document.h"
#include "document/recordings.h"

#include <QApplication>
#include <QTimer>

#include <utility>

namespace ripstop {
namespace {

constexpr int lookAgain = 100; // ms, while a dialog has to be answered

} // namespace

WindowHost::WindowHost(Document& document, Selection& selection, Player& player,
                       MainWindow::Memory memory, Translation& translation)
    : m_document(document)
    , m_translation(translation)
    , m_window(std::make_unique<MainWindow>(document, selection, player, memory))
{
    hear();
}

// Queued, because the window goes whose menu or dialog has said it.
void WindowHost::hear()
{
    connect(m_window.get(), &MainWindow::languageChosen, this, &WindowHost::speak,
            Qt::QueuedConnection);
}

void WindowHost::speak(Language language)
{
    if (QApplication::activeModalWidget() || QApplication::activePopupWidget()) {
        QTimer::singleShot(lookAgain, this, [this, language] { speak(language); });
        return;
    }
    m_translation.install(language);
    m_document.retranslate();
    auto next = std::make_unique<MainWindow>(*m_window);
    std::swap(m_window, next); // what has been replaced goes at the end, when the other stands
    m_window->recordings().retranslate();
    hear();
}

} // namespace ripstop
