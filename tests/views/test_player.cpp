// The player: simulation on its own thread as the window sees it (document/player.h).
//
// Stages: play, step and reset of a falling pair, whose fall is known exactly; edits that reach a
// run and those that wait for the reset; scenes that cannot run and their cure; the stop after an
// explosion; controls; and many edits with an early end, for the thread sanitizer.
#include "document/document.h"
#include "document/player.h"
#include "simulation/simulation.h"
#include "small_scenes.h"
#include "views/run_with_widgets.h"

#include "compile/compile.h"

#include <QSignalSpy>
#include <QtTest>

namespace ripstop::test_player {

namespace {

constexpr double g = 9.80665; // m/s^2

bool shown(const Player& player, double time)
{
    return player.frame() && !player.isPlaying() && std::abs(player.frame()->time - time) < 1e-9;
}

double height(const Player& player, std::uint32_t particle)
{
    const Frame& frame = *player.frame();
    const auto& ids = frame.layout->particleId;
    return frame.position[std::size_t(std::find(ids.begin(), ids.end(), particle) - ids.begin())]
        .y();
}

} // namespace

class TestPlayer : public QObject
{
    Q_OBJECT

private slots:
    void playsUntilExactly_data()
    {
        QTest::addColumn<double>("time"); // s
        QTest::addColumn<qint64>("step"); // of 0.01 s
        QTest::newRow("no time at all") << 0.0 << qint64(0);
        QTest::newRow("one step") << 0.01 << qint64(1);
        QTest::newRow("a whole number of steps") << 1.5 << qint64(150);
        QTest::newRow("rounded down") << 0.1234 << qint64(12);
        QTest::newRow("rounded up") << 0.1266 << qint64(13);
    }

    void playsUntilExactly()
    {
        QFETCH(double, time);
        QFETCH(qint64, step);
        Document document;
        Player player(document);
        document.replace(fallingPair());
        player.playUntil(time); // before anything is compiled: it has to wait for that
        QVERIFY(player.isPlaying());
        QTRY_VERIFY(player.frame() && !player.isPlaying());
        QCOMPARE(qint64(player.frame()->step), step);
        QTest::qWait(50);
        QCOMPARE(qint64(player.frame()->step), step); // and stays there

        // the frame has the same bits as a simulation without a window
        Simulation simulation(*compile(document.scene()));
        simulation.runUntil(time);
        const auto expected = simulation.frame();
        QCOMPARE(expected->step, player.frame()->step);
        QVERIFY(expected->position == player.frame()->position);
    }

    // Semi-implicit Euler falls by g h^2 n (n + 1) / 2 in n steps, exactly.
    void stepsOneByOne()
    {
        Document document;
        Player player(document);
        document.replace(fallingPair());
        for (int i = 0; i < 3; ++i)
            player.step();
        QTRY_VERIFY(player.frame() && player.frame()->step == 3);
        QVERIFY(std::abs(height(player, 2) - (10.0 - g * 1e-4 * 6.0)) < 1e-12);
        QVERIFY(!player.isPlaying());
    }

    void resetReturnsToTheStart()
    {
        Document document;
        Player player(document);
        document.replace(fallingPair());
        player.playUntil(0.5);
        QTRY_VERIFY(shown(player, 0.5));
        QVERIFY(height(player, 3) < 9.0);
        player.reset();
        QTRY_VERIFY(shown(player, 0.0));
        QCOMPARE(height(player, 3), 10.0);
        QCOMPARE(player.frame()->velocity[1].norm(), 0.0);

        // a playUntil() that was passed long ago does not come back
        player.playUntil(0.5);
        QTRY_VERIFY(shown(player, 0.5));
        player.playUntil(0.2);
        QTRY_VERIFY(!player.isPlaying());
        player.reset();
        QTRY_VERIFY(shown(player, 0.0));
        QTest::qWait(60);
        QVERIFY(shown(player, 0.0));
    }

    // Weightless until an edit while it plays: then it falls. The motion goes on.
    void editReachesTheRun()
    {
        Scene scene = fallingPair();
        scene.settings.gravity = Vec3::Zero();
        scene.items[0].item = [&] {
            Part part = std::get<Part>(scene.items[0].item);
            for (Particle& particle : part.particles)
                particle.velocity = Vec3(2, 0, 0); // m/s
            return part;
        }();

        Document document;
        Player player(document);
        document.replace(scene);
        player.play();
        QTRY_VERIFY(player.frame() && player.frame()->step > 5);
        QCOMPARE(height(player, 2), 10.0);
        const std::uint64_t run = player.frame()->run;
        const std::int64_t before = player.frame()->step;

        document.push(setValue(scene, settingsId, "gravity", Vec3(0, -g, 0)));
        QTRY_VERIFY(height(player, 2) < 9.9);
        player.pause();
        QCOMPARE(player.frame()->run, run);
        QVERIFY(player.frame()->step > before);
        // the sideways motion never stopped
        const double expected = 2.0 * player.frame()->time;
        QVERIFY(std::abs(player.frame()->position[0].x() - expected) < 1e-9);

        document.history().undo();
        QTRY_VERIFY(player.frame()->generation > 2);
    }

    // A spring at rest is stretched by m g / k.
    void massReachesTheRun()
    {
        Scene scene = fallingPair();
        Part part = std::get<Part>(scene.items[0].item);
        part.particles[0].pinned = true;
        part.particles[1].position = Vec3(0, 9, 0);
        part.links[0].kind = LinkKind::Spring;
        part.links[0].stiffness = 100.0; // N/m
        part.links[0].damping = 10.0;    // N s/m
        scene.items[0].item = part;

        Document document;
        Player player(document);
        document.replace(scene);
        player.setSpeed(0.0); // as fast as it can
        player.play();
        const double light = 9.0 - 0.5 * g / 100.0;
        QTRY_VERIFY(player.frame() && std::abs(height(player, 3) - light) < 1e-6);
        document.push(setValue(scene, Id{3}, "mass", 2.0));
        const double heavy = 9.0 - 2.0 * g / 100.0;
        QTRY_VERIFY(std::abs(height(player, 3) - heavy) < 1e-6);
        document.history().undo();
        QTRY_VERIFY(std::abs(height(player, 3) - light) < 1e-6);
    }

    void startingPlacesWaitForTheReset()
    {
        Document document;
        Player player(document);
        document.replace(fallingPair());
        QTRY_VERIFY(shown(player, 0.0));

        // a new place is shown at once while nothing has moved
        document.push(setValue(document.scene(), Id{2}, "position", Vec3(0, 20, 0)));
        QTRY_COMPARE(height(player, 2), 20.0);

        player.playUntil(0.1);
        QTRY_VERIFY(shown(player, 0.1));
        const double reached = height(player, 2);
        document.push(setValue(document.scene(), Id{2}, "position", Vec3(0, 30, 0)));
        QTest::qWait(60);
        QVERIFY(shown(player, 0.1));
        QCOMPARE(height(player, 2), reached);
        player.reset();
        QTRY_VERIFY(shown(player, 0.0));
        QCOMPARE(height(player, 2), 30.0);
    }

    void namesDoNotDisturb()
    {
        Document document;
        Player player(document);
        document.replace(fallingPair());
        QTRY_VERIFY(player.frame());
        const std::uint64_t generation = player.frame()->generation;
        document.push(setValue(document.scene(), Id{5}, "name", std::string("silk")));
        player.step();
        QTRY_COMPARE(player.frame()->step, 1);
        QCOMPARE(player.frame()->generation, generation);
    }

    void replacingPausesAndStartsOver()
    {
        Document document;
        Player player(document);
        document.replace(fallingPair());
        player.play();
        QTRY_VERIFY(player.frame() && player.frame()->step > 2);
        document.replace(oneOfEverything());
        QVERIFY(!player.isPlaying());
        QVERIFY(!player.frame()); // the old one says nothing about the new scene
        QTRY_VERIFY(shown(player, 0.0));
        QCOMPARE(player.frame()->position.size(), std::size_t(3));
    }

    void massOfNothingIsAProblem()
    {
        Document document;
        Player player(document);
        document.replace(fallingPair());
        QSignalSpy stops(&player, &Player::stopped);
        player.play();
        QTRY_VERIFY(player.frame() && player.frame()->step > 2);
        document.push(setValue(document.scene(), Id{3}, "mass", 0.0));
        QTRY_VERIFY(!player.problem().isEmpty());
        QVERIFY(player.problem().contains("Particle 3"));
        QVERIFY(!player.isPlaying());
        QCOMPARE(stops.count(), 1);
        QCOMPARE(stops[0][1].toUInt(), 3u);

        player.play(); // not silently useless
        QVERIFY(!player.isPlaying());
        QCOMPARE(stops.count(), 2);

        document.history().undo();
        QTRY_VERIFY(player.problem().isEmpty());
        const std::int64_t step = player.frame()->step;
        player.play();
        QTRY_VERIFY(player.frame()->step > step); // it goes on where it was
        player.playUntil(0.3);
    }

    // The problem of before the cure does not refuse what is asked for while the cure compiles.
    void playsAtOnceAfterTheCure()
    {
        Document document;
        Player player(document);
        document.replace(fallingPair());
        document.push(setValue(document.scene(), Id{3}, "mass", 0.0));
        QTRY_VERIFY(!player.problem().isEmpty());

        QSignalSpy stops(&player, &Player::stopped);
        document.history().undo();
        QCoreApplication::sendPostedEvents(&player); // the compile is on its way
        player.play();
        QVERIFY(player.isPlaying());
        QTRY_VERIFY(player.frame() && player.frame()->step > 2);
        QVERIFY(player.isPlaying());
        QCOMPARE(stops.count(), 0);
    }

    // An explicit spring far above its stable time step explodes; the run stops and says so once.
    void explosionStops()
    {
        Scene scene = fallingPair();
        Part part = std::get<Part>(scene.items[0].item);
        part.links[0].kind = LinkKind::Spring;
        part.links[0].stiffness = 1e7; // N/m
        part.particles[1].position = Vec3(1.01, 10, 0);
        scene.items[0].item = part;
        scene.settings.integrator = Integrator::ExplicitEuler;

        Document document;
        Player player(document);
        document.replace(scene);
        QSignalSpy stops(&player, &Player::stopped);
        player.playUntil(10.0);
        QTRY_COMPARE(stops.count(), 1);
        QVERIFY(!player.isPlaying());
        QVERIFY(!stops[0][0].toString().isEmpty());
        QTest::qWait(50);
        QCOMPARE(stops.count(), 1);
        player.play();
        QCOMPARE(stops.count(), 2);
        QVERIFY(!player.isPlaying());

        document.push(setValue(scene, Id{4}, "stiffness", 10.0));
        document.push(setValue(scene, settingsId, "integrator", std::string("verlet")));
        player.reset();
        player.playUntil(0.2);
        QTRY_VERIFY(shown(player, 0.2));
        QCOMPARE(stops.count(), 2);
    }

    void controlsStayInTheirLimits()
    {
        Document document;
        Player player(document);
        document.replace(fallingPair());
        player.nudge(Id{7}, 1);
        player.step();
        QTRY_VERIFY(player.frame() && player.frame()->step == 1);
        QCOMPARE(player.frame()->inputCommand[0], 0.1);
        player.nudge(Id{7}, 5);
        player.step();
        QTRY_COMPARE(player.frame()->step, 2);
        QCOMPARE(player.frame()->inputCommand[0], 0.25);
        player.nudge(Id{7}, -1);
        player.step();
        QTRY_COMPARE(player.frame()->step, 3);
        QCOMPARE(player.frame()->inputCommand[0], 0.15);
        player.nudge(Id{5}, 1); // a material is no control
        player.reset();
        player.step();
        QTRY_COMPARE(player.frame()->step, 1);
        QCOMPARE(player.frame()->inputCommand[0], 0.0);
    }

    // Hundreds of edits behind each other: the newest wins, and the player can go at any time.
    void manyEditsAndAnEarlyEnd()
    {
        Document document;
        document.replace(fallingPair());
        {
            Player player(document);
            player.play();
            for (int i = 0; i < 300; ++i) {
                document.push(setValue(document.scene(), Id{3}, "mass", 0.5 + i * 0.001));
                if (i % 50 == 0)
                    QTest::qWait(2);
            }
        }
        Player player(document);
        player.playUntil(0.1);
        QTRY_VERIFY(shown(player, 0.1));
    }
};

const RegisteredTest registered("test_player", runWithWidgets<TestPlayer>);

} // namespace ripstop::test_player
#include "test_player.moc"
