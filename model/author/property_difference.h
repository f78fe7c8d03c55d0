// What things of two scenes differ in, property by property, and how a change is put into words.
// scene_difference.cpp walks the scenes and calls these.
#pragma once

#include "author/scene_difference.h"
#include "author/scene_pairs.h"

#include <utility>

namespace ripstop {

using Differences = std::vector<SceneDifference>;

struct TwoScenes
{
    const Scene& first;
    const Scene& second;
    const ScenePairs& pairs;
};

// "0.1": six digits, or all of them.
Message numberInWords(double number, bool exactly = false);

// "kite: Mass 0.1 -> 0.2 kg".
Message changeInWords(const Message& subject, const Message& what, const Message& from,
                      const Message& to, const std::string& unit = {});

// The same of two numbers, both in the unit that suits the larger; what is no number is none.
Message changeOfNumber(const Message& subject, const Message& what, double from, double to,
                       const std::string& unit);

// Adds a difference for each property of one thing and its counterpart.
void compareThing(Differences& list, const TwoScenes& scenes, const std::string& name, Id first,
                  Id second, const ConstRef& a, const ConstRef& b);

// Adds one for each property of rows of a part, of all that it differs in.
template <typename Row>
using RowPairs = std::vector<std::pair<const Row*, const Row*>>;
template <typename Row>
void compareRows(Differences& list, const TwoScenes& scenes, const std::string& part,
                 const RowPairs<Row>& rows);

} // namespace ripstop
