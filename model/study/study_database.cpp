// The database is made in memory, so that what comes to the disk is one file that is written whole.
#include "study/study_database.h"

#ifdef RIPSTOP_HAS_SQLITE

#include "base/program_version.h"
#include "io/csv.h"
#include "io/json_text.h"
#include "io/whole_file.h"
#include "study/study_table.h"

#include <sqlite3.h>

#include <fstream>
#include <memory>

namespace ripstop {
namespace {

using Database = std::unique_ptr<sqlite3, decltype(&sqlite3_close)>;
using Statement = std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)>;
using Texts = std::vector<std::string>;

std::string quotedName(const std::string& name)
{
    std::string text(1, '"');
    for (const char c : name)
        text.append(c == '"' ? 2 : 1, c);
    return text + '"';
}

bool makeTable(sqlite3* database, const char* name, const Texts& columns, const char* type)
{
    std::string text = std::string("CREATE TABLE ") + name + " (";
    for (std::size_t i = 0; i < columns.size(); ++i)
        text += (i ? ", " : "") + quotedName(columns[i]) + type;
    return sqlite3_exec(database, (text + ")").c_str(), nullptr, nullptr, nullptr) == SQLITE_OK;
}

// Numbers of a cell as numbers, nothing as null. A hash, which may look like a number, is a text.
bool bindCell(sqlite3_stmt* statement, int place, const std::string& cell, bool isText)
{
    if (cell.empty() && !isText)
        return sqlite3_bind_null(statement, place) == SQLITE_OK;
    if (const auto number = isText ? std::nullopt : cellNumber(cell))
        return sqlite3_bind_double(statement, place, *number) == SQLITE_OK;
    return sqlite3_bind_text(statement, place, cell.data(), int(cell.size()), SQLITE_TRANSIENT)
           == SQLITE_OK;
}

bool addRows(sqlite3* database, const char* table, const std::vector<Texts>& rows,
             const std::vector<bool>& isText)
{
    std::string text = std::string("INSERT INTO ") + table + " VALUES (";
    for (std::size_t i = 0; i < isText.size(); ++i)
        text += i ? ",?" : "?";
    sqlite3_stmt* made = nullptr;
    sqlite3_prepare_v2(database, (text + ")").c_str(), -1, &made, nullptr);
    const Statement statement(made, sqlite3_finalize);
    if (!made)
        return false;
    for (const Texts& row : rows) {
        for (std::size_t i = 0; i < isText.size(); ++i)
            if (!bindCell(made, int(i) + 1, i < row.size() ? row[i] : std::string(), isText[i]))
                return false;
        if (sqlite3_step(made) != SQLITE_DONE || sqlite3_reset(made) != SQLITE_OK)
            return false;
    }
    return true;
}

// Column names are told apart without their case, as SQLite sees them.
Texts distinctColumns(const Texts& names)
{
    Texts all;
    const auto isTaken = [&](const std::string& name) {
        return std::ranges::any_of(all, [&](const std::string& one) {
            return sqlite3_stricmp(one.c_str(), name.c_str()) == 0;
        });
    };
    for (const std::string& name : names) {
        std::string own = name;
        for (int i = 2; isTaken(own); ++i)
            own = name + " (" + std::to_string(i) + ")";
        all.push_back(own);
    }
    return all;
}

bool fill(sqlite3* database, const OpenedStudy& opened, const StudyFlights& flights)
{
    const StudyTableRows table = studyTableRows(opened, flights);
    std::vector<bool> isText;
    for (const std::string& column : table.columns)
        isText.push_back(column == "hash" || column == "stopped" || column == "accuracy");
    const Study& study = opened.study;
    const std::vector<Texts> about{
        {"program", "Ripstop " + programVersion()},
        {"scene", study.scene},
        {"seconds", numberText(study.seconds)},
        {"plan", std::string(choiceNames<StudyPlan::Kind>[std::size_t(study.plan.kind)])},
        {"points", std::to_string(opened.points.count())},
        {"text", studyText(study)}};
    const auto execute = [&](const char* text) {
        return sqlite3_exec(database, text, nullptr, nullptr, nullptr) == SQLITE_OK;
    };
    return execute("BEGIN") && makeTable(database, "flights", distinctColumns(table.columns), "")
           && makeTable(database, "study", {"key", "value"}, " TEXT")
           && addRows(database, "flights", table.rows, isText)
           && addRows(database, "study", about, {true, true}) && execute("COMMIT");
}

bool isDatabaseOrFree(const std::filesystem::path& file)
{
    std::error_code error;
    if (!std::filesystem::exists(file, error))
        return true;
    std::ifstream stream(file, std::ios::binary);
    std::string start(15, '\0');
    stream.read(start.data(), std::streamsize(start.size()));
    return start == "SQLite format 3";
}

} // namespace

std::optional<Failure> writeStudyDatabase(const OpenedStudy& opened, const StudyFlights& flights,
                                          const std::filesystem::path& file)
{
    if (!isDatabaseOrFree(file))
        return Failure("%1 is there and is no database of SQLite; it is left as it is.",
                       file.string());
    sqlite3* made = nullptr;
    sqlite3_open(":memory:", &made);
    const Database database(made, sqlite3_close);
    if (!made || !fill(made, opened, flights))
        return Failure("%1 cannot be written: %2.", file.string(),
                       made ? sqlite3_errmsg(made) : "no memory");
    sqlite3_int64 size = 0;
    const std::unique_ptr<unsigned char, decltype(&sqlite3_free)> bytes(
        sqlite3_serialize(made, "main", &size, 0), sqlite3_free);
    if (!bytes)
        return Failure("%1 cannot be written: %2.", file.string(), "no memory");
    return replaceFile(
        file, std::string_view(reinterpret_cast<const char*>(bytes.get()), std::size_t(size)));
}

} // namespace ripstop

#else

namespace ripstop {

std::optional<Failure> writeStudyDatabase(const OpenedStudy&, const StudyFlights&,
                                          const std::filesystem::path& file)
{
    return Failure("%1 is not written: this Ripstop was built without SQLite.", file.string());
}

} // namespace ripstop

#endif
