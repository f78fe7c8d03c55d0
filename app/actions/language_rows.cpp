#include "actions/choice_rows.h"

#include "actions/workbench.h"
#include "language/language.h"

#include <array>

namespace ripstop {
namespace {

// In the order of Language: each by its own name, System in the language of the window.
constexpr std::array<KeptChoice, 3> choices{{
    {"languageSystem", QT_TRANSLATE_NOOP("Actions", "&System"),
     QT_TRANSLATE_NOOP("Actions", "The language of the desktop.")},
    {"languageEnglish", "&English",
     QT_TRANSLATE_NOOP("Actions", "The window in English, at once.")},
    {"languageFrench", "&Fran\u00e7ais",
     QT_TRANSLATE_NOOP("Actions", "The window in French, at once.")},
}};

void choose(Language language, const Workbench& bench)
{
    keepLanguage(language);
    bench.speak(language);
}

} // namespace

MenuRows languageRows(const Workbench& bench)
{
    return choiceRows(QT_TRANSLATE_NOOP("Actions", "&View/Lan&guage"), "language", choices,
                      std::size_t(keptLanguage()),
                      [&bench](std::size_t i) { choose(Language(i), bench); });
}

} // namespace ripstop
