// The variable that a study gets when somebody points at a property and says "study this".
#pragma once

#include "scene/slider.h"
#include "study/study.h"

#include <optional>

namespace ripstop {

inline constexpr int suggestedSteps = 5;

// The value of all these things together. A number goes over the range of its slider, or, without
// one, from half of its value to twice of it; a whole number over those in between; a choice
// through all of its names, a switch through both, a vector through parts of its length. Fails for
// texts and references, and for numbers whose range is not known because they are absent.
Result<StudyVariable> suggestedVariable(const Scene& scene, const Property& property,
                                        const std::vector<Id>& ids,
                                        const std::optional<SliderRange>& range = std::nullopt);

} // namespace ripstop
