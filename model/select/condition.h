// What is selected by what it is: conditions as people type them.
//
//     mass < 1 g                     a property, an operator, a value and its unit
//     strain > 5 % and length > 2 m  both at once
//     pinned      not pinned         a switch
//     material = ripstop             a thing by its name or as #17, a choice by its word
//     position.y > 2 m               one number of a vector
//     link.tearLimit < 20            of one kind only
//     part = kite, group = edge      elements that belong there
//
// Operators: = != < <= > >=. A number without unit is in the unit of the quantity, decimals may
// have a comma. Where a link leaves a number to its material, that of the material counts. Keys are
// those of elements; those that only items have (`limit`, `radius`) find items.
#pragma once

#include "scene/property.h"

#include <functional>

namespace ripstop {

// What can be measured on an instant of a simulation, as the author room sees it: without knowing
// what a simulation is.
struct Measurement
{
    struct Key
    {
        std::string_view key;
        std::string_view unit;
        std::string_view help; // one sentence
        Kinds kinds;
    };
    struct Reading
    {
        std::vector<Id> ids;        // of one kind, in any order
        std::vector<double> values; // [ids] in the unit of the key
    };
    std::span<const Key> keys;
    std::function<Reading(const Key&, Kind)> read; // empty when there is nothing to measure on
};

// The ids of all that meets the condition, ascending. A failure names the place in the text and
// what could be there instead.
Result<std::vector<Id>> matching(const Scene& scene, const Measurement& measurement,
                                 std::string_view text);

// The keys that a condition about elements can begin with.
struct ConditionKey
{
    std::string key;
    std::string unit;
    std::string help;
    Kinds kinds;
};
std::vector<ConditionKey> conditionKeys(const Measurement& measurement);

} // namespace ripstop
