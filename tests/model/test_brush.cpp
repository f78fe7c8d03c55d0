// The brush (shaping/brush.h): what it reaches and with which weight, strokes, mirror, grain, and
// undo.
#include "builders/builder.h"
#include "derived/flat_panel.h"
#include "model/systems.h"
#include "model/tensile_strip.h"
#include "registered_test.h"
#include "scene/particle_of.h"
#include "select/elements.h"
#include "shaping/brush.h"
#include "shaping/mirror_plane.h"

#include <QtTest>

#include <cmath>

namespace ripstop::test_brush {

namespace {

const Part& partOf(const Scene& scene)
{
    for (const Entry& entry : scene.items)
        if (const Part* part = std::get_if<Part>(&entry.item))
            return *part;
    std::abort();
}

// A strip whose middle line is x = 0.
Scene sheet()
{
    Scene scene = strip(fine, 0.0, 1.0).scene;
    for (Entry& entry : scene.items)
        if (Part* part = std::get_if<Part>(&entry.item))
            for (Particle& particle : part->particles)
                particle.position.x() -= 0.5 * width;
    return scene;
}

Vec3 middleOf(const Scene& scene, const Panel& panel)
{
    const auto at = [&](Id id) -> Vec3 { return particleOf(scene, id)->position; };
    return (at(panel.a) + at(panel.b) + at(panel.c)) / 3.0;
}

Scene painted(const Scene& scene, const Brush& brush, const std::vector<Vec3>& way)
{
    Scene after = scene;
    BrushStroke stroke(scene, brush);
    for (std::size_t i = 0; i < way.size(); ++i)
        (void)stroke.paint(way[i == 0 ? 0 : i - 1], way[i]);
    (void)apply(after, stroke.edit());
    return after;
}

const Vec3 spot(0.03, -0.21, 0.0);

} // namespace

class TestBrush : public QObject
{
    Q_OBJECT

private slots:
    // Exactly what has its middle within the radius, and all of it alike.
    void aHardBrushPaintsWhatItReaches()
    {
        const Scene scene = sheet();
        const Brush brush{.radius = 0.05, .falloff = Falloff::Hard};
        const Scene after = painted(scene, brush, {spot});
        int inside = 0;
        for (const Panel& panel : partOf(after).panels) {
            const bool isInside = (middleOf(scene, panel) - spot).norm() <= 0.05;
            inside += isInside;
            QCOMPARE(panel.strengthFactor, isInside ? 0.5 : 1.0);
            QCOMPARE(panel.stiffnessFactor, 1.0);
        }
        QVERIFY(inside > 3 && inside < int(partOf(after).panels.size()) / 2);
    }

    // (1 - d^2 / r^2)^2 of the way from 1 to 3, d being the distance to the way of the brush.
    void aSoftBrushFallsOff()
    {
        const Scene scene = sheet();
        Brush brush{.what = Painted::Stiffness, .radius = 0.06};
        brush.values[std::size_t(Painted::Stiffness)] = 3.0;
        const Vec3 end = spot - Vec3(0.0, 0.1, 0.0);
        const Scene after = painted(scene, brush, {spot, end});
        for (const Panel& panel : partOf(after).panels) {
            Vec3 away = middleOf(scene, panel) - spot;
            away.y() -= std::clamp(away.y(), -0.1, 0.0);
            const double share = std::max(1.0 - away.squaredNorm() / (0.06 * 0.06), 0.0);
            const double expected = 1.0 + 2.0 * share * share;
            QVERIFY2(isNear(panel.stiffnessFactor, expected, 1e-12),
                     told(panel.stiffnessFactor, expected));
        }
    }

    // Back and forth is once, and a slow hand is a fast one.
    void aStrokePaintsOnce()
    {
        const Scene scene = sheet();
        const Vec3 end = spot - Vec3(0.0, 0.1, 0.0);
        std::vector<Vec3> slow;
        for (int i = 0; i <= 10; ++i)
            slow.push_back(spot + 0.1 * i * (end - spot));
        const auto factorsIn = [](const Scene& after) {
            std::vector<double> factors;
            for (const Panel& panel : partOf(after).panels)
                factors.push_back(panel.strengthFactor);
            return factors;
        };
        const auto once = factorsIn(painted(scene, {}, {spot, end}));
        QVERIFY(factorsIn(painted(scene, {}, {spot, end, spot, end})) == once);
        const auto slowly = factorsIn(painted(scene, {}, slow));
        for (std::size_t i = 0; i < once.size(); ++i)
            QVERIFY2(isNear(slowly[i], once[i], 1e-12), told(slowly[i], once[i]));
    }

    void mirrorsAtTheMiddle()
    {
        const Scene scene = sheet();
        const Brush brush{.radius = 0.05, .falloff = Falloff::Hard, .mirrors = true};
        const Scene after = painted(scene, brush, {spot});
        const Vec3 other(-spot.x(), spot.y(), spot.z());
        for (const Panel& panel : partOf(after).panels) {
            const Vec3 middle = middleOf(scene, panel);
            const bool isInside = std::min((middle - spot).norm(), (middle - other).norm()) <= 0.05;
            QCOMPARE(panel.strengthFactor, isInside ? 0.5 : 1.0);
        }
    }

    // Halves of kites lie along z, wherever the kite stands; what is longer to one side than to the
    // other, as a delta from nose to tail, is no plane to mirror at.
    void mirrorsKitesLeftAndRight()
    {
        for (const char* kite : {"delta_kite", "diamond_kite", "hang_glider"}) {
            Scene scene = *build(*findBuilder(kite), {});
            for (Entry& entry : scene.items)
                if (Part* part = std::get_if<Part>(&entry.item))
                    for (Particle& particle : part->particles)
                        particle.position += Vec3(7.0, 3.0, 2.0);
            const MirrorPlane plane = mirrorPlaneOf(partOf(scene));
            QCOMPARE(plane.axis, 2);
            QVERIFY2(isNear(plane.at, 2.0, 1e-9), told(plane.at, 2.0));
            const Id part = partNearest(scene, partOf(scene).particles.front().position);
            QVERIFY(findItem<Part>(scene, part) == &partOf(scene));
        }
        QCOMPARE(partNearest(Scene(), Vec3::Zero()), noId);
    }

    // A warp that leans outwards on one side leans outwards on the other.
    void mirroredGrainLeansTheOtherWay()
    {
        const Scene scene = sheet();
        Brush brush{
            .what = Painted::Grain, .radius = 0.05, .falloff = Falloff::Hard, .mirrors = true};
        brush.values[std::size_t(Painted::Grain)] = 30.0;
        const Scene after = painted(scene, brush, {spot});
        int sides[2] = {};
        for (const Panel& panel : partOf(after).panels) {
            const auto at = [&](Id id) -> Vec3 { return particleOf(scene, id)->position; };
            const Vec3 middle = middleOf(scene, panel);
            const Vec3 a = at(panel.a), ab = at(panel.b) - a, ac = at(panel.c) - a;
            const bool isRight = middle.x() > 0.0;
            const Vec3 place(isRight ? spot.x() : -spot.x(), spot.y(), spot.z());
            if ((middle - place).norm() > 0.05 || isNear(middle.x(), 0.0, 1e-9))
                continue;
            ++sides[isRight];
            const auto shares = *warpShares(panel, a, a + ab, a + ac);
            const Vec3 warp = shares[0] * ab + shares[1] * ac;
            const double facing = ab.cross(ac).z() > 0.0 ? 1.0 : -1.0;
            const double lean = -facing * warp.x() / warp.y(); // of what faces z, anticlockwise
            const double expected = std::tan(M_PI / 6.0) * (isRight ? 1.0 : -1.0);
            QVERIFY2(isNear(lean, expected, 1e-12), told(lean, expected));
        }
        QVERIFY(sides[0] > 0 && sides[1] > 0);
    }

    // The warp of all panels lies 30 degrees from upright, whichever way their corners go round,
    // and from there it turns by the shorter way: half way to 150 degrees is 0 and not 90.
    void grainTurnsTheShorterWay()
    {
        const Scene scene = sheet();
        Brush brush{.what = Painted::Grain, .radius = 10.0, .falloff = Falloff::Hard};
        brush.values[std::size_t(Painted::Grain)] = 30.0;
        const Scene after = painted(scene, brush, {spot});
        for (const Panel& panel : partOf(after).panels) {
            const auto at = [&](Id id) -> Vec3 { return particleOf(scene, id)->position; };
            const Vec3 a = at(panel.a), ab = at(panel.b) - a, ac = at(panel.c) - a;
            const auto shares = *warpShares(panel, a, a + ab, a + ac);
            const Vec3 warp = shares[0] * ab + shares[1] * ac;
            const double along = std::abs(warp.y());
            QVERIFY2(isNear(along, std::cos(M_PI / 6.0), 1e-12), told(along, std::cos(M_PI / 6.0)));
        }
        brush.values[std::size_t(Painted::Grain)] = 150.0;
        brush.falloff = Falloff::Smooth;
        const Panel& panel = partOf(after).panels.front();
        const double half = std::sqrt(1.0 - std::sqrt(0.5)); // of the radius
        const Scene turned =
            painted(after, brush, {middleOf(scene, panel) + Vec3(half * brush.radius, 0.0, 0.0)});
        const double upright = uprightGrain(
            *particleOf(scene, panel.a), *particleOf(scene, panel.b), *particleOf(scene, panel.c));
        const double off = std::remainder(partOf(turned).panels.front().grain - upright, 180.0);
        QVERIFY2(isNear(off, 0.0, 1e-9), told(off, 0.0));
    }

    // Where threads carry the pull, links are painted: those among panels, and not the line that
    // hangs from a corner.
    void linksArePaintedWhereTheyCarry()
    {
        Scene scene = sheet();
        for (Entry& entry : scene.items)
            if (Part* part = std::get_if<Part>(&entry.item)) {
                part->carrier = FabricKind::Threads;
                const Particle free{.id = takeId(scene), .position = spot};
                part->particles.push_back(free);
                const Panel panel = part->panels.front();
                for (const Id end : {panel.b, free.id})
                    part->links.push_back({.id = takeId(scene), .from = panel.a, .to = end});
            }
        const Brush brush{.radius = 10.0, .falloff = Falloff::Hard};
        const Part after = partOf(painted(scene, brush, {spot}));
        QCOMPARE(after.links[0].strengthFactor, 0.5);
        QCOMPARE(after.links[1].strengthFactor, 1.0);
        for (const Panel& panel : after.panels)
            QCOMPARE(panel.strengthFactor, 1.0);
        const Brush ofGrain{.what = Painted::Grain};
        QVERIFY(BrushStroke(scene, ofGrain).hasNothing());
        QVERIFY(BrushStroke(Scene(), brush).hasNothing());
    }

    void undoRestoresAll()
    {
        const Scene scene = sheet();
        Scene after = scene;
        BrushStroke stroke(scene, {.radius = 0.1});
        QVERIFY(stroke.paint(spot, spot));
        QVERIFY(!stroke.paint(spot, spot)); // nothing more
        QVERIFY(stroke.count() > 0);
        const Edit undo = apply(after, stroke.edit());
        QVERIFY(!(after == scene));
        (void)apply(after, undo);
        QVERIFY(after == scene);
        const Edit nothing = BrushStroke(scene, {}).edit();
        QVERIFY(nothing.changes.empty());
    }

    void widensToRoundNumbers()
    {
        Brush brush{.radius = 0.07};
        brush.widen(1.25);
        QVERIFY2(isNear(brush.radius, 0.0875, 1e-12), told(brush.radius, 0.0875));
        brush.widen(1.25); // 0.109375
        QVERIFY2(isNear(brush.radius, 0.109, 1e-12), told(brush.radius, 0.109));
        brush.widen(1e9);
        QCOMPARE(brush.radius, Brush::widest);
        brush.widen(1e-12);
        QVERIFY2(isNear(brush.radius, Brush::narrowest, 1e-12), told(brush.radius, 1e-4));
    }

    // A twentieth of the diagonal of 0.447 m is 0.022 m.
    void theRadiusFitsTheScene()
    {
        QVERIFY2(isNear(fittingRadius(sheet()), 0.02, 1e-12), told(fittingRadius(sheet()), 0.02));
        QCOMPARE(fittingRadius(Scene()), Brush().radius);
        // the sail of a kite is 2.8 m from corner to corner, and its line 25 m long
        const double ofKite = fittingRadius(*build(*findBuilder("delta_kite"), {}));
        QVERIFY2(isNear(ofKite, 0.1, 1e-12), told(ofKite, 0.1));
    }
};

const RegisteredTest registered("test_brush", runPlain<TestBrush>);

} // namespace ripstop::test_brush
#include "test_brush.moc"
