// The races of ripstop-cli bench. Each prints its rows as they come, unless asked for JSON, and
// returns an array of them; nothing when interrupted.
#pragma once

#include "bench/timing.h"
#include "terminal/terminal.h"

#include <optional>
#include <span>
#include <string>

namespace ripstop {

struct BenchOptions
{
    std::string filter;    // only networks with this in their name
    double seconds = 0.0;  // s of wall time for each network; 0 as each race likes it
    int threads = 2;       // compared with one
    bool quick = false;    // only small networks, and short
    bool thorough = false; // search for the least effort however long it takes
    bool json = false;
    std::string references; // folder
};

bool isWanted(const BenchOptions& options, const std::string& network);

// The name says which race `--race` picks.
struct Race
{
    const char* name;
    std::optional<Json> (*run)(const BenchOptions&);
};

std::span<const Race> races(); // in the order in which they are run

// Cost of a projection, steps of craft in air, memory of the largest cloth.
std::optional<Json> projectionRace(const BenchOptions& options);

// Time to quality.
std::optional<Json> qualityRace(const BenchOptions& options);

// Cost of a sweep against the number of particles.
std::optional<Json> growthRace(const BenchOptions& options);

// From an edit of a large scene to the running simulation.
std::optional<Json> editRace(const BenchOptions& options);

// Writing a flight in each format of animations and tables.
std::optional<Json> exportRace(const BenchOptions& options);

} // namespace ripstop
