#include "actions/menu_rows.h"

#include "actions/workbench.h"
#include "theme/theme_choice.h"

#include <QApplication>

#include <array>

namespace ripstop {
namespace {

struct Choice
{
    const char* action;
    const char* name;
    const char* tip;
};

// In the order of ThemeChoice.
constexpr std::array<Choice, 3> choices{{
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
    MenuRows rows;
    const ThemeChoice kept = keptThemeChoice();
    for (std::size_t i = 0; i < choices.size(); ++i)
        rows.push_back({"&View/T&heme",
                        choices[i].action,
                        tr(choices[i].name),
                        nullptr,
                        {},
                        tr(choices[i].tip),
                        [i] { choose(ThemeChoice(i)); },
                        ThemeChoice(i) == kept ? Toggle::On : Toggle::Off,
                        "theme"});
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
