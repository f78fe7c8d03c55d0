// Rows that exclude each other, such as themes and languages: one is kept from start to start.
#pragma once

#include "actions/menu_rows.h"

#include <functional>
#include <span>

namespace ripstop {

struct KeptChoice
{
    const char* action;
    const char* name;
    const char* tip;
};

// A row for each, below `menu`, in their order; `kept` is the one that holds now. The name of the
// group is that of MenuRow.
inline MenuRows choiceRows(const char* menu, const char* group, std::span<const KeptChoice> choices,
                           std::size_t kept, const std::function<void(std::size_t)>& choose)
{
    MenuRows rows;
    for (std::size_t i = 0; i < choices.size(); ++i)
        rows.push_back({menu,
                        choices[i].action,
                        tr(choices[i].name),
                        nullptr,
                        {},
                        tr(choices[i].tip),
                        [choose, i] { choose(i); },
                        i == kept ? Toggle::On : Toggle::Off,
                        group});
    return rows;
}

} // namespace ripstop
