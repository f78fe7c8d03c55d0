// Drawing particles, links and panels, and the rigidity of what was drawn (shaping/drawing.h,
// author/rigidity.h).
//
// Stages: first what a Drawing adds, and that it doubles nothing and can be undone; then ropes,
// lines and rings; then floppy modes, counted on frames whose rigidity is known, with pins and the
// fewest braces that make them rigid; and at last the glider of the paper, and refusals.
#include "author/rigidity.h"
#include "builders/builder.h"
#include "materials/presets.h"
#include "registered_test.h"
#include "scene/weigh.h"
#include "shaping/drawing.h"
#include "shaping/operation.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <set>

namespace ripstop::test_drawing {

namespace {

// Particles in a part, to be linked.
struct Sheet
{
    Scene scene;
    Id part{};
    Id material{};
    std::vector<Id> nodes;

    explicit Sheet(const std::vector<Vec3>& places)
    {
        Drawing drawing(scene);
        part = drawing.part("sheet");
        material = drawing.material({.name = "cord"});
        for (const Vec3& place : places)
            nodes.push_back(drawing.particle(part, place, 0.1));
        (void)apply(scene, drawing.finish(Message("Draw")));
    }

    void link(const std::vector<std::array<int, 2>>& pairs)
    {
        Drawing drawing(scene);
        for (const auto& [a, b] : pairs)
            drawing.link(nodes[std::size_t(a)], nodes[std::size_t(b)], {material});
        (void)apply(scene, drawing.finish(Message("Link")));
    }
    void pin(int node)
    {
        (void)apply(scene, {Message("Pin"),
                            {SetValues{findProperty(Kind::Particle, "pinned"),
                                       {nodes[std::size_t(node)]},
                                       {true}}}});
    }
    Rigidity rigidity() const { return *rigidityOf(scene, nodes); }
    const Part& rows() const { return *findItem<Part>(scene, part); }
};

using Places = QList<QList<double>>;
using Pairs = QList<QPair<int, int>>;

const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<std::array<int, 2>> sides{{0, 1}, {1, 2}, {2, 3}, {3, 0}};

Id partNamed(const Scene& scene)
{
    Id found = noId;
    forEachPart(scene, [&](Id id, const Part&) { found = id; });
    return found;
}

// The particles that fabric covers.
std::vector<Id> sailOf(const Scene& scene)
{
    std::set<Id> corners;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Panel& panel : part.panels)
            corners.insert({panel.a, panel.b, panel.c});
    });
    return {corners.begin(), corners.end()};
}

} // namespace

class TestDrawing : public QObject
{
    Q_OBJECT

private slots:
    void drawsAndTakesBack()
    {
        Sheet sheet(square);
        const Scene before = sheet.scene;
        Drawing drawing(sheet.scene);
        const Id top = drawing.particle(sheet.part, {0.5, 0.5, 2}, 0.3);
        const Id rod = drawing.link(sheet.nodes[0], top, {sheet.material});
        const Id panel = drawing.panel(sheet.nodes[0], sheet.nodes[1], top, sheet.material);
        QCOMPARE(drawing.made(), (std::vector<Id>{top, rod, panel}));
        const Edit undo = apply(sheet.scene, drawing.finish(Message("Draw")));
        QCOMPARE(sheet.rows().particles.size(), 5U);
        QCOMPARE(sheet.rows().links.at(0).restLength, std::sqrt(0.25 + 0.25 + 4.0));
        QCOMPARE(sheet.rows().panels.size(), 1U);
        (void)apply(sheet.scene, undo);
        QCOMPARE(sheet.scene.items, before.items);
    }

    void doublesNothing()
    {
        Sheet sheet({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}});
        const LinkStroke stroke{sheet.material};
        Drawing drawing(sheet.scene);
        QVERIFY(drawing.link(sheet.nodes[0], sheet.nodes[1], stroke) != noId);
        QCOMPARE(drawing.link(sheet.nodes[1], sheet.nodes[0], stroke), noId);
        QCOMPARE(drawing.link(sheet.nodes[0], sheet.nodes[0], stroke), noId);
        QCOMPARE(drawing.link(sheet.nodes[1], sheet.nodes[2], stroke), noId); // no length
        QVERIFY(drawing.panel(sheet.nodes[0], sheet.nodes[1], sheet.nodes[3], sheet.material)
                != noId);
        QCOMPARE(drawing.panel(sheet.nodes[3], sheet.nodes[0], sheet.nodes[1], sheet.material),
                 noId);
        QCOMPARE(drawing.panel(sheet.nodes[3], sheet.nodes[0], sheet.nodes[3], sheet.material),
                 noId);
        (void)apply(sheet.scene, drawing.finish(Message("Draw")));
        Drawing more(sheet.scene);
        QCOMPARE(more.link(sheet.nodes[0], sheet.nodes[1], stroke), noId);
        QVERIFY(more.finish(Message("Draw")).changes.empty());
    }

    // A bridle: the corners of a sail to the particle that is none, and nothing between them.
    void tiesAllToOne()
    {
        std::vector<Vec3> places = square;
        places.push_back({0.5, 0.5, -2.0});
        Sheet sheet(places);
        Drawing drawing(sheet.scene);
        drawing.panel(sheet.nodes[0], sheet.nodes[1], sheet.nodes[2], sheet.material);
        drawing.panel(sheet.nodes[0], sheet.nodes[2], sheet.nodes[3], sheet.material);
        (void)apply(sheet.scene, drawing.finish(Message("Draw")));
        const Operation* operation = findOperation("link");
        QVERIFY(operation);
        const Parameters values{{"way", 3}, {"kind", 1}, {"material", 1}};
        const auto tied = operation->apply(sheet.scene, sheet.nodes, values);
        QVERIFY2(bool(tied), tied ? "" : tied.message().english().c_str());
        (void)apply(sheet.scene, tied->edit);
        QCOMPARE(sheet.rows().links.size(), 4U);
        for (const Link& link : sheet.rows().links) {
            QVERIFY(link.from == sheet.nodes[4] || link.to == sheet.nodes[4]);
            QCOMPARE(link.resists, Resists::Tension);
        }
        // a sail alone has no such particle
        QVERIFY(!operation->apply(sheet.scene, {sheet.nodes[0], sheet.nodes[1], sheet.nodes[2]},
                                  values));
    }

    // A drawn line has given nothing to anybody, and says so: what it turns out to be of is
    // weighed.
    void whatIsDrawnIsWeighedLater()
    {
        Sheet sheet({{0, 0, 0}, {3, 4, 0}});
        const auto tied = findOperation("link")->apply(sheet.scene, sheet.nodes,
                                                       {{"way", 0}, {"kind", 1}, {"material", 1}});
        QVERIFY(bool(tied));
        (void)apply(sheet.scene, tied->edit);
        const Id cord = sheet.rows().links.at(0).material;
        QVERIFY(cord != sheet.material);
        const Preset& preset = **findPreset("liros_ltc80");
        const auto given = presetEdit(sheet.scene, preset, {cord});
        QVERIFY(bool(given) && given->notWeighed.empty());
        (void)apply(sheet.scene, given->edit);
        const double density = std::get<double>(
            findNumber(preset, propertyOf<&Material::linearDensity>())->value); // kg/m
        QVERIFY(density > 0.0);
        for (const Particle& particle : sheet.rows().particles)
            QVERIFY(std::abs(particle.mass - (0.1 + 2.5 * density)) < 1e-12);
    }

    // What is drawn of a material of known density weighs what that says: 5 m of 2 g/m, half at
    // either end; a rope of it 2 % more with its slack, whatever else it is told; and a triangle
    // of 6 m^2 of 50 g/m^2, a third at each corner. Half the density takes half of that off again.
    void whatIsKnownIsWeighedAtOnce()
    {
        const auto masses = [](const Sheet& sheet) {
            std::vector<double> all;
            for (const Particle& particle : sheet.rows().particles)
                all.push_back(particle.mass);
            return all;
        };
        const auto know = [](Sheet& sheet, double linear, double areal) {
            const SetValues lines{
                &propertyOf<&Material::linearDensity>(), {sheet.material}, {linear}};
            const SetValues cloth{
                &propertyOf<&Material::arealDensity>(), {sheet.material}, {areal}};
            (void)apply(sheet.scene, *weighed(sheet.scene, {Message("Know"), {lines, cloth}}));
        };
        const auto are = [](const std::vector<double>& got, const std::vector<double>& expected) {
            return std::ranges::equal(got, expected,
                                      [](double a, double b) { return std::abs(a - b) < 1e-12; });
        };
        Sheet line({{0, 0, 0}, {3, 4, 0}});
        know(line, 0.002, 0.05);
        line.link({{0, 1}});
        QVERIFY(are(masses(line), {0.105, 0.105}));
        know(line, 0.001, 0.05);
        QVERIFY(are(masses(line), {0.1025, 0.1025}));

        Sheet rope({{0, 0, 0}, {3, 4, 0}});
        know(rope, 0.002, 0.05);
        Drawing drawing(rope.scene);
        drawing.rope(rope.nodes[0], rope.nodes[1], 2, 0.5, 0.02, {rope.material});
        (void)apply(rope.scene, drawing.finish(Message("Rope")));
        const double half = 0.002 * 5.1 / 4.0;
        QVERIFY(are(masses(rope), {0.1 + half, 0.1 + half, 2.0 * half}));

        Sheet sail({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}});
        know(sail, 0.002, 0.05);
        Drawing cloth(sail.scene);
        cloth.panel(sail.nodes[0], sail.nodes[1], sail.nodes[2], sail.material);
        (void)apply(sail.scene, cloth.finish(Message("Panel")));
        QVERIFY(are(masses(sail), {0.2, 0.2, 0.2}));
    }

    // Along the rim of a sail of panels, which has no links that would tell the order.
    void goesAlongSidesOfPanels()
    {
        Sheet sheet(square);
        Drawing drawing(sheet.scene);
        drawing.panel(sheet.nodes[0], sheet.nodes[1], sheet.nodes[2], sheet.material);
        drawing.panel(sheet.nodes[0], sheet.nodes[2], sheet.nodes[3], sheet.material);
        (void)apply(sheet.scene, drawing.finish(Message("Draw")));
        const std::vector<Id> hem{sheet.nodes[1], sheet.nodes[2], sheet.nodes[3]};
        QCOMPARE(inLine(sheet.scene, hem), hem);
    }

    void ropeHasItsLengthAndMass()
    {
        Sheet sheet({{0, 0, 0}, {3, 4, 0}});
        Drawing drawing(sheet.scene);
        const std::vector<Id> nodes =
            drawing.rope(sheet.nodes[0], sheet.nodes[1], 10, 0.5, 0.02, {sheet.material});
        QCOMPARE(nodes.size(), 11U);
        (void)apply(sheet.scene, drawing.finish(Message("Rope")));
        double length = 0.0;
        for (const Link& link : sheet.rows().links)
            length += link.restLength;
        QVERIFY(std::abs(length - 5.0 * 1.02) < 1e-12);
        double mass = 0.0;
        for (const Particle& particle : sheet.rows().particles)
            mass += particle.mass;
        QVERIFY(std::abs(mass - (0.5 + 2 * 0.1)) < 1e-12);
    }

    void findsLinesAndRings()
    {
        Sheet sheet({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {3, 0.1, 0}});
        const auto& n = sheet.nodes;
        QCOMPARE(inLine(sheet.scene, n), (std::vector<Id>{n[0], n[2], n[1], n[3]}));
        sheet.link({{0, 1}, {1, 2}, {2, 3}}); // a line through them, however it lies
        QCOMPARE(inLine(sheet.scene, n), (std::vector<Id>{n[0], n[1], n[2], n[3]}));

        Sheet hole({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}});
        const std::vector<Id> ring = inRing(hole.scene, hole.nodes);
        const auto at = std::ranges::find(ring, hole.nodes[0]) - ring.begin();
        QCOMPARE(ring[std::size_t(at + 2) % 4], hole.nodes[1]); // opposite
        hole.link({{0, 1}, {1, 2}, {2, 3}, {3, 0}});
        const std::vector<Id> along = inRing(hole.scene, hole.nodes);
        QCOMPARE(along[0], hole.nodes[0]);
        QCOMPARE(along[2], hole.nodes[2]);
    }

    // Maxwell 1864: modes - redundant = 3 n - b - 6.
    void countsFloppyModes_data()
    {
        QTest::addColumn<Places>("places");
        QTest::addColumn<Pairs>("pairs");
        QTest::addColumn<int>("rigid");
        QTest::addColumn<int>("modes");
        QTest::addColumn<int>("redundant");
        const Places tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        const Pairs all{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
        const Places flat{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        const Pairs around{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
        QTest::newRow("a point") << Places{{1, 2, 3}} << Pairs{} << 3 << 0 << 0;
        QTest::newRow("a rod") << Places{{0, 0, 0}, {0, 2, 0}} << Pairs{{0, 1}} << 5 << 0 << 0;
        QTest::newRow("a triangle") << Places{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}
                                    << Pairs{{0, 1}, {1, 2}, {2, 0}} << 6 << 0 << 0;
        QTest::newRow("a tetrahedron") << tetrahedron << all << 6 << 0 << 0;
        QTest::newRow("a tetrahedron, one rod twice")
            << tetrahedron << (all + Pairs{{1, 0}}) << 6 << 0 << 1;
        QTest::newRow("a tetrahedron without a rod") << tetrahedron << all.mid(1) << 6 << 1 << 0;
        // shears in its plane, and folds along either diagonal or twists: 12 - 4 - 6
        QTest::newRow("a square") << flat << around << 6 << 2 << 0;
        // braced both ways: one redundant in its plane, still folds out of it
        QTest::newRow("a crossed square")
            << flat << (around + Pairs{{0, 2}, {1, 3}}) << 6 << 1 << 1;
        // a chain hung straight: each inner joint goes two ways
        QTest::newRow("a straight chain")
            << Places{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}} << Pairs{{0, 1}, {1, 2}} << 5 << 2 << 0;
    }
    void countsFloppyModes()
    {
        QFETCH(Places, places);
        QFETCH(Pairs, pairs);
        QFETCH(int, rigid);
        QFETCH(int, modes);
        QFETCH(int, redundant);
        std::vector<Vec3> at;
        for (const QList<double>& place : places)
            at.emplace_back(place[0], place[1], place[2]);
        Sheet sheet(at);
        for (const auto& [a, b] : pairs) { // also twice
            AddRows rows{sheet.part, {}, {}, {}};
            Link link;
            link.id = sheet.scene.nextId;
            link.from = sheet.nodes[std::size_t(a)];
            link.to = sheet.nodes[std::size_t(b)];
            link.material = sheet.material;
            rows.links.push_back(link);
            (void)apply(sheet.scene, {Message("Link"), {rows}});
        }
        const Rigidity rigidity = sheet.rigidity();
        QCOMPARE(rigidity.rigidMotions, rigid);
        QCOMPARE(int(rigidity.modes.size()), modes);
        QCOMPARE(rigidity.redundant, redundant);
        QCOMPARE(modes - redundant, int(3 * at.size()) - int(pairs.size()) - rigid);
    }

    void modesStretchNoLink()
    {
        Sheet sheet(square);
        sheet.link(sides);
        const Rigidity rigidity = sheet.rigidity();
        for (const auto& mode : rigidity.modes) {
            double largest = 0.0;
            for (const Vec3& velocity : mode)
                largest = std::max(largest, velocity.norm());
            QVERIFY(std::abs(largest - 1.0) < 1e-12);
            for (const auto& [a, b] : rigidity.links) {
                const Vec3 along = square[std::size_t(b)] - square[std::size_t(a)];
                QVERIFY(std::abs(along.dot(mode[std::size_t(b)] - mode[std::size_t(a)])) < 1e-9);
            }
        }
    }

    void pinsHold()
    {
        Sheet sheet(square);
        sheet.link(sides);
        sheet.pin(0);
        sheet.pin(1);
        // free: 2 particles, 6 unknowns; links 1-2, 2-3, 3-0 take 3; turning about the pins is one
        // motion of the whole
        const Rigidity rigidity = sheet.rigidity();
        QCOMPARE(rigidity.rigidMotions, 1);
        QCOMPARE(int(rigidity.modes.size()), 2);
        QCOMPARE(rigidity.redundant, 1); // the rod between the pins
    }

    // A brace stops one mode each; of a flat square only the shear can be stopped by a rod in it.
    void proposesTheFewestBraces()
    {
        Sheet flat(square);
        flat.link(sides);
        QCOMPARE(bracesFor(flat.rigidity()).size(), 1U);

        Sheet cube({{0, 0, 0},
                    {1, 0, 0},
                    {1, 1, 0},
                    {0, 1, 0},
                    {0, 0, 1},
                    {1, 0, 1},
                    {1, 1, 1},
                    {0, 1, 1}});
        cube.link({{0, 1},
                   {1, 2},
                   {2, 3},
                   {3, 0},
                   {4, 5},
                   {5, 6},
                   {6, 7},
                   {7, 4},
                   {0, 4},
                   {1, 5},
                   {2, 6},
                   {3, 7}});
        const Rigidity rigidity = cube.rigidity();
        QCOMPARE(int(rigidity.modes.size()), 6); // 24 - 12 - 6
        const std::vector<Brace> braces = bracesFor(rigidity);
        QCOMPARE(braces.size(), 6U);
        std::vector<std::array<int, 2>> rods;
        for (const Brace& brace : braces)
            rods.push_back({brace.from, brace.to});
        cube.link(rods);
        QCOMPARE(int(cube.rigidity().modes.size()), 0);
        QCOMPARE(cube.rigidity().redundant, 0);
        QVERIFY(bracesFor(cube.rigidity()).empty());
    }

    // Two hubs before and behind a flat braced frame, tied to every node, hold it.
    void hubsHoldWhatIsFlat()
    {
        Sheet sheet({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}, {0.5, 0.5, -1}});
        sheet.link(sides);
        sheet.link({{4, 0}, {4, 1}, {4, 2}, {4, 3}, {5, 0}, {5, 1}, {5, 2}, {5, 3}});
        QCOMPARE(int(sheet.rigidity().modes.size()), 0); // 18 - 12 - 6
    }

    // The paper's glider: 49 particles and 198 rods, rank 141 of 141 and so 57 redundant rods; it
    // is stiff as soon as the sail is bent. Its lattice alone, 45 particles and 108 rods, has 21
    // modes.
    void knowsThePapersGlider()
    {
        const Scene scene = *build(*findBuilder("hang_glider"), {});
        const Rigidity whole = *rigidityOf(scene, {partNamed(scene)});
        QCOMPARE(int(whole.particles.size()), 49);
        QCOMPARE(int(whole.links.size()), 198);
        QCOMPARE(int(whole.modes.size()), 0);
        QCOMPARE(whole.redundant, 57);

        Rigidity lattice = *rigidityOf(scene, sailOf(scene));
        QCOMPARE(int(lattice.particles.size()), 45);
        QCOMPARE(int(lattice.links.size()), 108);
        QCOMPARE(int(lattice.modes.size()), 21);
        QCOMPARE(bracesFor(lattice).size(), 21U);
    }

    void refusesWhatItCannotDo()
    {
        const Sheet sheet(square);
        QVERIFY(!rigidityOf(sheet.scene, {}));
        const Sheet large(std::vector<Vec3>(mostForRigidity + 1, Vec3::Zero()));
        const auto refused = rigidityOf(large.scene, large.nodes);
        QVERIFY(!refused);
        QVERIFY(refused.message().english().find("300") != std::string::npos);
    }
};

const RegisteredTest registered("test_drawing", runPlain<TestDrawing>);

} // namespace ripstop::test_drawing
#include "test_drawing.moc"
