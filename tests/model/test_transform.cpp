// Moving, turning and scaling of what is selected (shaping/transform.h).
//
// Stages: which particles a selection means, pivots and axes; then motions of a sheet of cloth,
// against distances and areas before and after, with rest lengths kept or bound anew; then
// colliders, gestures and the time that a large cloth takes. after() checks for each edit that
// undo gives the scene back.
#include "registered_test.h"
#include "shaping/transform.h"

#include "builders/builder.h"
#include "derived/collider_shape.h"
#include "scene/property.h"
#include "thread_time.h"
#include "views/small_scenes.h"

#include <QtTest>

#include <numbers>

namespace ripstop::test_transform {

namespace {

constexpr double pi = std::numbers::pi;

Scene cloth(double side = 10.0)
{
    return *build(*findBuilder("cloth"), {{"columns", side}, {"rows", side}});
}

const Part& partOf(const Scene& scene)
{
    const Part* found = nullptr;
    forEachPart(scene, [&](Id, const Part& part) { found = found ? found : &part; });
    return *found;
}

std::vector<Id> allParticles(const Scene& scene)
{
    std::vector<Id> ids;
    for (const Particle& row : partOf(scene).particles)
        ids.push_back(row.id);
    return ids;
}

Vec3 placeOf(const Scene& scene, Id id)
{
    return std::get<const Particle*>(*find(scene, id))->position;
}

double lengthOf(const Scene& scene, const Link& link)
{
    return (placeOf(scene, link.to) - placeOf(scene, link.from)).norm();
}

double areaOf(const Scene& scene)
{
    double area = 0.0;
    for (const Panel& row : partOf(scene).panels) {
        const Vec3 a = placeOf(scene, row.a);
        area += 0.5 * (placeOf(scene, row.b) - a).cross(placeOf(scene, row.c) - a).norm();
    }
    return area;
}

Scene after(Scene scene, const Edit& edit)
{
    const Scene before = scene;
    const Edit inverse = apply(scene, edit);
    Scene undone = scene;
    (void)apply(undone, inverse);
    undone.nextId = before.nextId; // no number is used twice, not even after undo
    [&] { QVERIFY2(undone == before, "undo must give back the scene as it was"); }();
    return scene;
}

Scene movedBy(const Scene& scene, const std::vector<Id>& ids, const Motion& motion,
              RestLengths lengths = RestLengths::Keep)
{
    return after(scene, moved(movableOf(scene, ids), motion, lengths, Message("Move")));
}

} // namespace

class TestTransform : public QObject
{
    Q_OBJECT

private slots:
    void linksAndItemsMeanTheirParticles()
    {
        const Scene scene = oneOfEverything();
        const std::vector<Id> pair{Id{2}, Id{3}}, all{Id{2}, Id{3}, Id{4}};
        QCOMPARE(particlesOf(scene, {Id{5}}), pair);                  // a link
        QCOMPARE(particlesOf(scene, {Id{8}}), all);                   // a panel
        QCOMPARE(particlesOf(scene, {Id{1}}), all);                   // the part
        QCOMPARE(particlesOf(scene, {Id{10}}), all);                  // the cloth of the panel
        QCOMPARE(particlesOf(scene, {Id{14}}), (std::vector{Id{2}})); // target of a control
        QCOMPARE(particlesOf(scene, {Id{11}, Id{2}}), all);           // 3, link 5 and panel 8
        QVERIFY(particlesOf(scene, {Id{12}, Id{99}}).empty());
        QCOMPARE(movableOf(scene, {Id{12}}).colliders.size(), std::size_t(1));
    }

    void pivots()
    {
        Scene scene = oneOfEverything();                          // at (0,1), (1,1), (0,0)
        (void)apply(scene, setValue(scene, Id{3}, "mass", 0.04)); // the others 0.01
        const Movable all = movableOf(scene, {Id{1}});
        const auto near = [](const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-15; };
        QVERIFY(near(pivotOf(scene, all, Pivot::Median), Vec3(1.0 / 3.0, 2.0 / 3.0, 0)));
        QVERIFY(near(pivotOf(scene, all, Pivot::Box), Vec3(0.5, 0.5, 0)));
        QVERIFY(near(pivotOf(scene, all, Pivot::Mass), Vec3(4.0 / 6.0, 5.0 / 6.0, 0)));
        QVERIFY(near(pivotOf(scene, all, Pivot::Particle, Id{3}), Vec3(1, 1, 0)));
        QCOMPARE(pivotOf(scene, movableOf(scene, {}), Pivot::Mass), Vec3(Vec3::Zero()));
    }

    // A link's own x is along it; a panel's own z is across it.
    void ownAxesFollowTheShape()
    {
        const Scene scene = oneOfEverything(); // link 6 from (1,1,0) to (0,0,0)
        const Eigen::Matrix3d link = ownAxes(movableOf(scene, {Id{6}}));
        QVERIFY((link.col(0).cwiseAbs() - Vec3(1, 1, 0) / std::sqrt(2.0)).norm() < 1e-12);
        const Eigen::Matrix3d panel = ownAxes(movableOf(scene, {Id{8}}));
        QVERIFY(std::abs(std::abs(panel.col(2).z()) - 1.0) < 1e-12);
        QVERIFY(std::abs(panel.determinant() - 1.0) < 1e-12);
        QVERIFY(ownAxes(movableOf(scene, {Id{3}})).isIdentity());
    }

    void movingMovesWhatIsSelectedOnly()
    {
        const Scene scene = oneOfEverything();
        const Scene now = movedBy(scene, {Id{3}}, shifted(Vec3(0.5, -1.0, 2.0)));
        QCOMPARE(placeOf(now, Id{3}), Vec3(1.5, 0.0, 2.0));
        QCOMPARE(placeOf(now, Id{2}), placeOf(scene, Id{2}));
        QCOMPARE(partOf(now).links, partOf(scene).links); // rest lengths are kept
    }

    // A link with both ends in what is moved keeps the rest length it was given; one that is
    // pulled longer gets its new length.
    void movingBindsOnlyLinksThatChange()
    {
        Scene scene = oneOfEverything();
        (void)apply(scene, setValue(scene, Id{5}, "restLength", 0.75)); // from 2 to 3
        const Scene now =
            movedBy(scene, {Id{2}, Id{3}}, shifted(Vec3(0, 2, 0)), RestLengths::Rebind);
        QCOMPARE(partOf(now).links[0].restLength, 0.75);
        QCOMPARE(partOf(now).links[1].restLength, std::sqrt(1.0 + 9.0)); // (1,3) to (0,0)
        QCOMPARE(partOf(now).links[2].restLength, 3.0);
    }

    void turningKeepsDistances()
    {
        const Scene scene = cloth();
        const Movable all = movableOf(scene, allParticles(scene));
        const Vec3 pivot = pivotOf(scene, all, Pivot::Mass);
        const Scene now = movedBy(scene, allParticles(scene), turned(pivot, Vec3(1, 2, -0.5), 0.7));
        for (const Link& row : partOf(scene).links)
            QVERIFY(std::abs(lengthOf(now, row) - lengthOf(scene, row)) < 1e-14);
        const Vec3 after = pivotOf(now, movableOf(now, allParticles(now)), Pivot::Mass);
        QVERIFY((after - pivot).norm() < 1e-14);
        QVERIFY((placeOf(now, Id{partOf(now).particles.front().id})
                 - placeOf(scene, partOf(scene).particles.front().id))
                    .norm()
                > 0.1);
    }

    void aQuarterTurnAboutZTakesXToY()
    {
        Scene scene = oneOfEverything();
        const Scene now = movedBy(scene, {Id{3}}, turned(Vec3(0, 1, 0), Vec3(0, 0, 5), 0.5 * pi));
        QVERIFY((placeOf(now, Id{3}) - Vec3(0, 2, 0)).norm() < 1e-15);
    }

    // Twice as large in every direction is four times the area, and twice the rest lengths of what
    // was free of load; along one axis it is twice the area.
    void scalingScalesAreaAndBoundLengths()
    {
        const Scene scene = cloth();
        const std::vector<Id> ids = allParticles(scene);
        const Vec3 pivot(0.3, -1.0, 0.2);
        const Scene larger = movedBy(scene, ids, scaled(pivot, Vec3(2, 2, 2)), RestLengths::Rebind);
        QVERIFY(std::abs(areaOf(larger) / areaOf(scene) - 4.0) < 1e-12);
        for (std::size_t i = 0; i < partOf(scene).links.size(); ++i)
            QVERIFY(std::abs(partOf(larger).links[i].restLength
                             - 2.0 * lengthOf(scene, partOf(scene).links[i]))
                    < 1e-13);
        QCOMPARE(partOf(movedBy(scene, ids, scaled(pivot, Vec3(2, 2, 2)))).links,
                 partOf(scene).links);

        // along a direction of its own plane, which the cloth's middle panel tells
        const Panel& panel = partOf(scene).panels.front();
        const Vec3 along = (placeOf(scene, panel.b) - placeOf(scene, panel.a)).normalized();
        const Eigen::Quaterniond toAxis = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitX(), along);
        const Scene wider =
            movedBy(scene, ids, scaled(pivot, Vec3(2, 1, 1), toAxis.toRotationMatrix()));
        QVERIFY(std::abs(areaOf(wider) / areaOf(scene) - 2.0) < 1e-12);
    }

    void collidersGoAlong()
    {
        Scene scene = oneOfEverything();
        Collider box;
        box.shape = ColliderShape::Box;
        box.position = Vec3(1, 0, 0);
        box.turn = Vec3(10, 20, 30);
        box.path = "0: 1 0 0; 2: 1 0 3";
        scene.items.push_back({Id{17}, box});
        scene.nextId = Id{18};
        const Eigen::Matrix3d quarter =
            Eigen::AngleAxisd(0.5 * pi, Vec3::UnitY()).toRotationMatrix();
        const Scene now =
            movedBy(scene, {Id{12}, Id{17}}, turned(Vec3::Zero(), Vec3::UnitY(), 0.5 * pi));
        const Collider& turnedBox = *findItem<Collider>(now, Id{17});
        QVERIFY((turnedBox.position - Vec3(0, 0, -1)).norm() < 1e-15);
        QVERIFY((turnOf(turnedBox) - quarter * turnOf(box)).norm() < 1e-14);
        QVERIFY(turnedBox.path.starts_with("0:")
                && turnedBox.path.find("; 2: 3 0") != std::string::npos);

        // the plane y = 0, tipped over by a right angle about z, faces -x
        const Scene tipped =
            movedBy(scene, {Id{12}}, turned(Vec3::Zero(), Vec3::UnitZ(), 0.5 * pi));
        QVERIFY((findItem<Collider>(tipped, Id{12})->normal - Vec3(-1, 0, 0)).norm() < 1e-15);

        Collider ball;
        ball.shape = ColliderShape::Sphere;
        ball.position = Vec3(1, 1, 0);
        ball.radius = 0.5;
        scene.items.back().item = ball;
        const Scene larger = movedBy(scene, {Id{17}}, scaled(Vec3::Zero(), Vec3(3, 3, 3)));
        QVERIFY(std::abs(findItem<Collider>(larger, Id{17})->radius - 1.5) < 1e-15);
        QCOMPARE(findItem<Collider>(larger, Id{17})->position, Vec3(3, 3, 0));
    }

    // A cylinder grows along its axis and across it, each for itself while it stands upright; where
    // it is turned, all of it grows by the mean.
    void cylindersGrow()
    {
        Scene scene = oneOfEverything();
        Collider drum;
        drum.shape = ColliderShape::Cylinder;
        drum.position = Vec3(1, 1, 0);
        drum.radius = 0.5;
        drum.size = Vec3(1, 2, 1);
        scene.items.push_back({Id{17}, drum});
        scene.nextId = Id{18};
        const auto grown = [&](const Vec3& factors) {
            return *findItem<Collider>(movedBy(scene, {Id{17}}, scaled(Vec3::Zero(), factors)),
                                       Id{17});
        };
        QVERIFY(std::abs(grown(Vec3(3, 3, 3)).radius - 1.5) < 1e-15);
        QVERIFY(std::abs(grown(Vec3(3, 3, 3)).size.y() - 6.0) < 1e-14);
        QCOMPARE(grown(Vec3(1, 4, 1)).radius, 0.5);
        QCOMPARE(grown(Vec3(1, 4, 1)).size.y(), 8.0);
        QVERIFY(std::abs(grown(Vec3(2, 1, 8)).radius - 2.0) < 1e-15); // the same area of its caps
        QCOMPARE(grown(Vec3(2, 1, 8)).size.y(), 2.0);

        std::get<Collider>(scene.items.back().item).turn = Vec3(90, 0, 0);
        QVERIFY(std::abs(grown(Vec3(2, 2, 2)).radius - 1.0) < 1e-15);
        QVERIFY(std::abs(grown(Vec3(2, 2, 2)).size.y() - 4.0) < 1e-14);
        const Scene turnedScene =
            movedBy(scene, {Id{17}}, turned(Vec3::Zero(), Vec3::UnitX(), -0.5 * pi));
        QVERIFY(findItem<Collider>(turnedScene, Id{17})->turn.norm() < 1e-12);
        QCOMPARE(findItem<Collider>(turnedScene, Id{17})->radius, 0.5);
    }

    // The steps of one drag must merge, whatever the hand does in between.
    void stepsOfAGestureSetTheSameThings()
    {
        const Scene scene = oneOfEverything();
        const Movable all = movableOf(scene, {Id{1}, Id{12}});
        const Edit one =
            moved(all, scaled(Vec3::Zero(), Vec3(1, 1, 1)), RestLengths::Rebind, Message());
        const Edit two =
            moved(all, scaled(Vec3::Zero(), Vec3(2, 1, 3)), RestLengths::Rebind, Message());
        QVERIFY(sameTargets(one, two));
        QVERIFY(sameTargets(moved(all, shifted(Vec3::Zero()), RestLengths::Rebind, Message()),
                            moved(all, shifted(Vec3(1, 2, 3)), RestLengths::Rebind, Message())));
    }

    void nothingToMoveIsNoEdit()
    {
        const Scene scene = oneOfEverything();
        QVERIFY(moved(movableOf(scene, {}), shifted(Vec3(1, 0, 0)), RestLengths::Keep, Message())
                    .changes.empty());
    }

    // A drag of all of a cloth of 100 000 particles: each of its steps.
    void aLargeClothMovesAtOnce()
    {
        Scene scene = cloth(316.0);
        const std::vector<Id> ids = allParticles(scene);
        QVERIFY(ids.size() >= 100000);
        const double start = threadTime();
        const Movable all = movableOf(scene, ids);
        const double found = threadTime() - start;
        const double height = placeOf(scene, ids.back()).y();
        const double before = threadTime();
        const Edit edit = moved(all, shifted(Vec3(0, 1, 0)), RestLengths::Keep, Message("Move"));
        (void)apply(scene, edit);
        qInfo("%zu particles: found in %.1f ms, moved in %.1f ms", ids.size(), found,
              threadTime() - before);
        QCOMPARE(placeOf(scene, ids.back()).y(), height + 1.0);
    }
};

const RegisteredTest registered("test_transform", runWithCore<TestTransform>);

} // namespace ripstop::test_transform
#include "test_transform.moc"
