// What a part or a group comes to beside its targets, and where its mass lies.
//
// Stages: a part without and with targets, by hand; how a difference of mass is spread; groups;
// folds; refusals; and the centre of gravity and inertia.
#include "model/systems.h"
#include "registered_test.h"

#include "author/targets.h"
#include "builders/builder.h"
#include "shaping/spread_mass.h"

#include <QtTest>

#include <numbers>

namespace ripstop::test_targets {

namespace {

// A square of 2 m with 0.1, 0.2, 0.3 and 0.4 kg at its corners, two panels, a line and a thread.
struct Square
{
    Scene scene;
    Id part{}, group{};
    std::vector<Id> corner;

    Square()
    {
        part = takeId(scene);
        Part made;
        for (int i = 0; i < 4; ++i) {
            Particle particle;
            particle.id = takeId(scene);
            particle.position = Vec3(i == 1 || i == 2 ? 2.0 : 0.0, i >= 2 ? 2.0 : 0.0, 0.0);
            particle.mass = 0.1 * (i + 1);
            corner.push_back(particle.id);
            made.particles.push_back(particle);
        }
        for (const LinkRole role : {LinkRole::Line, LinkRole::Thread}) {
            Link link;
            link.id = takeId(scene);
            link.from = corner[0];
            link.to = corner[2];
            link.role = role;
            link.restLength = 2.5;
            made.links.push_back(link);
        }
        made.panels.push_back({takeId(scene), corner[0], corner[1], corner[2]});
        made.panels.push_back({takeId(scene), corner[0], corner[2], corner[3]});
        scene.items.push_back({part, made});
        Group some;
        some.members = {corner[0], corner[1]};
        group = takeId(scene);
        scene.items.push_back({group, some});
    }

    void set(Kind kind, const char* key, Id id, double value)
    {
        (void)apply(scene, {Message("set"), {SetValues{findProperty(kind, key), {id}, {value}}}});
    }
};

} // namespace

class TestTargets : public QObject
{
    Q_OBJECT

private slots:
    void withoutTargetsThereAreNone()
    {
        Square square;
        QVERIFY(targetsOf(square.scene, square.part).empty());
        QVERIFY(targetsOf(square.scene, square.corner[0]).empty());
    }

    // 0.1 + 0.2 + 0.3 + 0.4 kg, one line of 2.5 m, two halves of 4 m^2.
    void aPartIsComparedWithEachTarget()
    {
        Square square;
        square.set(Kind::Part, "massTarget", square.part, 0.8);
        square.set(Kind::Part, "lengthTarget", square.part, 2.5);
        square.set(Kind::Part, "areaTarget", square.part, 5.0);
        const std::vector<Target> targets = targetsOf(square.scene, square.part);
        QCOMPARE(targets.size(), std::size_t(3));
        QVERIFY(isNear(targets[0].excess(), 0.2, 1e-12) && !targets[0].isMet());
        QVERIFY(isNear(targets[1].excess(), 0.0, 1e-12) && targets[1].isMet());
        QVERIFY(isNear(targets[2].excess(), -1.0, 1e-12) && !targets[2].isMet());
    }

    void theDifferenceIsSpreadInProportion()
    {
        Square square;
        square.set(Kind::Part, "massTarget", square.part, 2.0);
        const std::vector<Entry> before = square.scene.items;
        const Result<Edit> edit = massBroughtToTarget(square.scene, square.part);
        QVERIFY(edit);
        const Edit back = apply(square.scene, *edit);
        const Part& part = *findItem<Part>(square.scene, square.part);
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(isNear(part.particles[i].mass, 0.2 * double(i + 1), 1e-12));
        QVERIFY(targetsOf(square.scene, square.part).front().isMet());
        (void)apply(square.scene, back);
        QVERIFY(square.scene.items == before);
    }

    void aGroupWeighsItsMembers()
    {
        Square square;
        square.set(Kind::Group, "massTarget", square.group, 0.6);
        QVERIFY(isNear(targetsOf(square.scene, square.group).front().value, 0.3, 1e-12));
        (void)apply(square.scene, *massBroughtToTarget(square.scene, square.group));
        const Part& part = *findItem<Part>(square.scene, square.part);
        QVERIFY(isNear(part.particles[0].mass, 0.2, 1e-12));
        QVERIFY(isNear(part.particles[2].mass, 0.3, 1e-12)); // no member
    }

    // A canopy in folds has the area, and by it the mass, of its cloth laid out flat: pi D0^2 / 4.
    void foldsCountAllOfTheCloth()
    {
        for (const double cloth : {0.0, 1.0}) {
            Scene scene =
                *build(*findBuilder("parachute"),
                       {{"cloth", cloth}, {"pressure", 1.68}, {"mouth", 0.05}, {"sectors", 60.0}});
            const double area = 0.25 * std::numbers::pi * 5.0 * 5.0;
            const double rounded = 0.01 * area; // by a polygon, and by rows that are bent
            Id id = noId;
            std::vector<Id> canopy;
            for (Entry& entry : scene.items) {
                if (Part* part = std::get_if<Part>(&entry.item)) {
                    part->areaTarget = 1.0;
                    id = entry.id;
                }
                if (const Group* group = std::get_if<Group>(&entry.item);
                    group && group->name == "canopy")
                    canopy = group->members;
            }
            const double held = targetsOf(scene, id).front().value;
            QVERIFY2(isNear(held, area, rounded), told(held, area));
            (void)apply(scene, *massSpread(scene, canopy, MassBy::Area, 0.04));
            const double mass = massPropertiesOf(scene, canopy).mass;
            QVERIFY2(isNear(mass, 0.04 * area, 0.04 * rounded), told(mass, 0.04 * area));
        }
    }

    void massOfNothingCannotBeSpread()
    {
        Square square;
        for (const Id id : square.corner)
            square.set(Kind::Particle, "mass", id, 0.0);
        square.set(Kind::Part, "massTarget", square.part, 1.0);
        const Result<Edit> edit = massBroughtToTarget(square.scene, square.part);
        QVERIFY(!edit);
        QVERIFY(edit.message().english().find("no mass yet") != std::string::npos);
    }

    // Of the corners alone: the centre of gravity is sum m x / m, and with its place taken off
    // (Steiner) I_z is the sum of I_x and I_y, as all lies in one plane.
    void inertiaIsAboutTheCentreOfGravity()
    {
        Square square;
        const MassProperties weight = massPropertiesOf(square.scene, {square.part});
        QVERIFY2(isNear(weight.centre, Vec3(1.0, 1.4, 0.0), 1e-12),
                 told(weight.centre, Vec3(1.0, 1.4, 0.0)));
        // I_x = sum m y^2 - M Y^2 = 0.7 x 4 - 1.96, I_y = 0.5 x 4 - 1
        const Vec3 expected(0.84, 1.0, 1.84);
        QVERIFY2(isNear(weight.inertia, expected, 1e-12), told(weight.inertia, expected));
    }
};

const RegisteredTest registered("test_targets", runPlain<TestTargets>);

} // namespace ripstop::test_targets
#include "test_targets.moc"
