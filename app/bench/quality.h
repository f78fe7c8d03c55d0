// How well a network is simulated: the largest strain, and whether it goes where it should.
//
// Strain alone lies: a cloth that is frozen has none. So the path of the mass centre over the first
// second is held against a converged reference.
#pragma once

#include "bench/timing.h"

#include <optional>

namespace ripstop {

// Mass centre, m, at the start and after each 10 ms of the first second: 101 places.
using Path = std::vector<Vec3>;

// The path of the rope with its pilot is a compound pendulum's, from theory; those of large cloths
// are read from FOLDER/NAME.csv; the others are computed with 1500 small steps for each 10 ms.
// A reference that is not in the folder is computed, which takes a minute for cloth_100.
Path referencePath(const BenchNetwork& network, const std::string& folder);

Path pathFromFile(const std::string& file); // that references are kept in; empty without

// Computes the references that are kept in files, whatever there is. False when one could not be
// written.
bool makeReferences(const std::string& folder);

struct Quality
{
    double strain = 0.0;      // 1, median over the frames of the last three quarters of the largest
    double centerError = 0.0; // m, RMS over the first second
    double seconds = 0.0;     // s of wall time for a frame, median
};

// Frames of 10 ms that strain is taken from: 200, or 120 for cloths of 100 a side and more.
int qualityFrames(const BenchNetwork& network);

// Runs the network with the setup and judges it. Returns nothing when interrupted.
std::optional<Quality> qualityOf(const BenchNetwork& network, const Setup& setup,
                                 const Path& reference);

} // namespace ripstop
