// Operations with parameters, as data: mirror, arrays, weld, mass, split.
//
// An operation is one row of a table: its parameters with unit, default, range and choices, and a
// function from scene, selection and values to an edit. One dialog serves them all, with a preview.
#pragma once

#include "base/result.h"
#include "builders/builder.h"
#include "scene/edit.h"

#include <optional>

namespace ripstop {

struct Shaped
{
    Edit edit;
    std::optional<std::vector<Id>> selected = {}; // what to select then; as before without
};

struct Operation
{
    std::string_view name;
    std::string_view label; // on screen
    std::string_view help;  // in two or three sentences
    std::span<const Parameter> parameters;
    // Every parameter is there and in range. Fails with a sentence that says what to select.
    Result<Shaped> (*apply)(const Scene&, const std::vector<Id>& ids, const Parameters&);
};

std::span<const Operation> allOperations();
const Operation* findOperation(std::string_view name); // null when there is none

// A parameter that is a number of things or the place of a choice.
inline int whole(const Parameters& values, const char* key) { return int(values.at(key)); }

} // namespace ripstop
