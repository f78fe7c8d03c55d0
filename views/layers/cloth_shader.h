// How cloth takes light, as a piece of program for the graphics card.
//
// Added to VTK's own lighting of a surface that has normals: light of the sky from above and of the
// ground from below; less of the sun where other fabric is in its way; what comes through from a
// sun behind it, in the colour of the cloth; a sheen where it is seen at a slant; and the weave at
// its true size, a ripstop's grid and the yarns, each fading out before its threads get as narrow
// as a pixel, so that cloth from afar is plain.
//
// Colours that stand for numbers are left alone but for an edge that is seen at a slant, which is
// darker: without light a sail of one colour would have no shape.
#pragma once

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>

namespace ripstop {

// The name of the array of points that has the ClothPoint (look/fabric.h) of each vertex.
inline constexpr const char* clothPointArray = "clothPoint";

// That of how much of the sun's light other fabric keeps from it (look/sun_shade.h), 0 to 1.
inline constexpr const char* sunShadeArray = "sunShade";

enum class Shown { Cloth, Numbers };

// Makes a mesh of these: points, normals, and the arrays of those names.
void joinCloth(vtkPolyData& mesh, vtkPoints& points, vtkFloatArray& normals, vtkFloatArray& onCloth,
               vtkFloatArray& shade);

// Has the actor look like cloth. Its mapper must be given points with those arrays.
void addClothShader(vtkActor& actor, vtkPolyDataMapper& mapper);

// What the colours of the actor are.
void showAs(vtkActor& actor, Shown shown);

} // namespace ripstop
