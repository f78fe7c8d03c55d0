// What the events of a run are: contact and lift-off, lines that go slack and taut, and that they
// are the same wherever a run is made.
//
// Stages: falls and bounces at known times; landings with their speeds; elastic and stiff lines
// that go slack and taut; which links count as lines; then the same events from the table, the
// recording and other numbers of threads, and older recordings.
#include "assembly/finish.h"
#include "io/recording_file.h"
#include "io/scene_file.h"
#include "model/cli_call.h"
#include "model/systems.h"
#include "recording/event_watch.h"
#include "recording/landing_watch.h"
#include "registered_test.h"
#include "simulation/simulation.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <numbers>

namespace ripstop::test_events {

namespace {

constexpr double g = standardGravity;

std::vector<RunEvent> eventsOf(System system, double seconds)
{
    Simulation simulation(std::make_shared<const System>(std::move(system)));
    EventWatch watch;
    watch.begin(simulation);
    std::vector<RunEvent> all;
    while (simulation.state().time < seconds && simulation.step())
        for (const RunEvent& event : watch.look(simulation, {}))
            all.push_back(event);
    return all;
}

// A mass dropped from 1 m on the ground.
System dropped(double restitution)
{
    System system = heavySystem(1e-3);
    addParticle(system, {0.0, 1.0, 0.0}, 1.0);
    Obstacle ground{};
    ground.key = 9;
    ground.shape = ColliderShape::Plane;
    ground.normal = {0.0, 1.0, 0.0};
    ground.response = Response::Contact;
    ground.restitution = restitution;
    system.obstacles = {ground};
    system.parts = {{7, 0}};
    finish(system);
    return system;
}

std::vector<Landing> landingsOf(System system, double seconds)
{
    Simulation simulation(std::make_shared<const System>(std::move(system)));
    LandingWatch watch;
    watch.begin();
    while (simulation.state().time < seconds) {
        watch.beforeStep(simulation);
        if (!simulation.step())
            break;
        watch.afterStep(simulation);
    }
    return {watch.all().begin(), watch.all().end()};
}

int count(const std::vector<RunEvent>& events, RunEvent::Kind kind)
{
    return int(std::ranges::count_if(events, [=](const RunEvent& e) { return e.kind == kind; }));
}

} // namespace

class TestEvents : public QObject
{
    Q_OBJECT

private slots:
    // It falls for sqrt(2 h / g) and stays: one event, however it trembles.
    void contactThatLasts()
    {
        const auto events = eventsOf(dropped(0.0), 3.0);
        QCOMPARE(events.size(), std::size_t(1));
        QCOMPARE(events[0].kind, RunEvent::Kind::Contact);
        QCOMPARE(events[0].what, 7u);
        QCOMPARE(events[0].with, 9u);
        QVERIFY(std::abs(events[0].time - std::sqrt(2.0 / g)) < 2e-3);
    }

    // A ball that gives back e of its speed is in the air for 2 e^n sqrt(2 h / g) after the n-th
    // bounce. Bounces shorter than `outlast` are no lift-off.
    void bounces()
    {
        constexpr double e = 0.5;
        const double fall = std::sqrt(2.0 / g);
        int flights = 0;
        while (2.0 * std::pow(e, flights + 1) * fall > TouchWatch::outlast)
            ++flights;
        const auto events = eventsOf(dropped(e), 3.0);
        QCOMPARE(count(events, RunEvent::Kind::Contact), flights + 1);
        QCOMPARE(count(events, RunEvent::Kind::LiftOff), flights);
        QVERIFY(std::abs(events[1].time - fall - TouchWatch::outlast) < 4e-3);
        QVERIFY(std::abs(events[2].time - fall * (1.0 + 2.0 * e)) < 5e-3);
        QVERIFY(std::ranges::is_sorted(events, {}, &RunEvent::time));
    }

    // It falls for sqrt(2 h / g) and meets the ground with sqrt(2 g h), of which a step of 1 ms may
    // be missing: told once, however it bounces, with the place.
    void landing()
    {
        for (const double restitution : {0.0, 0.5}) {
            const std::vector<Landing> landings = landingsOf(dropped(restitution), 3.0);
            QCOMPARE(landings.size(), std::size_t(1));
            const Landing& landing = landings[0];
            QVERIFY(std::abs(landing.time - std::sqrt(2.0 / g)) < 2e-3);
            QVERIFY(std::abs(landing.speed() - std::sqrt(2.0 * g)) < 2e-3 * g);
            QVERIFY(landing.velocity.y() < 0.0);
            QVERIFY(std::abs(landing.place.y()) < 1e-3);
            QCOMPARE(landing.part, 7u);
            QCOMPARE(landing.collider, 9u);
        }
    }

    // Of two masses of a part, one of which is thrown to the side, the lower one lands first; then
    // the part has landed.
    void landsWithItsLowest()
    {
        System system = dropped(0.0);
        addParticle(system, {2.0, 0.5, 0.0}, 1.0);
        system.start.velocity[1] = {3.0, 0.0, 0.0};
        system.key.clear(); // they are counted anew
        finish(system);
        const std::vector<Landing> landings = landingsOf(system, 3.0);
        QCOMPARE(landings.size(), std::size_t(1));
        QCOMPARE(landings[0].particle, system.key[1]);
        const double fall = std::sqrt(1.0 / g); // s, from half a metre
        QVERIFY(std::abs(landings[0].speed() - std::hypot(3.0, g * fall)) < 2e-3 * g);
        QVERIFY(std::abs(landings[0].place.x() - 2.0 - 3.0 * fall) < 6e-3);
    }

    // What lies on the ground from the first step on has not landed.
    void restsFromTheStart()
    {
        System system = dropped(0.0);
        system.start.position[0].y() = 0.0;
        QVERIFY(landingsOf(system, 0.5).empty());
    }

    // The report names the payload by its group and tells the speed of the free fall.
    void landingIsReported()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath("drop.ripstop.json");
        Scene scene;
        scene.items.push_back({takeId(scene), Collider{.name = "meadow"}});
        Part part{"drop"};
        part.particles = {{.id = takeId(scene), .position = {1.0, 2.0, 0.0}, .mass = 3.0}};
        const Id particle = part.particles[0].id;
        scene.items.push_back({takeId(scene), part});
        scene.items.push_back({takeId(scene), Group{"payload", {particle}}});
        QVERIFY(!saveScene(scene, file.toStdString()));
        const QStringList words{"run", file, "--seconds", "1"};
        const QJsonArray landings =
            call(words + QStringList{"--json"}).json()["landings"].toArray();
        QCOMPARE(landings.size(), 1);
        const QJsonObject landing = landings[0].toObject();
        QCOMPARE(landing["name"].toString(), QString("payload"));
        QCOMPARE(landing["collider"].toString(), QString("meadow"));
        QVERIFY(std::abs(landing["speed"].toDouble() - std::sqrt(4.0 * g)) < 2.0 * g / 240.0);
        QVERIFY(call(words).out.contains("payload on meadow, at 1, "));
    }

    // A mass on an elastic line, w^2 = k / m = 25 /s^2, let go where the line is stretched by three
    // times what the weight does: s(t) = x0 (1 + 2 cos w t) ends at w t = 2 pi / 3 with the speed
    // 2 x0 w sin(2 pi / 3), and the line is taut again when that has come back down, 2 v / g later.
    void elasticLine()
    {
        constexpr double w = 5.0;    // 1/s
        constexpr double k = w * w;  // N/m, for 1 kg
        constexpr double x0 = g / k; // m
        System system = heavySystem(1e-3);
        addPin(system, Vec3::Zero());
        addParticle(system, {0.0, -1.0 - 3.0 * x0, 0.0}, 1.0);
        addSpring(system, 0, 1, 1.0, k).resists = Resists::Tension;
        finish(system);
        const auto events = eventsOf(std::move(system), 1.4);
        const double slack = 2.0 * std::numbers::pi / 3.0 / w;
        const double speed = 2.0 * x0 * w * std::sin(2.0 * std::numbers::pi / 3.0);
        QCOMPARE(events.size(), std::size_t(2));
        QCOMPARE(events[0].kind, RunEvent::Kind::Slack);
        QCOMPARE(events[1].kind, RunEvent::Kind::Taut);
        QVERIFY(std::abs(events[0].time - slack - SlackWatch::outlast) < 0.01);
        QVERIFY(std::abs(events[1].time - slack - 2.0 * speed / g - SlackWatch::outlast) < 0.02);
    }

    // The line is loose until the mass has fallen by the half metre that it is too long, and then
    // holds it without an end to being taut.
    void snapsTight()
    {
        System system = heavySystem(1e-3);
        system.solver = Solver::GaussSeidel;
        addPin(system, Vec3::Zero());
        addParticle(system, {0.0, -0.5, 0.0}, 1.0);
        addRod(system, 0, 1, 1.0).resists = Resists::Tension;
        finish(system);
        const auto events = eventsOf(std::move(system), 3.0);
        QCOMPARE(events.size(), std::size_t(1));
        QCOMPARE(events[0].kind, RunEvent::Kind::Taut);
        QVERIFY(std::abs(events[0].time - std::sqrt(1.0 / g) - SlackWatch::outlast) < 0.01);
    }

    // Chains are one line from one end that holds to the other; what resists compression as well,
    // what is fabric and what hangs loose is none.
    void whatLinesAre()
    {
        System system = heavySystem(1e-3);
        for (int i = 0; i < 6; ++i)
            if (i == 0 || i == 3)
                addPin(system, {double(i), 0.0, 0.0});
            else
                addParticle(system, {double(i), 0.0, 0.0}, 0.1);
        const auto rod = [&](int a, int b, Resists resists) {
            addRod(system, a, b, 1.0).resists = resists;
        };
        rod(0, 1, Resists::Tension);
        rod(2, 1, Resists::Tension);
        rod(2, 3, Resists::Tension);
        rod(3, 4, Resists::Both);
        rod(4, 5, Resists::Tension);
        finish(system);
        auto lines = linesOf(system);
        QCOMPARE(lines.size(), std::size_t(2)); // 0 to 3, and 4 to 5 where 0.1 kg hangs
        QCOMPARE(lines[0].links.size(), std::size_t(3));
        QCOMPARE(lines[0].weight, 0.2 * g);
        QCOMPARE(lines[1].links.size(), std::size_t(1));

        System loose = heavySystem(1e-3); // a rope that hangs from one end
        addPin(loose, Vec3::Zero());
        for (int i = 0; i < 5; ++i) {
            addParticle(loose, {i + 1.0, 0.0, 0.0}, 0.1);
            addRod(loose, i, i + 1, 1.0).resists = Resists::Tension;
        }
        finish(loose);
        QVERIFY(linesOf(loose).empty());
    }

    // By the terminal: the table of a run, the events of its recording and of another number of
    // threads are the same.
    void sameEverywhere()
    {
        const QTemporaryDir folder;
        const QString recording = folder.filePath("a.ripstop-run");
        const auto table = [&](const char* name, QStringList more) {
            const QString file = folder.filePath(name);
            QStringList words{"run",       SCENES_DIR "/sheet_on_boxes.ripstop.json",
                              "--seconds", "0.5",
                              "--events",  file};
            const Outcome outcome = call(words + more);
            if (outcome.exitCode != 0)
                qWarning("%s", qPrintable(outcome.error));
            QFile text(file);
            return text.open(QIODevice::ReadOnly) ? text.readAll() : QByteArray("none");
        };
        const QByteArray alone = table("alone.csv", {});
        QCOMPARE(table("threads.csv", {"--threads", "2"}), alone);
        QCOMPARE(table("recorded.csv", {"--record", recording}), alone);
        QVERIFY(alone.startsWith("time (s),step,event,subject,count\n"));
        const QJsonArray listed =
            call({"info", recording, "--json"}).json()["event_list"].toArray();
        QCOMPARE(listed.size(), alone.count('\n') - 1);
        QVERIFY(!listed.isEmpty());
    }

    // Recordings of the version before had events without colliders.
    void opensOlderRecordings()
    {
        const auto opened = openRecording(SOURCE_DIR "/tests/model/golden/pendulum_v1.ripstop-run");
        QVERIFY2(opened, opened ? "" : opened.message().english().c_str());
        QVERIFY(opened->damage.empty());
        QCOMPARE(opened->recording->lastStep(), std::int64_t(24));
    }
};

const RegisteredTest registered("test_events", runWithCore<TestEvents>);

} // namespace ripstop::test_events
#include "test_events.moc"
