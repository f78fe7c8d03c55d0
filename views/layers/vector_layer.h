// Arrows on the elements: velocities, loads of the air on panels, or tensions of links.
//
// vectorsOf() says which arrows a frame has, in physical units; the layer scales and draws them.
// Their scale is found from the arrows themselves, so that arrows of different quantities are about
// as long.
#pragma once

#include "layers/arrow_set.h"
#include "layers/layer.h"
#include "look/steady_range.h"
#include "look/vectors.h"

namespace ripstop {

// One arrow, not scaled yet.
struct VectorArrow
{
    Vec3 place; // m, its tail
    Vec3 value; // m/s or N
};

// Velocities stand on particles, loads of the air on the middles of panels, tensions on both ends
// of links, along them. Of more than some thousand elements every n-th has an arrow.
std::vector<VectorArrow> vectorsOf(const Frame& frame, Vectors vectors);

// The longest arrow is a share of what is shown, and that length keeps its meaning while values
// change little.
class VectorLayer final : public Layer
{
public:
    VectorLayer();

    void setKind(Vectors kind);

    void addTo(vtkRenderer& renderer) override;
    void setShown(bool shown) override;
    void rebuild(const Picture& picture) override;
    void update(const Picture& picture) override;

private:
    Vectors m_kind = Vectors::None;
    SteadyRange m_range;
    ArrowSet m_arrows;
};

} // namespace ripstop
