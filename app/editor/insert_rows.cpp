#include "editor/insert_rows.h"

#include "builders/builder.h"
#include "editor/actions.h"

namespace ripstop {
namespace {

QString text(std::string_view words)
{
    return QString::fromUtf8(words.data(), qsizetype(words.size()));
}

// "insert delta_kite", which lives as long as the program.
const char* idOf(std::size_t builder)
{
    static const std::vector<std::string> ids = [] {
        std::vector<std::string> all;
        for (const Builder& one : allBuilders())
            all.push_back("insert " + std::string(one.name));
        return all;
    }();
    return ids[builder].c_str();
}

} // namespace

std::vector<MenuRow> insertRows(const Workbench& bench)
{
    std::vector<MenuRow> rows;
    const auto insert = bench.insert;
    for (std::size_t i = 0; i < allBuilders().size(); ++i) {
        const Builder& builder = allBuilders()[i];
        if (i > 0 && builder.family != allBuilders()[i - 1].family)
            rows.push_back({"&Insert", nullptr, {}, nullptr, {}, {}, {}});
        const bool isObstacle = builder.family == Family::Obstacles;
        rows.push_back({"&Insert",
                        idOf(i),
                        text(builder.label) + QChar(0x2026),
                        isObstacle ? "collider" : "builder",
                        {},
                        text(builder.help),
                        [insert, name = text(builder.name)] { insert(name); }});
    }
    return rows;
}

} // namespace ripstop
