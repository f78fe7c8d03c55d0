#include "actions/choice_rows.h"

#include "actions/workbench.h"
#include "language/language.h"

#include <QMainWindow>
#include <QStatusBar>

#include <array>

namespace ripstop {
namespace {

// In the order of Language: each by its own name, System in the language of the window.
constexpr std::array<KeptChoice, 3> choices{{
    {"languageSystem", QT_TRANSLATE_NOOP("Actions", "&System"),
     QT_TRANSLATE_NOOP("Actions", "The language of the desktop, from the next start on.")},
    {"languageEnglish", "&English",
     QT_TRANSLATE_NOOP("Actions", "English, from the next start on.")},
    {"languageFrench", "&Fran\u00e7ais",
     QT_TRANSLATE_NOOP("Actions", "French, from the next start on.")},
}};

void choose(Language language, QMainWindow& window)
{
    keepLanguage(language);
    window.statusBar()->showMessage(
        tr("The language is kept, and heard when Ripstop starts the next time."), 8000);
}

} // namespace

MenuRows languageRows(const Workbench& bench)
{
    return choiceRows("&View/Lan&guage", "language", choices, std::size_t(keptLanguage()),
                      [&window = bench.window](std::size_t i) { choose(Language(i), window); });
}

} // namespace ripstop
