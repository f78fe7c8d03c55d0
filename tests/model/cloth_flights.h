// Flies scenes with a cloth of the library, and tells how that ended.
#pragma once

#include "materials/cloths.h"
#include "model/sample_scenes.h"
#include "run/end_check.h"

#include <algorithm>

namespace ripstop {

inline double densityOf(const Preset& cloth) // kg/m^2
{
    Material material;
    give(material, cloth);
    return material.arealDensity.value_or(0.0);
}

inline Scene madeOf(Scene scene, std::string_view cloth)
{
    const auto edit = presetEdit(scene, **findPreset(cloth), clothMaterials(scene));
    if (!edit)
        qFatal("%s", edit.message().english().c_str());
    (void)apply(scene, edit->edit);
    return scene;
}

struct Flown
{
    bool touched = false;
    std::string trouble; // of a run that was stopped, or of its end
    RunAccuracy accuracy;
};

// The watchdog stops what is not finite or faster than the limit of the scene; the end check tells
// of strains, places and energies that no fabric can have.
inline Flown flown(const Scene& scene, double seconds)
{
    const auto system = compile(scene);
    if (!system)
        qFatal("%s", system.message().english().c_str());
    Simulation simulation(*system);
    Flown result;
    while (result.trouble.empty()
           && !hasReached(simulation.state().time, seconds, (*system)->timeStep)) {
        if (!simulation.step())
            result.trouble = simulation.trouble()->message.english();
        result.touched =
            result.touched
            || std::ranges::any_of(simulation.touches(), [](auto touch) { return touch != 0; });
    }
    for (const Message& one : absurdities(simulation))
        result.trouble += one.english();
    result.accuracy = simulation.frame()->accuracy;
    return result;
}

inline bool hasCloth(const QString& name) { return !clothMaterials(sample(name)).empty(); }

} // namespace ripstop
