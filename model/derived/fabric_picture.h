// Where the picture of a material lies on the fabric.
//
// A picture has s from 0 at its left to 1 at its right and t from 0 at its foot to 1 at its top.
// Laid over the mesh, its middle is where u and v are 1/2; where no particle of the fabric has u
// and v, they go over the box around it. With a width in metres one picture is as wide on the
// cloth, by how far u and v go there on average, and repeats. It is then moved and turned about its
// middle. Views and exports ask here.
#pragma once

#include "scene/scene.h"

#include <array>
#include <filesystem>
#include <optional>
#include <vector>

namespace ripstop {

// The file that the material names, beside the file of the scene unless its path is a whole one.
std::filesystem::path placeOfPicture(const Scene& scene, const Material& material);

// What keeps the picture of a material from being printed, as a sentence, or nothing.
std::optional<Message> pictureWarning(const Scene& scene, const Material& material);

struct PrintedPoint
{
    std::uint32_t particle;   // id
    std::array<double, 2> at; // s and t
};

// The particles of the panels that have the material, in ascending order, each with its place in
// the picture. Nothing when the material has none, or none that can be printed.
std::vector<PrintedPoint> printedPoints(const Scene& scene, Id material);

} // namespace ripstop
