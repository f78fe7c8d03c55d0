// The next material of the library: one step lighter, heavier, softer, stiffer, weaker or
// stronger.
//
// A step stays with its kind: from sheet to sheet, from line to line, from spar to spar. Weight is
// mass per area of sheets and per length of lines and spars; stiffness is E t of sheets, EA of
// lines and EI of spars; strength is that of the warp, of the line, or the moment at which a spar
// breaks, times the joint efficiency: a line of 500 N whose knots leave 0.6 is weaker than one of
// 450 N that is spliced. What does not know a weight, stiffness or strength that the material has
// is passed over, because a step must not lose what masses and margins are made of. Of several
// that are equally far the one whose other number is nearest is taken.
#pragma once

#include "base/result.h"
#include "materials/presets.h"

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace ripstop {

enum class MaterialStep { Lighter, Heavier, Softer, Stiffer, Weaker, Stronger };
inline constexpr int materialStepCount = 6;
inline constexpr std::array<MaterialStep, materialStepCount> allMaterialSteps{
    MaterialStep::Lighter, MaterialStep::Heavier, MaterialStep::Softer,
    MaterialStep::Stiffer, MaterialStep::Weaker,  MaterialStep::Stronger};
std::string_view materialStepName(MaterialStep step); // "lighter", ...

// The next material, or a sentence that says why there is none.
Result<const Preset*> neighbour(const Material& material, MaterialStep step,
                                std::span<const Preset> own = {});

// What the preset changes of the numbers that a step looks at, one line each in the units in which
// they are bought: "Areal density 47 → 38 g/m²".
std::vector<Message> changesBy(const Preset& preset, const Material& before);

// One step of each of these materials, as one edit; masses follow. Fails where one of them has no
// next one.
struct StepEdit
{
    PresetEdit edit;
    std::vector<GivenPreset> given; // in the order of the materials
};
Result<StepEdit> stepEdit(const Scene& scene, const std::vector<Id>& materials, MaterialStep step,
                          std::span<const Preset> own = {});

} // namespace ripstop
