// Paths: how a person names a property of a scene on one line.
//
//     settings.timeStep             a setting
//     wind.velocity                 an item by its name
//     #17.mass                      an item or an element by its id
//     kite.particles.mass           all elements of a part at once
#pragma once

#include "scene/edit.h"

namespace ripstop {

struct Place
{
    const Property* property;
    std::vector<Id> targets;
};

// A message names the nearest thing that exists.
Result<Place> findPlace(const Scene& scene, std::string_view path);

// The path that findPlace() takes to this property of one thing: by the name of an item where no
// other is found by it, else by its id.
std::string pathOf(const Scene& scene, Id id, const Property& property);

// The first item of this kind with this name, or that with the id "#17". A message names the
// nearest one.
Result<Id> findNamed(const Scene& scene, Kind kind, std::string_view name);

// "PATH=VALUE" as an edit.
Result<Edit> assignment(const Scene& scene, std::string_view text);

} // namespace ripstop
