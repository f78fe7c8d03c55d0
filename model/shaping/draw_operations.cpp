// The rows of the drawing operations: their parameters first, then one function for each, then the
// table. Each function takes the particles that the selection means, draws onto a Drawing
// (drawing.h), and fails with a sentence that says what to select when nothing comes of it. Lines,
// spars and rings find their order from the links that are there, or from the places.
#include "shaping/draw_operations.h"

#include "shapes/polygon_split.h"
#include "shaping/drawing.h"
#include "shaping/movable.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

namespace ripstop {
namespace {

constexpr std::size_t mostEachWithEach = 100; // particles; 4950 links

constexpr std::array<std::string_view, 4> ways{"in_a_line", "in_a_ring", "each_with_each",
                                               "all_to_one"};
constexpr std::array<std::string_view, 3> kinds{"rod", "line_(pulls_only)", "spring"};
constexpr std::array<std::string_view, 2> materials{"that_of_the_neighbours", "a_new_one"};
constexpr std::array<std::string_view, 3> threads{"none", "rods", "springs"};
constexpr std::array<std::string_view, 3> hubPlaces{"both_sides", "one_side", "the_other_side"};

// clang-format off
constexpr std::array linkParameters{
    Parameter{"way",      "", 0, 0, 3, true, "Through all in a line, on to the first again, every one with every other, or all to the one that is no corner of a panel: bridle lines to a tow point.", {}, ways},
    Parameter{"kind",     "", 0, 0, 2, true, "Rods keep their length, lines only do not grow longer, springs pull with a force.", {}, kinds},
    Parameter{"material", "", 0, 0, 1, true, "That of links at these particles, where there are any, or a new one.", {}, materials},
};
constexpr std::array ropeParameters{
    Parameter{"count",    "",     10, 1, 1000, true, "Links from end to end."},
    Parameter{"slack",    "%",    0, -50, 100, false, "How much longer the rope is than the way between its ends; less than 0 is under tension."},
    Parameter{"density",  "kg/m", 0.005, 1e-6, 50, false, "Mass per length; 0.005 is a line of 2.5 mm. A material that is there and says its own keeps that."},
    Parameter{"kind",     "", 1, 0, 2, true, "Lines only do not grow longer, rods also not shorter, springs pull with a force.", {}, kinds},
    Parameter{"material", "", 0, 0, 1, true, "That of links at the ends, where there are any, or a new one.", {}, materials},
};
constexpr std::array sparParameters{
    Parameter{"rigidity", "N m^2", 4, 0, 1e6, false, "Flexural rigidity EI, bending moment per curvature; a kite spar has 1 to 10."},
    Parameter{"density",  "kg/m",  0.02, 1e-6, 50, false, "Mass per length; a carbon tube of 6 mm has 0.02."},
};
constexpr std::array fillParameters{
    Parameter{"threads",  "", 1, 0, 2, true, "Links along the sides of the new panels where there are none yet: fabric has its strength from them.", {}, threads},
    Parameter{"material", "", 0, 0, 1, true, "That of panels at these particles, where there are any, or a new one.", {}, materials},
};
constexpr std::array rigidityParameters{
    Parameter{"side",     "",   0, 0, 2, true, "Of the plane that fits the particles best.", {}, hubPlaces},
    Parameter{"distance", "m",  0.3, 1e-4, 1e4, false, "From the middle of the particles."},
    Parameter{"mass",     "kg", 0.01, 1e-6, 1e3, false, "Of each new particle."},
};
// clang-format on

LinkStroke strokeOf(int kind)
{
    switch (kind) {
    case 1:
        return {{}, LinkKind::Rod, Resists::Tension};
    case 2:
        return {{}, LinkKind::Spring, Resists::Both};
    default:
        return {{}, LinkKind::Rod, Resists::Both};
    }
}

Material named(const char* name)
{
    Material plain;
    plain.name = name;
    return plain;
}

// The material of the neighbours where that is wanted and there is one; otherwise a new one.
Id materialOr(Id neighbours, const Parameters& values, Drawing& drawing, Material otherwise)
{
    const bool isNew = whole(values, "material") == 1;
    return isNew || neighbours == noId ? drawing.material(std::move(otherwise)) : neighbours;
}

Result<Shaped> finished(Drawing& drawing, const Message& label, const Message& nothing)
{
    if (drawing.made().empty())
        return Failure{nothing};
    std::vector<Id> made = drawing.made();
    return Shaped{drawing.finish(label), std::move(made)};
}

// The only one of them that is no corner of a panel; nothing where there are several or none.
std::optional<Id> hubOf(const Scene& scene, const std::vector<Id>& particles)
{
    std::set<Id> apart(particles.begin(), particles.end());
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Panel& panel : part.panels)
            for (const Id corner : {panel.a, panel.b, panel.c})
                apart.erase(corner);
    });
    return apart.size() == 1 ? std::optional(*apart.begin()) : std::nullopt;
}

Result<Shaped> link(const Scene& scene, const std::vector<Id>& ids, const Parameters& values)
{
    const std::vector<Id> particles = particlesOf(scene, ids);
    const int way = whole(values, "way");
    if (particles.size() < 2)
        return Failure("Select two or more particles first.");
    if (way == 2 && particles.size() > mostEachWithEach)
        return Failure(
            "Each with each of more than %1 particles are too many links. Select fewer, or "
            "choose another way.",
            mostEachWithEach);
    Drawing drawing(scene);
    LinkStroke stroke = strokeOf(whole(values, "kind"));
    stroke.material =
        materialOr(linkMaterialAt(scene, particles), values, drawing, plainCord("cord"));
    if (way == 2)
        for (std::size_t a = 0; a < particles.size(); ++a)
            for (std::size_t b = a + 1; b < particles.size(); ++b)
                drawing.link(particles[a], particles[b], stroke);
    else if (way == 3) {
        const std::optional<Id> hub = hubOf(scene, particles);
        if (!hub)
            return Failure("All to one needs exactly one particle that is no corner of a panel, as "
                           "a tow point is: select it together with those that it holds.");
        for (const Id particle : particles)
            if (particle != *hub)
                drawing.link(particle, *hub, stroke);
    } else {
        const std::vector<Id> path = way == 1 ? inRing(scene, particles) : inLine(scene, particles);
        for (std::size_t i = 1; i < path.size(); ++i)
            drawing.link(path[i - 1], path[i], stroke);
        if (way == 1)
            drawing.link(path.back(), path.front(), stroke);
    }
    return finished(drawing, Message("Link"),
                    Message("These particles are linked already, or lie in one place. "
                            "Nothing is added."));
}

Result<Shaped> rope(const Scene& scene, const std::vector<Id>& ids, const Parameters& values)
{
    const std::vector<Id> particles = particlesOf(scene, ids);
    if (particles.size() != 2)
        return Failure{"A rope runs between two particles: select these two."};
    Drawing drawing(scene);
    LinkStroke stroke = strokeOf(whole(values, "kind"));
    const double density = values.at("density");
    Material material = named("rope");
    material.linearDensity = density;
    stroke.material = materialOr(linkMaterialAt(scene, particles), values, drawing, material);
    const double slack = 0.01 * values.at("slack");
    const double length =
        (1.0 + slack) * (drawing.position(particles[1]) - drawing.position(particles[0])).norm();
    drawing.rope(particles[0], particles[1], whole(values, "count"), density * length, slack,
                 stroke);
    return finished(drawing, Message("Rope"),
                    Message("These particles are linked already, or lie in one place. "
                            "Take more links."));
}

// Links that are there become those of the spar; others are added.
Result<Shaped> spar(const Scene& scene, const std::vector<Id>& ids, const Parameters& values)
{
    const std::vector<Id> path = inLine(scene, particlesOf(scene, ids));
    if (path.size() < 2)
        return Failure("Select the particles along the spar first.");
    Drawing drawing(scene);
    Material material = named("spar");
    material.color = "#20262e";
    material.linearDensity = values.at("density");
    material.flexuralRigidity = values.at("rigidity");
    const Id of = drawing.material(material);
    std::map<std::array<Id, 2>, Id> there;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Link& row : part.links)
            there[{std::min(row.from, row.to), std::max(row.from, row.to)}] = row.id;
    });
    std::vector<Id> taken;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Id from = path[i - 1];
        const Id to = path[i];
        const double mass =
            values.at("density") * (drawing.position(to) - drawing.position(from)).norm();
        drawing.addMass(from, 0.5 * mass);
        drawing.addMass(to, 0.5 * mass);
        if (const auto link = there.find({std::min(from, to), std::max(from, to)});
            link != there.end())
            taken.push_back(link->second);
        else
            drawing.link(from, to, {of});
    }
    std::vector<Id> links = drawing.made();
    links.insert(links.end(), taken.begin(), taken.end());
    std::ranges::sort(links);
    Edit edit = drawing.finish(Message("Spar"));
    std::ranges::sort(taken);
    if (!taken.empty()) {
        edit.changes.emplace_back(SetValues{&propertyOf<&Link::material>(), taken, {of}});
        edit.changes.emplace_back(
            SetValues{&propertyOf<&Link::kind>(), taken, {std::string("rod")}});
        edit.changes.emplace_back(
            SetValues{&propertyOf<&Link::resists>(), taken, {std::string("both")}});
    }
    return Shaped{std::move(edit), std::move(links)};
}

Result<Shaped> fill(const Scene& scene, const std::vector<Id>& ids, const Parameters& values)
{
    const std::vector<Id> particles = particlesOf(scene, ids);
    if (particles.size() < 3)
        return Failure("Select three or more particles around the hole first.");
    const std::vector<Id> ring = inRing(scene, particles);
    Drawing drawing(scene);
    const Id fabric =
        materialOr(panelMaterialAt(scene, particles), values, drawing, plainCloth("cloth"));
    std::vector<Vec3> points;
    std::vector<int> corners;
    for (const Id id : ring) {
        corners.push_back(int(points.size()));
        points.push_back(drawing.position(id));
    }
    std::vector<std::array<int, 3>> triangles;
    splitPolygon(corners, points, triangles);
    const int thread = whole(values, "threads");
    const LinkStroke stroke{fabric, thread == 2 ? LinkKind::Spring : LinkKind::Rod, Resists::Both};
    for (const auto& [a, b, c] : triangles) {
        const std::array corner{ring[std::size_t(a)], ring[std::size_t(b)], ring[std::size_t(c)]};
        if (drawing.panel(corner[0], corner[1], corner[2], fabric) != noId && thread != 0)
            for (std::size_t side = 0; side < 3; ++side)
                drawing.link(corner[side], corner[(side + 1) % 3], stroke);
    }
    return finished(drawing, Message("Fill"),
                    Message("There are panels on all of these particles already."));
}

Result<Shaped> rigidity(const Scene& scene, const std::vector<Id>& ids, const Parameters& values)
{
    const std::vector<Id> particles = particlesOf(scene, ids);
    if (particles.size() < 2)
        return Failure("Select the particles that are to become stiff first.");
    const Movable movable = movableOf(scene, ids, Ties::Left);
    const Vec3 normal = ownAxes(movable).col(2);
    const Vec3 middle = pivotOf(scene, movable, Pivot::Median);
    Drawing drawing(scene);
    Material material = named("rigidity rods");
    material.color = "#8d99ae";
    const LinkStroke stroke{drawing.material(material), LinkKind::Rod, Resists::Both};
    const Id part = drawing.partOf(particles.front());
    const int side = whole(values, "side");
    std::vector<Id> hubs;
    for (const double way : {1.0, -1.0})
        if (side == 0 || (side == 1) == (way > 0.0))
            hubs.push_back(drawing.particle(part, middle + way * values.at("distance") * normal,
                                            values.at("mass")));
    for (const Id hub : hubs)
        for (const Id particle : particles)
            drawing.link(hub, particle, stroke);
    return Shaped{drawing.finish(Message("Rigidity particles")), hubs};
}

} // namespace

std::span<const Operation> drawOperations()
{
    // clang-format off
    static const std::array table{
        Operation{"link",  "Link", "Ties the selected particles to each other. The new links are at rest as they are; particles that are linked already stay so.", linkParameters, link},
        Operation{"rope",  "Rope", "A rope or line between the two selected particles, with new particles along it.", ropeParameters, rope},
        Operation{"spar",  "Spar", "Makes a stiff spar along the selected particles: rods that resist bending, with their mass. Links that are on its way become its own.", sparParameters, spar},
        Operation{"fill",  "Fill with panels", "Closes the hole that the selected particles surround with panels.", fillParameters, fill},
        Operation{"rigidity", "Rigidity particles", "Particles on both sides of the selected ones, with a rod to each, so that they keep their shape together (Beaudry, Egli, Patenaude 2005). Tools, Rigidity shows what still gives way.", rigidityParameters, rigidity},
    };
    // clang-format on
    return table;
}

} // namespace ripstop
