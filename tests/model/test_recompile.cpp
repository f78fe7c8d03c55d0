// Edits of a running scene: what an edit in place leaves behind is what a full compile gives.
#include "assembly/finish.h"
#include "compile/compile.h"
#include "compile/live_system.h"
#include "compile/patch.h"
#include "measure/diagnostics.h"
#include "model/rich_scene.h"
#include "model/systems.h"
#include "registered_test.h"
#include "run/runner.h"
#include "simulation/simulation.h"
#include "simulation/torn_system.h"
#include "system/fields.h"

#include <QtTest>

#include <algorithm>
#include <thread>

namespace ripstop::test_recompile {
namespace {

// What tears have made of a system is kept by each simulation for itself, so that its address says
// nothing.
bool isAlike(Layout a, Layout b)
{
    const bool areTorn = a.torn && b.torn && a.torn->splits == b.torn->splits;
    const bool areWhole = !a.torn && !b.torn;
    a.torn.reset();
    b.torn.reset();
    return (areTorn || areWhole) && a == b;
}

std::vector<Id> idsOf(const Scene& scene, Kind kind)
{
    if (kind == Kind::Settings)
        return {settingsId};
    std::vector<Id> ids;
    const auto add = [&](Kind rowKind, const auto& rows) {
        for (const auto& row : rows)
            if (rowKind == kind)
                ids.push_back(row.id);
    };
    for (const Entry& entry : scene.items) {
        if (kindOf(asConst(*find(const_cast<Scene&>(scene), entry.id))) == kind)
            ids.push_back(entry.id);
        if (const Part* part = std::get_if<Part>(&entry.item)) {
            add(Kind::Particle, part->particles);
            add(Kind::Link, part->links);
            add(Kind::Panel, part->panels);
        }
    }
    return ids;
}

// Values that the property takes and mostly does not have, for the thing with this id.
std::vector<Value> otherValues(const Scene& scene, const Property& property, Id id, Dice& dice)
{
    const Value now = property.get(*find(scene, id));
    std::vector<Value> values;
    if (property.optional)
        values.emplace_back(std::monostate());
    const Value shape = property.optional ? Value(1.0) : now;
    std::vector<Id> targets;
    for (int kind = 0; kind < kindCount; ++kind)
        if (property.pointsAt.contains(Kind(kind)))
            for (const Id target : idsOf(scene, Kind(kind)))
                targets.push_back(target);

    if (const auto* yes = std::get_if<bool>(&shape))
        values.emplace_back(!*yes);
    else if (const auto* whole = std::get_if<int>(&shape))
        values.emplace_back(*whole + 1);
    else if (const auto* real = std::get_if<double>(&shape))
        for (const double value : {1.25 * *real, *real + 0.125, 0.0})
            values.emplace_back(value);
    else if (std::holds_alternative<std::string>(shape) && property.choices.empty())
        values.emplace_back(std::string("#102030"));
    else if (std::holds_alternative<std::string>(shape))
        for (const std::string_view choice : property.choices)
            values.emplace_back(std::string(choice));
    else if (const auto* vector = std::get_if<Vec3>(&shape))
        values.emplace_back(Vec3(*vector + dice.vector(0.2)));
    else if (std::holds_alternative<Id>(shape)) {
        values.emplace_back(noId);
        values.emplace_back(Id{3000000000u}); // nothing has it
        for (int i = 0; i < 2 && !targets.empty(); ++i)
            values.emplace_back(targets[std::size_t(dice.below(int(targets.size())))]);
    } else if (std::holds_alternative<std::vector<Id>>(shape)) {
        values.emplace_back(std::vector<Id>{});
        values.emplace_back(std::vector<Id>{targets.front(), targets.back()});
    }
    if (std::holds_alternative<NumberRows>(shape))
        values.emplace_back(NumberRows{{0, 0.1, 0.02}, {20, 1.1, 0.3}, {90, 0, 1.2}});
    std::erase_if(values, [&](const Value& value) { return refusal(property, value).has_value(); });
    return values;
}

// A scene that is edited, with a simulation that follows in place and one that is given the whole
// compiled scene every time.
class Pair
{
public:
    explicit Pair(Scene scene)
        : m_scene(std::move(scene))
        , m_live(m_scene)
        , m_patched(*std::make_shared<System>(*std::get<Update>(m_live.update(1, 1)).system))
        , m_following(std::make_shared<System>(m_patched))
        , m_loaded(*compile(m_scene))
    {}

    const Scene& scene() const { return m_scene; }
    void startOver() { ++m_run; }

    Edit apply(const Edit& edit)
    {
        m_live.apply(edit);
        return ripstop::apply(m_scene, edit);
    }

    // Empty when both ways agree.
    QString difference()
    {
        ++m_generation;
        const auto whole = compile(m_scene, m_generation, m_run);
        auto update = m_live.update(m_generation, m_run);
        m_isBroken = std::holds_alternative<Finding>(update);
        if (const auto* problem = std::get_if<Finding>(&update))
            return whole ? "a problem that compile() does not have: "
                               + QString::fromStdString(problem->message.english())
                   : problem->message != whole.message() ? "another problem"
                                                         : QString();
        if (!whole)
            return "no problem, but compile() has one: "
                   + QString::fromStdString(whole.message().english());
        const Update& made = std::get<Update>(update);
        m_wasPatch = made.patch != nullptr;
        if (made.system)
            m_patched = *made.system;
        else
            ripstop::apply(*made.patch, m_patched);
        if (const std::string field(differingField(m_patched, **whole)); !field.empty())
            return QString::fromStdString("another system: " + field);

        m_following.load(made);
        m_loaded.load(*whole);
        for (int i = 0; i < 3; ++i)
            if (m_following.step() != m_loaded.step())
                return "only one of them can go on";
        const std::string field(differingField(m_following.state(), m_loaded.state()));
        if (!field.empty())
            return QString::fromStdString("another motion: " + field);
        if (!isAlike(*m_following.frame()->layout, *m_loaded.frame()->layout))
            return "another layout";
        if (m_following.trouble())
            startOver();
        return {};
    }

    bool wasPatch() const { return m_wasPatch; } // the last update
    bool isBroken() const { return m_isBroken; }

private:
    Scene m_scene;
    LiveSystem m_live;
    System m_patched;
    Simulation m_following;
    Simulation m_loaded;
    std::uint64_t m_generation = 1;
    std::uint64_t m_run = 1;
    bool m_wasPatch = false;
    bool m_isBroken = false;
};

QString wordsFor(const Property& property)
{
    return QString::fromStdString(std::string(kindName(property.kind)) + "."
                                  + std::string(property.key));
}

const Property* row(Kind kind, const char* key)
{
    const Property* found = findProperty(kind, key);
    Q_ASSERT(found);
    return found;
}

Edit setOne(const Property* property, std::vector<Id> targets, Value value)
{
    return {Message("test"), {SetValues{property, std::move(targets), {std::move(value)}}}};
}

// One edit of any kind that fits the scene.
Edit randomEdit(const Scene& scene, Dice& dice)
{
    const auto any = [&](const auto& list) {
        return list[std::size_t(dice.below(int(list.size())))];
    };
    Edit edit{Message("random"), {}};
    switch (dice.below(12)) {
    case 0: { // a link between any two particles
        const std::vector<Id> particles = idsOf(scene, Kind::Particle);
        Link link{scene.nextId, any(particles), any(particles), any(idsOf(scene, Kind::Material))};
        link.kind = dice.below(2) ? LinkKind::Rod : LinkKind::Spring;
        link.restLength = dice(0.1, 1.0);
        if (link.from != link.to)
            edit.changes.emplace_back(AddRows{any(idsOf(scene, Kind::Part)), {}, {link}, {}});
        break;
    }
    case 1: { // a particle that hangs on another
        const Id id = scene.nextId;
        Particle particle{id, dice.vector(2.0), dice.vector(1.0), dice(0.01, 0.1)};
        Link link{Id{std::uint32_t(id) + 1}, id, any(idsOf(scene, Kind::Particle)),
                  any(idsOf(scene, Kind::Material))};
        edit.changes.emplace_back(AddRows{any(idsOf(scene, Kind::Part)), {particle}, {link}, {}});
        break;
    }
    case 2:
        return removal(scene, {any(idsOf(scene, dice.below(2) ? Kind::Link : Kind::Panel))});
    case 3:
        if (dice.below(4) == 0)
            return removal(scene, {any(idsOf(scene, Kind::Particle))});
        break;
    case 4: {
        const Item items[] = {Wind{"gust", dice.vector(2.0)}, Probe{"new"}, Control{"idle"},
                              Collider{}, Material{"new"}};
        edit.changes.emplace_back(AddItem{std::size_t(dice.below(int(scene.items.size()) + 1)),
                                          {scene.nextId, items[std::size_t(dice.below(5))]}});
        break;
    }
    default: {
        const auto all = allProperties();
        const Property& property = all[std::size_t(dice.below(int(all.size())))];
        const std::vector<Id> ids = idsOf(scene, property.kind);
        if (ids.empty())
            break;
        const Id id = any(ids);
        const std::vector<Value> values = otherValues(scene, property, id, dice);
        if (!values.empty())
            edit = setOne(&property, dice.below(5) ? std::vector{id} : ids, any(values));
    }
    }
    return edit;
}

} // namespace

class TestRecompile : public QObject
{
    Q_OBJECT

private slots:
    // Every property there is, of one thing and of all of its kind; and undone.
    void properties_data()
    {
        QTest::addColumn<int>("number");
        int number = 0;
        for (const Property& property : allProperties())
            QTest::newRow(wordsFor(property).toLatin1()) << number++;
    }
    void properties()
    {
        QFETCH(int, number);
        const Property& property = allProperties()[std::size_t(number)];
        Pair pair(rich());
        Dice dice{std::uint32_t(number)};
        const std::vector<Id> ids = idsOf(pair.scene(), property.kind);
        QVERIFY(!ids.empty());
        for (const std::vector<Id>& targets :
             {std::vector{ids.front()}, std::vector{ids.back()}, ids})
            for (const Value& value : otherValues(pair.scene(), property, targets.front(), dice)) {
                const Edit inverse = pair.apply(setOne(&property, targets, value));
                QString what = pair.difference();
                QVERIFY2(what.isEmpty(), qPrintable("after the edit: " + what));
                (void)pair.apply(inverse);
                what = pair.difference();
                QVERIFY2(what.isEmpty(), qPrintable("after undo: " + what));
            }
    }

    // Anything in any order, undone now and then, looked at after one edit or after some.
    void randomEdits_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 8; ++seed)
            QTest::addRow("seed %d", seed) << seed;
    }
    void randomEdits()
    {
        QFETCH(int, seed);
        Pair pair(seed % 2 ? rich() : *build(*findBuilder("hang_glider"), {}));
        Dice dice{std::uint32_t(seed)};
        std::vector<Edit> done;
        int patches = 0;
        for (int i = 0; i < 250; ++i) {
            if (!done.empty() && (pair.isBroken() || dice.below(3) == 0)) {
                (void)pair.apply(done.back());
                done.pop_back();
            } else {
                const Edit edit = randomEdit(pair.scene(), dice);
                done.push_back(pair.apply(edit));
            }
            if (dice.below(10) == 0)
                pair.startOver();
            if (dice.below(4) == 0)
                continue; // the next update has both
            const QString what = pair.difference();
            QVERIFY2(what.isEmpty(), qPrintable(QString("edit %1: %2").arg(i).arg(what)));
            patches += pair.wasPatch();
        }
        QVERIFY2(patches > 20, qPrintable(QString::number(patches)));
    }

    void structureNeedsASystem_data()
    {
        QTest::addColumn<QString>("property");
        QTest::addColumn<bool>("inPlace");
        QTest::newRow("mass") << "particle.mass" << true;
        QTest::newRow("pin") << "particle.pinned" << true;
        QTest::newRow("rest length") << "link.restLength" << true;
        QTest::newRow("material of a link") << "link.material" << true;
        QTest::newRow("what it resists") << "link.resists" << true;
        QTest::newRow("stiffness of a material") << "material.stiffness" << true;
        QTest::newRow("tear rule of a material") << "material.tearRule" << true;
        QTest::newRow("wind") << "wind.velocity" << true;
        QTest::newRow("solver") << "settings.solver" << true;
        QTest::newRow("targets of a control") << "control.targets" << true;
        QTest::newRow("end of a link") << "link.from" << false;
        QTest::newRow("kind of a link") << "link.kind" << false;
        QTest::newRow("corner of a panel") << "panel.b" << false;
    }
    void structureNeedsASystem()
    {
        QFETCH(QString, property);
        QFETCH(bool, inPlace);
        for (const Property& candidate : allProperties()) {
            if (wordsFor(candidate) != property)
                continue;
            Pair pair(rich(Integrator::SemiImplicitEuler)); // springs stay forces
            Dice dice{7};
            const Id id = idsOf(pair.scene(), candidate.kind).back();
            (void)pair.apply(
                setOne(&candidate, {id}, otherValues(pair.scene(), candidate, id, dice).front()));
            QCOMPARE(pair.difference(), QString());
            QCOMPARE(pair.wasPatch(), inPlace);
            return;
        }
        QFAIL("there is no such property");
    }

    // A side without a rest length has the distance of its corners, so a particle that moves cuts
    // the panels about it anew.
    void startCutsPanels_data()
    {
        QTest::addColumn<double>("restLength");
        QTest::newRow("cut by where it starts") << 0.0;
        QTest::newRow("cut by its sides") << 1.0;
    }
    void startCutsPanels()
    {
        QFETCH(double, restLength);
        Scene scene;
        Material cloth{"Cloth"};
        cloth.membraneStiffness = 1000.0; // N/m
        const Id material = takeId(scene);
        scene.items.push_back({material, cloth});
        Part part{"Sheet"};
        part.carrier = FabricKind::Panels;
        for (const Vec3& at : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)})
            part.particles.push_back({.id = takeId(scene), .position = at, .mass = 1.0});
        const Id moved = part.particles[2].id;
        part.panels.push_back({.id = takeId(scene),
                               .a = part.particles[0].id,
                               .b = part.particles[1].id,
                               .c = moved,
                               .material = material,
                               .restAB = restLength,
                               .restBC = restLength,
                               .restCA = restLength});
        scene.items.push_back({takeId(scene), part});
        Pair pair(scene);
        const Edit back =
            pair.apply(setOne(row(Kind::Particle, "position"), {moved}, Vec3(0.2, 2.0, 0.0)));
        QCOMPARE(pair.difference(), QString());
        QCOMPARE(pair.wasPatch(), restLength > 0.0);
        (void)pair.apply(back);
        QCOMPARE(pair.difference(), QString());
    }

    // What was noted while the scene was broken is not forgotten when it is cured.
    void cure()
    {
        Pair pair(rich());
        const std::vector<Id> particles = idsOf(pair.scene(), Kind::Particle);
        const Property* mass = row(Kind::Particle, "mass");
        const Edit cured = pair.apply(setOne(mass, {particles.back()}, 0.0));
        QCOMPARE(pair.difference(), QString());
        (void)pair.apply(setOne(row(Kind::Wind, "velocity"), idsOf(pair.scene(), Kind::Wind),
                                Vec3(4.0, 0.0, 0.0)));
        (void)pair.apply(setOne(row(Kind::Particle, "mass"), {particles[3]}, 0.5));
        QCOMPARE(pair.difference(), QString());
        (void)pair.apply(cured);
        QCOMPARE(pair.difference(), QString());
        QVERIFY(pair.wasPatch());
    }

    // A system that two simulations share stays as it is for the other one.
    void sharedSystem()
    {
        const Scene scene = rich();
        LiveSystem live(scene);
        const auto system = std::get<Update>(live.update(1, 1)).system;
        Simulation edited(system);
        Simulation other(system);
        live.apply(setOne(row(Kind::Settings, "gravity"), {settingsId}, Vec3(0.0, 0.0, 0.0)));
        edited.load(std::get<Update>(live.update(2, 1)));
        QCOMPARE(edited.system().gravity, Vec3(0.0, 0.0, 0.0));
        QCOMPARE(other.system().gravity, scene.settings.gravity);
        QVERIFY(*system == **compile(scene));
    }

    // Updates that the runner finds together are all taken, in order.
    void runnerTakesAll()
    {
        Scene scene = rich();
        LiveSystem live(scene);
        Runner runner;
        Simulation simulation(*compile(scene));
        runner.load(std::get<Update>(live.update(1, 1)));
        const auto change = [&](std::uint64_t generation, const Edit& edit) {
            live.apply(edit);
            (void)ripstop::apply(scene, edit);
            runner.load(std::get<Update>(live.update(generation, 1)));
        };
        const std::vector<Id> particles = idsOf(scene, Kind::Particle);
        const Id part = idsOf(scene, Kind::Part).back();
        change(2, setOne(row(Kind::Particle, "mass"), {particles[5]}, 0.3));
        change(3, {Message("link"),
                   {AddRows{part, {}, {{scene.nextId, particles[7], particles[9]}}, {}}}});
        change(4, setOne(row(Kind::Settings, "substeps"), {settingsId}, 7));
        change(5, setOne(row(Kind::Particle, "pinned"), {particles[8]}, true));
        simulation.load(*compile(scene, 5, 1));
        runner.playUntil(0.1);
        simulation.runUntil(0.1);
        std::shared_ptr<const Frame> frame;
        for (int i = 0; i < 5000 && !(frame && hasReached(frame->time, 0.1, 1.0 / 240.0)); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            if (auto next = runner.takeFrame())
                frame = next;
        }
        QVERIFY(frame);
        QCOMPARE(frame->generation, std::uint64_t(5));
        QCOMPARE(frame->hash, stateHash(simulation.state()));
    }

    // Solvers look again at what was touched since they looked last, or at all.
    void touched()
    {
        System system = emptySystem(0.01);
        for (int i = 0; i < 3; ++i)
            addParticle(system, {double(i), 0.0, 0.0}, 1.0);
        addRod(system, 0, 1, 1.0);
        addRod(system, 1, 2, 1.0);
        finish(system);
        const std::uint64_t first = system.valuesSerial;
        touch(system, {0, {2}, {1}});
        const std::uint64_t second = system.valuesSerial;
        QVERIFY(second != first);
        QVERIFY(first >= system.touched.since);
        QCOMPARE(system.touched.rods, std::vector<int>{1});
        QCOMPARE(system.touched.particles, std::vector<int>{2});
        touchAll(system);
        QVERIFY(second < system.touched.since);
        touch(system, {0, {}, std::vector<int>(10000, 1)});
        QVERIFY(system.valuesSerial == system.touched.since && system.touched.rods.empty());
    }
};

const RegisteredTest registered("test_recompile", runPlain<TestRecompile>);

} // namespace ripstop::test_recompile
#include "test_recompile.moc"
