#include "builders/delta_wing.h"

#include <cmath>

namespace ripstop {

Vec3 sailPoint(const DeltaShape& shape, double s, double u)
{
    const double halfSpan = 0.5 * shape.span;
    const double side = std::abs(u);
    const double out = s * side; // share of the half span
    const double behindEdge = shape.chord * (s - out);
    const double height = std::tan(shape.dihedral) * out * halfSpan
                          + shape.billow * s * halfSpan * 4.0 * side * (1.0 - side)
                          + std::tan(shape.washout) * out * behindEdge
                          + shape.reflex * shape.chord * s * s;
    return {-s * shape.chord, height, u * s * halfSpan};
}

Lattice addSail(Network& network, const DeltaShape& shape, int segments,
                const SailMaterials& materials)
{
    const Lattice lattice(segments, [&](int row, int column) {
        const double u = row == 0 ? 0.0 : 2.0 * column / row - 1.0;
        const double s = double(row) / segments;
        const Id node = network.particle(sailPoint(shape, s, u));
        network.texture(node, 0.5 + 0.5 * u * s, 1.0 - s);
        return node;
    });
    for (const Lattice::Edge& edge : lattice.edges()) {
        const bool isTrailing = edge.sort == Lattice::Edge::Sort::Row && edge.row == segments;
        network.rod(edge.from, edge.to,
                    edge.onSide  ? materials.edges
                    : isTrailing ? materials.hem
                                 : materials.seams);
    }
    for (const Lattice::Cell& cell : lattice.cells()) {
        const bool atEdge = cell.column == 0 || cell.column == 2 * cell.row;
        network.panel(cell.a, cell.b, cell.c, atEdge ? materials.border : materials.sail);
    }
    return lattice;
}

std::vector<Id> addStiffeners(Network& network, const DeltaShape& shape, const Lattice& lattice,
                              Id material)
{
    std::vector<Id> held = lattice.sides();
    for (const Id node : lattice.median())
        held.push_back(node);
    std::vector<Id> stiffeners;
    for (const double side : {1.0, -1.0}) {
        const Vec3 place(-0.65 * shape.chord, side * 0.4 * shape.chord, 0.0);
        stiffeners.push_back(network.particle(place));
        network.spokes(stiffeners.back(), held, material);
    }
    return stiffeners;
}

Vec3 headwind(double speed, double angle)
{
    return speed * Vec3(-std::cos(angle), std::sin(angle), 0.0);
}

} // namespace ripstop
