#include "actions/other_words.h"

#include "actions/menu_row.h"

#include <algorithm>
#include <array>

namespace ripstop {
namespace {

struct OtherWords
{
    const char* id;
    const char* words;
};

// Words that stand in the name, the menu or the tip are found without being said here.
constexpr std::array table{
    OtherWords{"fit", QT_TRANSLATE_NOOP("Actions", "zoom frame all reset camera")},
    OtherWords{"fitSelected", QT_TRANSLATE_NOOP("Actions", "zoom frame selected focus")},
    OtherWords{"picture", QT_TRANSLATE_NOOP("Actions", "screenshot image snapshot")},
    OtherWords{"film", QT_TRANSLATE_NOOP("Actions", "video movie animation")},
    OtherWords{"addProbe", QT_TRANSLATE_NOOP("Actions", "measure")},
    OtherWords{"dock.problems", QT_TRANSLATE_NOOP("Actions", "stability errors warnings")},
};

} // namespace

QString otherWords(const QString& id)
{
    const auto row =
        std::ranges::find_if(table, [&](const OtherWords& one) { return id == one.id; });
    return row == table.end() ? QString() : tr(row->words);
}

} // namespace ripstop
