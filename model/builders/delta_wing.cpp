// Where a point of the sail is; then the sail, as one lattice or as a half lattice on either side
// of the keel, row by row from the nose; and the struts above and below that keep a frame stiff.
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

namespace {

Id addNode(Network& network, const DeltaShape& shape, double s, double u)
{
    const Id node = network.particle(sailPoint(shape, s, u));
    network.texture(node, 0.5 + 0.5 * u * s, 1.0 - s);
    return node;
}

bool isTrailing(const Lattice::Edge& edge, const Lattice& lattice)
{
    return edge.sort == Lattice::Edge::Sort::Row && edge.row == lattice.segments();
}

} // namespace

SailFrame SailFrame::of(const Lattice& lattice)
{
    SailFrame frame{lattice.sides(), lattice.median()};
    frame.axis.insert(frame.axis.begin(), lattice.at(0, 0));
    return frame;
}

Lattice addSail(Network& network, const DeltaShape& shape, int segments,
                const SailMaterials& materials)
{
    const Lattice lattice(segments, [&](int row, int column) {
        const double u = row == 0 ? 0.0 : 2.0 * column / row - 1.0;
        return addNode(network, shape, double(row) / segments, u);
    });
    for (const Lattice::Edge& edge : lattice.edges())
        network.rod(edge.from, edge.to,
                    edge.onSide                 ? materials.edges
                    : isTrailing(edge, lattice) ? materials.hem
                                                : materials.seams);
    for (const Lattice::Cell& cell : lattice.cells()) {
        const bool atEdge = cell.column == 0 || cell.column == 2 * cell.row;
        network.panel(cell.a, cell.b, cell.c, atEdge ? materials.border : materials.sail);
    }
    return lattice;
}

std::vector<double> evenRows(int segments)
{
    std::vector<double> rows;
    for (int row = 0; row <= segments; ++row)
        rows.push_back(double(row) / segments);
    return rows;
}

SailFrame addHalves(Network& network, const DeltaShape& shape, const std::vector<double>& rows,
                    const SailMaterials& materials)
{
    const int segments = int(rows.size()) - 1;
    SailFrame frame;
    for (const double row : rows)
        frame.axis.push_back(addNode(network, shape, row, 0.0));
    for (const bool left : {true, false}) {
        const auto onAxis = [&](int row, int column) { return column == (left ? row : 0); };
        const Lattice half(segments, [&](int row, int column) {
            const double u = row == 0 ? 0.0 : double(column) / row - (left ? 1.0 : 0.0);
            return onAxis(row, column) ? frame.axis[std::size_t(row)]
                                       : addNode(network, shape, rows[std::size_t(row)], u);
        });
        for (const Lattice::Edge& edge : half.edges()) {
            const bool inner =
                edge.sort == (left ? Lattice::Edge::Sort::Right : Lattice::Edge::Sort::Left);
            if (edge.onSide && inner)
                continue;
            network.rod(edge.from, edge.to,
                        edge.onSide              ? materials.edges
                        : isTrailing(edge, half) ? materials.hem
                                                 : materials.seams);
        }
        for (const Lattice::Cell& cell : half.cells()) {
            const bool atEdge = cell.column == (left ? 0 : 2 * cell.row);
            network.panel(cell.a, cell.b, cell.c, atEdge ? materials.border : materials.sail);
        }
        for (int row = left ? 0 : 1; row <= segments; ++row)
            frame.leadingEdges.push_back(half.at(row, left ? 0 : row));
    }
    return frame;
}

std::vector<Id> addStiffeners(Network& network, const DeltaShape& shape, const SailFrame& frame,
                              Id material)
{
    std::vector<Id> held = frame.leadingEdges;
    held.insert(held.end(), frame.axis.begin() + 1, frame.axis.end()); // the nose is in both
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
