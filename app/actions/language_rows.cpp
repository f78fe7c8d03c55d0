#include "actions/menu_rows.h"

#include "actions/workbench.h"
#include "language/language.h"

#include <QMainWindow>
#include <QStatusBar>

#include <array>

namespace ripstop {
namespace {

struct Choice
{
    const char* action;
    const char* name; // each language by its own name; System in the language of the window
    const char* tip;
};

// In the order of Language.
constexpr std::array<Choice, 3> choices{{
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
    MenuRows rows;
    const Language kept = keptLanguage();
    for (std::size_t i = 0; i < choices.size(); ++i)
        rows.push_back({"&View/Lan&guage",
                        choices[i].action,
                        tr(choices[i].name),
                        nullptr,
                        {},
                        tr(choices[i].tip),
                        [&window = bench.window, i] { choose(Language(i), window); },
                        Language(i) == kept ? Toggle::On : Toggle::Off,
                        "language"});
    return rows;
}

} // namespace ripstop
