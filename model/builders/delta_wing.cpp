// Where a point of the sail is; then the sail, as one lattice or as strips from the nose on either
// side of the keel, row by row; and the struts above and below that keep a frame stiff.
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

namespace {

// With the billow at which `strips` chords across a half are as long as the arch of the shape: of a
// parabola they are by the share 1 / strips^2 of its excess over the width shorter.
DeltaShape cutForStrips(DeltaShape shape, int strips)
{
    if (strips > 1)
        shape.billow /= std::sqrt(1.0 - 1.0 / (double(strips) * strips));
    return shape;
}

// Nodes of a half by row and strip, from the axis out; all of row 0 are the nose.
using HalfNodes = std::vector<std::vector<Id>>;

HalfNodes addHalfNodes(Network& network, const DeltaShape& shape, const SailCut& cut,
                       const std::vector<Id>& axis, double side)
{
    HalfNodes nodes{std::vector<Id>(std::size_t(cut.strips) + 1, axis.front())};
    for (std::size_t row = 1; row < cut.rows.size(); ++row) {
        nodes.push_back({axis[row]});
        for (int strip = 1; strip <= cut.strips; ++strip)
            nodes.back().push_back(
                addNode(network, shape, cut.rows[row], side * strip / cut.strips));
    }
    return nodes;
}

void sewHalf(Network& network, const HalfNodes& nodes, double side, const SailMaterials& materials)
{
    const std::size_t strips = nodes.front().size() - 1;
    const auto panel = [&](Id a, Id b, Id c, Id material) {
        network.panel(a, side < 0.0 ? c : b, side < 0.0 ? b : c, material);
    };
    for (std::size_t row = 1; row < nodes.size(); ++row) {
        const std::vector<Id>& fore = nodes[row - 1];
        const std::vector<Id>& aft = nodes[row];
        for (std::size_t strip = 1; strip <= strips; ++strip) {
            const bool atEdge = strip == strips;
            const Id cloth = atEdge ? materials.border : materials.sail;
            network.rod(fore[strip], aft[strip], atEdge ? materials.edges : materials.seams);
            network.rod(aft[strip - 1], aft[strip],
                        row == nodes.size() - 1 ? materials.hem : materials.seams);
            panel(fore[strip], aft[strip - 1], aft[strip], cloth);
            if (row == 1)
                continue;
            network.rod(fore[strip], aft[strip - 1], materials.seams);
            panel(fore[strip], fore[strip - 1], aft[strip - 1], cloth);
        }
    }
}

} // namespace

SailFrame addHalves(Network& network, const DeltaShape& shape, const SailCut& cut,
                    const SailMaterials& materials)
{
    const DeltaShape arched = cutForStrips(shape, cut.strips);
    SailFrame frame;
    for (const double row : cut.rows)
        frame.axis.push_back(addNode(network, arched, row, 0.0));
    frame.leadingEdges.push_back(frame.axis.front());
    for (const double side : {-1.0, 1.0}) {
        const HalfNodes nodes = addHalfNodes(network, arched, cut, frame.axis, side);
        sewHalf(network, nodes, side, materials);
        for (std::size_t row = 1; row < nodes.size(); ++row)
            frame.leadingEdges.push_back(nodes[row].back());
        const std::vector<Id>& last = nodes.back();
        frame.trailingEdge.insert(frame.trailingEdge.end(), last.begin() + 1, last.end() - 1);
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
