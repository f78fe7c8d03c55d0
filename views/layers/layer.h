// One thing that the view draws.
//
// The stage owns all layers, adds them to its renderer once, and then calls rebuild() and update()
// with a Picture, at most once each before VTK renders. Layers share the points of a picture and
// never copy them (ghosts, which have another layout, are the exception). They never render by
// themselves and run in the thread of the window only.
#pragma once

#include "layers/picture.h"
#include "look/look.h"

class vtkRenderer;

namespace ripstop {

class Layer
{
public:
    virtual ~Layer() = default;

    virtual void addTo(vtkRenderer& renderer) = 0;
    virtual void setShown(bool shown) = 0;

    // What exists and how it looks has changed: another layout, an edit, something tore, another
    // theme or another quantity to colour by.
    virtual void rebuild(const Picture& picture) = 0;

    // Another instant, after rebuild() when both are due.
    virtual void update(const Picture& picture) = 0;
};

} // namespace ripstop
