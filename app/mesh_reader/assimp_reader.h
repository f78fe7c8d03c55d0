// Reads a file of a mesh by assimp.
#pragma once

#include "shapes/mesh_answer.h"

#include <functional>
#include <string>

namespace ripstop {

// The last record of the answer: the mesh, or why there is none. `tell` hears how far it has come,
// 0 to 1.
std::string answerOfAssimp(const std::string& file, const std::function<void(double)>& tell);

} // namespace ripstop
