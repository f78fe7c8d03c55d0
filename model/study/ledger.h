// What of a study has been flown: lines that are only ever added to.
//
// A folder beside the study, NAME.ripstop-runs, has a file for each shard. Its lines are JSON: a
// heading, which names the measures, whenever somebody begins to write, and a row for each flight.
// A line is written at once when its flight is over, so that whoever is killed loses the flights
// under way and nothing else; a line that was torn by that is left out. Rows are found by a key of
// all that they depend on, so that what was flown once is never flown again, by whichever shard, in
// whichever study, and a study that is changed back has its rows still.
#pragma once

#include "base/result.h"
#include "study/flight.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

// Of a flight: the scene as it is written, the content of the files that it names, what is set in
// it, controls, end, measures and the version of the program.
class FlightKeys
{
public:
    // Fails when a file cannot be read.
    static Result<FlightKeys> of(const Scene& scene, const std::filesystem::path& controls,
                                 const FlightPlan& plan);

    //   assignments  "PATH=VALUE", in their order
    std::string of(const std::vector<std::string>& assignments) const;

    const std::string& design() const { return m_design; } // hash of scene and files alone

private:
    std::string m_common;
    std::string m_design;
};

Result<std::string> hashOfFile(const std::filesystem::path& file); // of its content

using LedgerRows = std::map<std::string, FlightResult>; // by key

std::filesystem::path ledgerFolder(const std::filesystem::path& study);

// The design that was flown, as it was then, by its hash: what is wanted when it was edited since.
std::filesystem::path keptDesign(const std::filesystem::path& folder, const std::string& hash);

// Another build has keys of its own, as it may fly otherwise: its rows stay, and are flown anew.
struct OtherBuild
{
    std::size_t rows = 0;
    std::string program; // the one that wrote last of them
};

// All rows of all shards. Rows of one key are the same; the first is taken.
struct LedgerContent
{
    LedgerRows rows;
    std::size_t torn = 0;             // lines that are no whole rows
    std::vector<std::string> designs; // hashes of those that were flown, in their order
    std::size_t differing = 0; // rows whose flight came to another hash than the first of their key
    OtherBuild other;
};
Result<LedgerContent> readLedgers(const std::filesystem::path& folder);

// One shard's file. Whoever adds from several threads lets them take turns.
class Ledger
{
public:
    // Makes the folder when there is none. Two processes may write one file: each line is one
    // write.
    static Result<Ledger> open(const std::filesystem::path& folder, const std::string& shard,
                               const std::vector<std::string>& headings, const std::string& design);
    Ledger(Ledger&& other) noexcept;
    Ledger& operator=(Ledger&&) = delete;
    ~Ledger();

    std::optional<Failure> add(const std::string& key, const FlightResult& flight);

private:
    Ledger(std::filesystem::path file, int descriptor);
    std::optional<Failure> write(std::string_view line);

    std::filesystem::path m_file;
    int m_descriptor;
};

} // namespace ripstop
