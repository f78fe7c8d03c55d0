// Who holds, flies and hangs: what a design says of its people, and where their bodies are.
//
// First the kites, gliders and parachutes of the builders, then designs that have nobody, then the
// body: its height, the hand at the end of the line wherever that goes, and knees that bend for it.
#include "look/figure.h"
#include "look/scene_frame.h"
#include "registered_test.h"

#include "builders/builder.h"

#include <Eigen/Geometry>

namespace ripstop::test_people {

namespace {

Scene built(std::string_view name, Parameters given = {})
{
    const Builder& builder = *findBuilder(name);
    Parameters all = unsaid(builder);
    for (const auto& [key, value] : given)
        all[key] = value;
    return *build(builder, all);
}

struct Seen
{
    Scene scene;
    std::shared_ptr<const Frame> frame;
    std::vector<ColliderBody> colliders;
    std::vector<Person> people;

    explicit Seen(Scene of)
        : scene(std::move(of))
        , frame(sceneFrame(scene))
        , colliders(bodiesOf(scene, {}))
        , people(peopleOf(scene, *frame->layout))
    {}
    std::vector<Limb> limbs() const { return limbsOf(people.at(0), *frame, colliders); }
    Vec3 held() const { return frame->position[std::size_t(people.at(0).holds.at(0))]; }
};

// m, of a body along a direction.
double lowest(const std::vector<Limb>& limbs, const Vec3& along)
{
    double low = 1e300;
    for (const Limb& limb : limbs)
        low = std::min(
            {low, limb.from.dot(along) - limb.fromRadius, limb.to.dot(along) - limb.toRadius});
    return low;
}
double extent(const std::vector<Limb>& limbs, const Vec3& along)
{
    return -lowest(limbs, -along) - lowest(limbs, along);
}

double distanceOfHand(const std::vector<Limb>& limbs, const Vec3& place)
{
    double least = 1e300;
    for (const Limb& limb : limbs)
        if (limb.from == limb.to) // only hands are balls
            least = std::min(least, (limb.to - place).norm());
    return least;
}

} // namespace

class TestPeople : public QObject
{
    Q_OBJECT

private slots:
    void kitesAreHeldByOnePerson_data()
    {
        QTest::addColumn<QString>("builder");
        for (const char* name : {"delta_kite", "diamond_kite", "rectangular_kite"})
            QTest::newRow(name) << QString(name);
    }
    void kitesAreHeldByOnePerson()
    {
        QFETCH(const QString, builder);
        const Seen seen(built(builder.toStdString()));
        QCOMPARE(seen.people.size(), std::size_t(1));
        QCOMPARE(seen.people[0].pose, Pose::Standing);
        // 1.75 m from the ground, on which both feet are
        QVERIFY(std::abs(extent(seen.limbs(), Vec3::UnitY()) - 1.75) < 0.01);
        QVERIFY(std::abs(lowest(seen.limbs(), Vec3::UnitY())) < 0.02);
        QVERIFY(distanceOfHand(seen.limbs(), seen.held()) < 1e-9);
    }

    void pilotsLieAlongTheKeel()
    {
        const Seen seen(built("hang_glider"));
        QCOMPARE(seen.people.size(), std::size_t(1));
        QCOMPARE(seen.people[0].pose, Pose::Prone);
        // from the crown to the toes, which are stretched: longer than one stands
        std::vector<Limb> body = seen.limbs();
        std::erase_if(body, [](const Limb& limb) { return limb.fromRadius < 0.02; }); // the frame
        const double length = extent(body, Vec3::UnitX());
        QVERIFY(length > 1.7 && length < 2.0);
        QVERIFY(extent(body, Vec3::UnitY()) < 0.9);
    }

    // Wires meet at the foot of the control frame, 1.25 times as far below the keel as the pilot
    // hangs: the middle of the bar is there, both hands are on it, and the strap reaches from the
    // keel to the harness.
    void pilotsHangInTheirControlFrame()
    {
        const double depth = 1.3;
        const Seen seen(built("hang_glider", {{"pilot_depth", depth}}));
        QCOMPARE(seen.people[0].bar.size(), std::size_t(1));
        const Vec3 foot = seen.frame->position[std::size_t(seen.people[0].bar[0])];
        QVERIFY(std::abs((foot - seen.held()).norm() - 0.25 * depth) < 1e-9);
        const std::vector<Limb> limbs = seen.limbs();
        const auto bar = std::ranges::find_if(limbs, [&](const Limb& limb) {
            return limb.fromRadius < 0.02 && (0.5 * (limb.from + limb.to) - foot).norm() < 1e-9;
        });
        QVERIFY(bar != limbs.end());
        int hands = 0;
        for (const Limb& limb : limbs)
            hands += limb.from == limb.to // a hand is a ball
                     && (limb.from - foot).cross(bar->to - bar->from).norm() < 1e-9;
        QCOMPARE(hands, 2);
        const auto strap =
            std::ranges::find_if(limbs, [](const Limb& limb) { return limb.fromRadius < 0.012; });
        QVERIFY(strap != limbs.end());
        QVERIFY((strap->to - seen.held()).norm() < 0.14); // on the harness
        QVERIFY((strap->from - seen.held()).norm() > 0.8 * depth);
    }

    // It turns with its glider: half round, it faces the other way, and is as long.
    void pilotsTurnWithTheGlider()
    {
        Seen seen(built("hang_glider"));
        const double before = lowest(seen.limbs(), Vec3::UnitX()) - seen.held().x();
        auto frame = std::make_shared<Frame>(*seen.frame);
        for (Vec3& place : frame->position)
            place = Vec3(-place.x(), place.y(), -place.z());
        seen.frame = frame;
        const double after = lowest(seen.limbs(), -Vec3::UnitX()) + seen.held().x();
        QVERIFY(std::abs(before - after) < 1e-9);
    }

    void jumpersHangBelowTheirParachute()
    {
        const Seen seen(built("parachute"));
        QCOMPARE(seen.people.size(), std::size_t(1));
        QCOMPARE(seen.people[0].pose, Pose::Upright);
        const double top = -lowest(seen.limbs(), -Vec3::UnitY());
        QVERIFY(top <= seen.held().y() + 0.02 && top > seen.held().y() - 0.1);
        const double tall = extent(seen.limbs(), Vec3::UnitY());
        QVERIFY(tall > 1.75 && tall < 2.3); // with risers above and toes below
    }

    // Who has come down stands on the ground, and does not hang below it, as tall as ever.
    void whoHasLandedStands()
    {
        const Scene scene = built("parachute");
        const double height = Seen(scene).held().y(); // m over the ground
        for (const double left : {1.5, 0.5, 0.0}) {
            Seen seen(scene);
            Frame low = *seen.frame;
            for (Vec3& place : low.position)
                place.y() += left - height;
            seen.frame = std::make_shared<const Frame>(low);
            QVERIFY(std::abs(lowest(seen.limbs(), Vec3::UnitY())) < 0.02);
            const double tall = extent(seen.limbs(), Vec3::UnitY());
            QVERIFY(tall > 1.7 && tall < 1.8);
        }
    }

    // A load that is too light, a weight on a rope, corners of a cloth that are moved.
    void othersHaveNobody_data()
    {
        QTest::addColumn<QString>("builder");
        for (const char* name : {"cross_parachute", "rope", "cloth", "pole_flag", "bridle"})
            QTest::newRow(name) << QString(name);
    }
    void othersHaveNobody()
    {
        QFETCH(const QString, builder);
        QVERIFY(Seen(built(builder.toStdString())).people.empty());
    }

    void whoeverHoldsALineGoesWithIt()
    {
        Seen seen(built("delta_kite"));
        auto frame = std::make_shared<Frame>(*seen.frame);
        frame->position[std::size_t(seen.people[0].holds[0])] += Vec3(-3.0, 0.1, 2.0);
        seen.frame = frame;
        QVERIFY(distanceOfHand(seen.limbs(), seen.held()) < 1e-9);
        QVERIFY(std::abs(extent(seen.limbs(), Vec3::UnitY()) - 1.75) < 0.01);
    }

    void kneesBendForALowHand()
    {
        const Seen seen(built("delta_kite", {{"hand_height", 0.3}}));
        QVERIFY(distanceOfHand(seen.limbs(), seen.held()) < 1e-9);
        QVERIFY(extent(seen.limbs(), Vec3::UnitY()) < 1.4);
        QVERIFY(std::abs(lowest(seen.limbs(), Vec3::UnitY())) < 0.05);
    }

    void nobodyReachesALineFarAbove()
    {
        Seen seen(built("delta_kite"));
        auto frame = std::make_shared<Frame>(*seen.frame);
        frame->position[std::size_t(seen.people[0].holds[0])].y() = 2.5;
        seen.frame = frame;
        QVERIFY(seen.limbs().empty());
    }

    // A line that is broken off to what is not a place, as in a run that has stopped.
    void nobodyIsDrawnWhereThereIsNoPlace()
    {
        Seen seen(built("delta_kite"));
        auto frame = std::make_shared<Frame>(*seen.frame);
        frame->position[std::size_t(seen.people[0].towards[0])].x() = std::nan("");
        seen.frame = frame;
        QVERIFY(seen.limbs().empty());
    }

    // What is seen of an empty scene is what is in it: who stood there would be gone with the first
    // particle that is drawn.
    void aSceneWithoutAnythingHasNobody()
    {
        const Seen seen(Scene{});
        QVERIFY(seen.people.empty());
    }
};

const RegisteredTest registered("test_people", runPlain<TestPeople>);

} // namespace ripstop::test_people

#include "test_people.moc"
