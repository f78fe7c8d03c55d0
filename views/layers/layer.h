// One thing that the view draws. Layers share the points of a picture and never copy them.
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
