// How cloth takes light, as a piece of program for the graphics card.
//
// Added to VTK's own lighting of a surface that has normals: light of the sky from above and of the
// ground from below; less of these and of the sun where other fabric is in their way; what comes
// through from a sun behind it, in the colour of the cloth; a sheen where it is seen at a slant;
// and the weave at its true size, a ripstop's grid and the yarns, each fading out before its
// threads get as narrow as a pixel, so that cloth from afar is plain.
//
// Colours that stand for numbers are left alone but for an edge that is seen at a slant, which is
// darker: without light a sail of one colour would have no shape.
#pragma once

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>

#include <array>

namespace ripstop {

// The name of the array of points that has the ClothPoint (look/fabric.h) of each vertex.
inline constexpr const char* clothPointArray = "clothPoint";

// That of how much light other fabric keeps from it, 0 to 1: of the sun (look/self_shade.h), and of
// all around, of the side of the normal and of the other (look/sky_shade.h).
inline constexpr const char* shadeArray = "shade";
using Shades = std::array<float, 3>;

enum class Shown { Cloth, Numbers };

// Makes a mesh of these: points, normals, and the arrays of those names.
void joinCloth(vtkPolyData& mesh, vtkPoints& points, vtkFloatArray& normals, vtkFloatArray& onCloth,
               vtkFloatArray& shade);

// Has the actor look like cloth. Its mapper must be given points with those arrays.
void addClothShader(vtkActor& actor, vtkPolyDataMapper& mapper);

// What the colours of the actor are.
void showAs(vtkActor& actor, Shown shown);

} // namespace ripstop
