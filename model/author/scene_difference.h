// What two designs differ in, in words, the most important first.
//
// Things are paired (author/scene_pairs.h) and compared property by property; equal changes of many
// elements are one difference. Where a part was built with other parameters, those are told and not
// the rows that follow from them. Numbers of ids, the order of items, and what stands in neither
// file say nothing.
#pragma once

#include "scene/property.h"

#include <optional>
#include <string>
#include <vector>

namespace ripstop {

// The importance falls in this order.
enum class DifferenceKind {
    Added,     // an item, in the second only
    Removed,   // an item, in the first only
    Parameter, // of a builder
    ByHand,    // rows of a part that its builder did not make so
    Count,     // of the rows of a part
    Property,
    Unknown // to this version of the program
};

struct SceneDifference
{
    DifferenceKind what;
    Kind kind;                // of the things that differ
    std::string item;         // the one that differs, or that the elements are of; its name
    std::string key;          // of a property or a parameter; "particles" of a count
    std::string unit;         // SI
    Value from;               // nothing where there is none, or several
    Value to;                 // likewise
    std::vector<Id> inFirst;  // what differs; ascending
    std::vector<Id> inSecond; // likewise
    Message text;             // all of it, as one line
};

std::vector<SceneDifference> differencesOf(const Scene& first, const Scene& second);

// "152 particles, 458 links, 221 panels, 350 g".
Message sizeOf(const Scene& scene);

} // namespace ripstop
