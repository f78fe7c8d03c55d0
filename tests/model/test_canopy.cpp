// Fabric that holds air: its pieces, its mouth, and what a bad set-up is told. How it flies stands
// in test_canopy_flight.cpp, what it is when full in verify/canopy.cpp.
//
// Stages: how faces, pieces and mouths are found and what a bad set-up is told; then scenes without
// air, and holes that leak.
#include "model/systems.h"
#include "registered_test.h"

#include "builders/builder.h"
#include "check/check.h"
#include "compile/compile.h"
#include "derived/canopy_shape.h"
#include "io/scene_file.h"
#include "measure/diagnostics.h"
#include "simulation/simulation.h"

#include <Eigen/Geometry>
#include <QtTest>

#include <algorithm>
#include <functional>
#include <set>

Q_DECLARE_METATYPE(std::function<void(ripstop::Part&)>)

namespace ripstop::test_canopy {

namespace {

constexpr Id partId{1};
constexpr Id materialId{2};

using Corners = std::vector<std::array<std::uint32_t, 3>>;
using Spoil = std::function<void(Part&)>;

// Particles 11 to 15, a pyramid with its top in 11; panels from 31 on.
Part pyramid(const Corners& panels)
{
    Part part{"sail"};
    part.canopyPressure = 1.6;
    part.particles = {{Id{11}, {0, 1, 0}},
                      {Id{12}, {1, 0, 1}},
                      {Id{13}, {1, 0, -1}},
                      {Id{14}, {-1, 0, -1}},
                      {Id{15}, {-1, 0, 1}}};
    std::uint32_t id = 31;
    for (const auto& [a, b, c] : panels)
        part.panels.push_back({Id{id++}, Id{a}, Id{b}, Id{c}, materialId});
    return part;
}

// Wound to and fro, as drawn by hand.
Part cup() { return pyramid({{11, 12, 13}, {11, 14, 13}, {11, 14, 15}, {11, 12, 15}}); }

Scene sceneOf(const Part& part)
{
    Scene scene;
    scene.items = {{partId, part}, {materialId, Material{"fabric"}}};
    scene.nextId = Id{100};
    return scene;
}

Vec3 at(const Part& part, Id id) { return findRow(part.particles, id)->position; }

} // namespace

class TestCanopy : public QObject
{
    Q_OBJECT

private slots:
    // However its panels are wound, normals point out of the air and the loops go with them.
    void facesOutwards_data()
    {
        QTest::addColumn<int>("turned"); // bits, one for each panel
        for (int turned = 0; turned < 16; ++turned)
            QTest::addRow("%d", turned) << turned;
    }
    void facesOutwards()
    {
        QFETCH(int, turned);
        Part part = cup();
        for (int i = 0; i < 4; ++i)
            if (turned & (1 << i))
                std::swap(part.panels[std::size_t(i)].b, part.panels[std::size_t(i)].c);
        const auto pieces = canopyPieces(part);
        QVERIFY(bool(pieces));
        QCOMPARE(pieces->size(), std::size_t(1));
        const CanopyPiece& piece = pieces->front();
        for (const CanopyPiece::Facet& facet : piece.facets) {
            const Vec3 a = at(part, facet.corner[0]);
            const Vec3 normal =
                (at(part, facet.corner[1]) - a).cross(at(part, facet.corner[2]) - a);
            QVERIFY(normal.y() > 0.0);
            QVERIFY(normal.dot(a + at(part, facet.corner[1]) + at(part, facet.corner[2])) > 0.0);
            QVERIFY(isNear(facet.area, std::sqrt(2.0), 1e-12)); // 1/2 x 2 x sqrt(2)
        }
        QCOMPARE(std::set<Id>(piece.mouth.begin(), piece.mouth.end()),
                 (std::set<Id>{Id{12}, Id{13}, Id{14}, Id{15}}));
        QCOMPARE(piece.mouth.size(), std::size_t(4));
        QVERIFY(piece.vents.empty());
    }

    // Two cups in one part are two canopies.
    void piecesAreApart()
    {
        Part part = cup();
        for (std::uint32_t i = 0; i < 5; ++i) {
            Particle row = part.particles[i];
            row.id = Id{50 + i};
            row.position.x() += 5.0;
            part.particles.push_back(row);
        }
        for (std::uint32_t i = 0; i < 4; ++i)
            part.panels.push_back({Id{60 + i}, Id{50}, Id{51 + i}, Id{51 + (i + 1) % 4}, noId});
        const auto pieces = canopyPieces(part);
        QVERIFY(bool(pieces));
        QCOMPARE(pieces->size(), std::size_t(2));
        QCOMPARE((*pieces)[1].facets.front().panel, 4);
        const auto system = compile(sceneOf(part));
        QVERIFY(bool(system));
        QCOMPARE((*system)->canopies.size(), std::size_t(2));
        QCOMPARE((*system)->start.canopies.size(), std::size_t(2));
    }

    // A ring of cloth has two edges: that with the lines is the mouth, small or large.
    void linesFindTheMouth_data()
    {
        QTest::addColumn<bool>("small");
        QTest::newRow("lines on the small edge") << true;
        QTest::newRow("lines on the large edge") << false;
    }
    void linesFindTheMouth()
    {
        QFETCH(bool, small);
        Part part{"ring"};
        constexpr std::uint32_t sides = 8;
        for (std::uint32_t i = 0; i < 2 * sides; ++i) {
            const double turn = 2.0 * M_PI * (i % sides) / sides;
            const double radius = i < sides ? 0.3 : 1.0;
            part.particles.push_back(
                {Id{10 + i},
                 {radius * std::cos(turn), i < sides ? 0.5 : 0.0, radius * std::sin(turn)}});
        }
        part.particles.push_back({Id{40}, {0, small ? 5.0 : -5.0, 0}});
        for (std::uint32_t i = 0; i < sides; ++i) {
            const Id a{10 + i}, b{10 + (i + 1) % sides};
            const Id c{10 + sides + i}, d{10 + sides + (i + 1) % sides};
            part.panels.push_back({Id{50 + 2 * i}, a, b, c, noId});
            part.panels.push_back({Id{51 + 2 * i}, b, d, c, noId});
            part.links.push_back({Id{100 + i}, Id{40}, small ? a : c, noId});
        }
        const auto pieces = canopyPieces(part);
        QVERIFY(bool(pieces));
        const CanopyPiece& piece = pieces->front();
        QCOMPARE(piece.vents.size(), std::size_t(1));
        const auto isSmall = [&](Id id) { return std::uint32_t(id) < 10 + sides; };
        QCOMPARE(piece.mouth.size(), std::size_t(sides));
        QVERIFY(std::all_of(piece.mouth.begin(), piece.mouth.end(),
                            [&](Id id) { return isSmall(id) == small; }));
        QVERIFY(std::none_of(piece.vents[0].begin(), piece.vents[0].end(),
                             [&](Id id) { return isSmall(id) == small; }));
    }

    void badSetUpsAreTold_data()
    {
        QTest::addColumn<Spoil>("spoil");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const char* says, Spoil spoil) {
            QTest::newRow(name) << spoil << QString(says);
        };
        row("no panels", "no panels to hold the air", [](Part& p) { p.panels.clear(); });
        row("no mouth", "leave a mouth open", [](Part& p) {
            p.panels.push_back({Id{41}, Id{12}, Id{13}, Id{14}, materialId});
            p.panels.push_back({Id{42}, Id{12}, Id{14}, Id{15}, materialId});
        });
        row("flat", "give it a hollow", [](Part& p) { p.particles[0].position.setZero(); });
        row("a fin", "more than two panels meet between particles 11 and 12", [](Part& p) {
            p.particles.push_back({Id{16}, {3, 3, 3}});
            p.panels.push_back({Id{41}, Id{11}, Id{12}, Id{16}, materialId});
        });
        row("a twisted ribbon", "one side only", [](Part& p) {
            // 12 13, 13 14, ... around, and back to 12 with the sides exchanged
            p = pyramid({{11, 12, 13}, {12, 13, 14}, {13, 14, 15}, {14, 15, 11}, {15, 11, 12}});
        });
    }
    void badSetUpsAreTold()
    {
        QFETCH(Spoil, spoil);
        QFETCH(QString, says);
        Part part = cup();
        spoil(part);
        const Scene scene = sceneOf(part);
        const std::vector<Finding> problems = problemsOf(scene);
        QVERIFY(hasErrors(problems));
        QCOMPARE(problems[0].culprit(), partId);
        const QString message = QString::fromStdString(problems[0].message.english());
        QVERIFY2(message.startsWith("Part sail ") && message.contains(says), qPrintable(message));
        QVERIFY(message.endsWith("or set its canopyPressure to 0."));
        QVERIFY(!compile(scene));
        part.canopyPressure = 0.0;
        QVERIFY(!hasErrors(problemsOf(sceneOf(part))));
    }

    void cornersOfOtherPartsAreTold()
    {
        Scene scene = sceneOf(cup());
        Part other{"other"};
        other.particles = {{Id{80}, {0, 5, 0}}};
        scene.items.push_back({Id{70}, other});
        std::get<Part>(scene.items[0].item).panels[0].a = Id{80};
        const std::vector<Finding> problems = problemsOf(scene);
        QVERIFY(hasErrors(problems));
        QVERIFY(problems[0].message.english().find("panel 31 has a corner that is not")
                != std::string::npos);
    }

    // No air, no wind, nothing that moves: no pressure, and no number that is none.
    void nothingToHold()
    {
        Scene scene = sceneOf(cup());
        scene.settings.gravity.setZero();
        for (const double density : {0.0, 1.225}) {
            scene.settings.airDensity = density;
            Simulation simulation(*compile(scene));
            QVERIFY(simulation.runUntil(0.1));
            const CanopyAir& air = simulation.state().canopies[0];
            QCOMPARE(air.pressure, 0.0);
            QVERIFY(air.push.isZero());
            QVERIFY(isNear(air.volume, 4.0 / 3.0, 1e-9));
            for (const Vec3& position : simulation.state().position)
                QVERIFY(position.allFinite());
        }
    }

    // A panel that is gone is a hole: what comes in by the mouth of 4 m^2 leaks, s = p / P:
    // 4 sqrt(1 - s) = 0.6 sqrt(2) sqrt(s P / q), P / q = 1.6 / (1 + c sqrt(1.6))^2, c = 0.6 / 4.
    void holesLeak()
    {
        Part part = cup();
        for (Particle& particle : part.particles)
            particle.pinned = true;
        Scene scene = sceneOf(part);
        scene.items.push_back({Id{90}, Wind{"wind", {0.0, 10.0, 0.0}}});
        auto system = std::make_shared<System>(**compile(scene));
        system->start.panelGone[2] = 1;
        Simulation simulation(system);
        QVERIFY(simulation.runUntil(20.0));
        const double most = 1.6 / std::pow(1.0 + 0.15 * std::sqrt(1.6), 2);
        const double leak = 0.6 * std::sqrt(2.0) / 4.0;
        const double expected = 61.25 * most / (1.0 + most * leak * leak);
        const double got = simulation.state().canopies[0].pressure;
        QVERIFY2(isNear(got, expected, 1e-3 * expected), told(got, expected));
    }
};

const RegisteredTest registered("test_canopy", runPlain<TestCanopy>);

} // namespace ripstop::test_canopy
#include "test_canopy.moc"
