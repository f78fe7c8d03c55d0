#include "actions/choice_rows.h"

#include "actions/workbench.h"
#include "theme/theme_choice.h"

#include <QApplication>

#include <array>

namespace ripstop {
namespace {

// In the order of ThemeChoice.
constexpr std::array<KeptChoice, 3> choices{{
    {"themeSystem", QT_TRANSLATE_NOOP("Actions", "&System"),
     QT_TRANSLATE_NOOP("Actions", "Light or dark, as the desktop is.")},
    {"themeLight", QT_TRANSLATE_NOOP("Actions", "&Light"),
     QT_TRANSLATE_NOOP("Actions", "Dark text on a light ground.")},
    {"themeDark", QT_TRANSLATE_NOOP("Actions", "&Dark"),
     QT_TRANSLATE_NOOP("Actions", "Light text on a dark ground.")},
}};

void choose(ThemeChoice choice)
{
    keepThemeChoice(choice);
    applyThemeChoice(*qApp, choice);
}

} // namespace

MenuRows themeRows(const Workbench& bench)
{
    MenuRows rows =
        choiceRows(QT_TRANSLATE_NOOP("Actions", "&View/T&heme"), "theme", choices,
                   std::size_t(keptThemeChoice()), [](std::size_t i) { choose(ThemeChoice(i)); });
    rows.push_back({"&View",
                    "resetLayout",
                    tr("Reset la&yout"),
                    nullptr,
                    {},
                    tr("All panels at the places and in the sizes that they had at first."),
                    bench.resetLayout});
    return rows;
}

} // namespace ripstop
