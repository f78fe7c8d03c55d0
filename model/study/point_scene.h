// The scene of one point of a study: a design with other values.
//
//     line.axialStiffness=6000      a property (scene/path.h)
//     wind.velocity.x=7             one number of a property that has three
//     kite.built.span=2.8           a parameter of the builder of the part "kite"
//     controls=launch.csv           no property: the control track that is flown (opened_study.h)
//
// Parts are built again first (author/rebuild.h), all of their parameters at once, and properties
// are set in what comes of that, in their order. --set, sweeps and studies all set by this, so that
// a row of a table can be flown again; who has threads carry a fabric that has none gets them
// (derived/thread_fabric.h).
#pragma once

#include "base/result.h"
#include "scene/edit.h"

#include <string>
#include <string_view>
#include <vector>

namespace ripstop {

inline constexpr std::string_view controlsPath = "controls";
bool setsControls(const std::string& assignment);

// Sets a property, or one number of it. Those of builders and controls are no such edit.
Result<Edit> propertyAssignment(const Scene& scene, const std::string& assignment);

// Fails with a sentence that names the text which cannot be.
Result<Scene> sceneWith(const Scene& scene, const std::vector<std::string>& assignments);

// The same as one edit of the scene; controls, which are nothing of a design, are left out.
//   label  of the step that undo takes back
Result<Edit> editWith(const Scene& scene, const std::vector<std::string>& assignments,
                      Message label);

// Of what a path sets, or empty.
std::string unitOf(const Scene& scene, const std::string& path);

// Those of the paths that set parameters of builders which change nothing of this design, whatever
// the others set: the mass of a hoop where there is none.
std::vector<std::string> idleAmong(const Scene& scene, const std::vector<std::string>& paths);

// Whether it can be set in this scene, beside no other.
std::optional<Failure> checkAssignment(const Scene& scene, const std::string& assignment);

} // namespace ripstop
