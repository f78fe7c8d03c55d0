// Craft of what one can buy, as tests build and look at them.
#pragma once

#include "builders/builder.h"
#include "builders/statics.h"
#include "materials/presets.h"
#include "model/sample_scenes.h"

#include <algorithm>

namespace ripstop {

inline const Parameter& parameterOf(const char* builder, std::string_view key)
{
    for (const Parameter& parameter : findBuilder(builder)->parameters)
        if (parameter.key == key)
            return parameter;
    qFatal("no such parameter");
}

inline double choice(const char* builder, std::string_view key, std::string_view name)
{
    const auto& choices = parameterOf(builder, key).choices;
    const auto found = std::ranges::find(choices, name);
    if (found == choices.end())
        qFatal("no such choice");
    return double(found - choices.begin());
}

inline Scene craft(const char* builder, const Parameters& given)
{
    const Result<Scene> scene = build(*findBuilder(builder), given);
    if (!scene)
        qFatal("%s", scene.message().english().c_str());
    return *scene;
}

// 24 gores of 1.1 oz nylon on cords of 445 N, 2.5 m from the apex to the skirt.
inline Parameters nylon(const Parameters& more = {})
{
    Parameters given{{"cloth", choice("parachute", "cloth", "mil_7020_1")},
                     {"cord", choice("parachute", "cord", "mil_5040_1")},
                     {"hoop", 0.0}};
    for (const auto& [key, value] : more)
        given[key] = value;
    return given;
}

inline Parameters nylonCross(const Parameters& more = {})
{
    Parameters given{{"cloth", choice("cross_parachute", "cloth", "mil_7020_1")},
                     {"cord", choice("cross_parachute", "cord", "mil_5040_1")}};
    for (const auto& [key, value] : more)
        given[key] = value;
    return given;
}

inline Parameters dacron(const Parameters& more = {})
{
    Parameters given{{"cloth", choice("hang_glider", "cloth", "dacron_sail")},
                     {"spars", choice("hang_glider", "spars", "aluminium_50")}};
    for (const auto& [key, value] : more)
        given[key] = value;
    return given;
}

inline double number(const char* preset, std::string_view key)
{
    for (const PresetNumber& number : (*findPreset(preset))->values)
        if (number.key == key)
            return std::get<double>(number.value);
    qFatal("%s has no %s", preset, std::string(key).c_str());
}

inline double massOf(const Part& part)
{
    double mass = 0.0;
    for (const Particle& particle : part.particles)
        mass += particle.mass;
    return mass;
}

inline std::vector<Id> members(const Scene& scene, std::string_view group)
{
    for (const Entry& entry : scene.items)
        if (const Group* found = std::get_if<Group>(&entry.item); found && found->name == group)
            return found->members;
    qFatal("no such group");
}

// Twice the mean distance of the skirt from its middle, m.
inline double mouthWidth(const Scene& scene, const Simulation& simulation)
{
    const std::vector<Id> skirt = members(scene, "skirt");
    const System& system = simulation.system();
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < system.key.size(); ++i)
        if (std::ranges::find(skirt, Id{system.key[i]}) != skirt.end())
            places.push_back(simulation.state().position[i]);
    Vec3 middle = Vec3::Zero();
    for (const Vec3& place : places)
        middle += place / double(places.size());
    double width = 0.0;
    for (const Vec3& place : places)
        width += 2.0 * (place - middle).norm() / double(places.size());
    return width;
}

} // namespace ripstop
