// The sample scenes: each loads, is what its builder makes, runs 20 s, and shows what it is for.
// Those that fly are in test_craft.cpp.
//
// Stages: every sample equals what its builder and scenes/make make; then the samples that a
// formula or a measurement is known for, each in a test of its own: strips, sheets that tear,
// pendulum, heavy load, sheets on bodies, curtain, flag; at last every sample is flown to its end.
#include "model/sample_scenes.h"
#include "registered_test.h"

#include "builders/builder.h"
#include "check/check.h"
#include "measure/diagnostics.h"
#include "shapes/cylinder.h"
#include "verify/tear_sheets.h"

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <limits>
#include <numbers>

namespace ripstop::test_scenes {

class TestScenes : public QObject
{
    Q_OBJECT

private slots:
    // scenes/README.md has a table with a row for each scene, and no other rows.
    void listsNameEveryScene()
    {
        QFile page(QStringLiteral(SCENES_DIR "/README.md"));
        QVERIFY(page.open(QIODevice::ReadOnly));
        QStringList lines = QString::fromUtf8(page.readAll()).split('\n');
        while (!lines.isEmpty() && !lines.front().startsWith("| scene |"))
            lines.removeFirst();
        QStringList listed;
        const QRegularExpression name("`([a-z0-9_]+)`");
        for (const QString& line : lines.mid(2)) { // below the titles
            if (!line.startsWith('|'))
                break;
            auto found = name.globalMatch(line.section('|', 1, 1));
            while (found.hasNext())
                listed << found.next().captured(1);
        }
        listed.sort();
        QCOMPARE(listed, sampleNames());
    }

    // Whoever runs it after a change of a builder would else undo what was put into a file by hand.
    void areWhatTheScriptMakes()
    {
        const QTemporaryDir made;
        const QString script = made.filePath("make");
        QVERIFY(QFile::copy(QStringLiteral(SCENES_DIR "/make"), script));
        for (const char* const file : {"printed_flag.png", "passing_front.csv"})
            QVERIFY(QFile::copy(QStringLiteral(SCENES_DIR "/") + file, made.filePath(file)));
        QProcess shell;
        shell.start("sh", {script, CLI_PROGRAM});
        QVERIFY(shell.waitForFinished(120'000));
        QVERIFY2(shell.exitCode() == 0, shell.readAllStandardError());
        const auto bytesOf = [](const QString& path) {
            QFile file(path);
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        for (const QString& name : sampleNames()) {
            const QString file = name + ".ripstop.json";
            QVERIFY2(bytesOf(made.filePath(file)) == bytesOf(SCENES_DIR "/" + file),
                     qPrintable(file + " is not what scenes/make makes"));
        }
    }

    void isWhatItsBuilderMakes_data() { runs_data(); }

    // But for what is painted. If this fails after a change of a builder, run scenes/make.
    void isWhatItsBuilderMakes()
    {
        QFETCH(QString, name);
        const Scene scene = sample(name);
        const Part& part = partOf(scene);
        const Builder* builder = findBuilder(part.builder);
        QVERIFY(builder);
        const Result<Scene> again = build(*builder, part.parameters);
        QVERIFY(bool(again));
        Part unpainted = part;
        for (Panel& panel : unpainted.panels)
            panel.strengthFactor = 1.0;
        QVERIFY(partOf(*again) == unpainted);
    }

    // Validation 1.4, 1.5, 1.6.
    void counts_data()
    {
        QTest::addColumn<int>("particles");
        QTest::addColumn<int>("rods");
        QTest::addColumn<int>("panels");
        QTest::newRow("hang_glider") << 49 << 198 << 64;
        QTest::newRow("delta_kite") << 152 << 458 << 221;
        QTest::newRow("parachute") << 145 + 72 + 1 + 2 << 408 + 96 + 48 << 264;
        QTest::newRow("stiffened_rod") << 6 << 11 << 0;
    }

    void counts()
    {
        const Scene scene = sample(QTest::currentDataTag());
        QTEST(int(partOf(scene).particles.size()), "particles");
        QTEST(int(partOf(scene).links.size()), "rods");
        QTEST(int(partOf(scene).panels.size()), "panels");
    }

    // Peirce 1930: whatever the fabric, twice its bending length droops to 41.5 degrees; the heavy
    // elastica says 41.49.
    void stripsDroopToTheRamps()
    {
        Simulation& simulation = m_flights.of("bending_test", 0.0);
        QVERIFY(simulation.runUntil(6.0));
        for (const char* fabric : {"gray_interlock", "denim_11oz", "royal_target"}) {
            const double slope = -probe(simulation, std::string(fabric) + " slope");
            QVERIFY2(std::abs(slope - 41.49) < 0.5,
                     qPrintable(QString("%1: %2 degrees").arg(fabric).arg(slope)));
        }
    }

    // Springs break above a strain of 0.3 and nowhere below; the first one that breaks is at the
    // end of the slit, where the pull gathers.
    void sheetTears()
    {
        const Scene scene = sample("torn_sheet");
        Simulation& simulation = m_flights.of("torn_sheet", 0.0);
        QVERIFY(simulation.runUntil(5.0));
        const std::vector<State::Tear>& tears = simulation.state().tears;
        QVERIFY(!tears.empty());
        QCOMPARE(probe(simulation, "torn"), double(tears.size()));
        for (const State::Tear& tear : tears)
            QVERIFY(tear.strain > 0.3);
        QVERIFY(tears.front().time > 1.0);

        const Parameters& made = partOf(scene).parameters;
        const double slitEnd = made.at("level") - made.at("height") * (1.0 - made.at("slit"));
        QVERIFY(std::abs(tears.front().place.y() - slitEnd) < 0.1 * made.at("height"));
    }

    // It breaks where the sheet of panels that vanish does, and has all its panels afterwards, each
    // of its area but for what the springs give way, in pieces.
    void sheetSplits()
    {
        Simulation& simulation = m_flights.of("split_sheet", 0.0);
        const std::size_t particles = simulation.system().key.size();
        const double mass = totalMass(simulation.system());
        const double area = fabricArea(simulation.system(), simulation.state());
        QVERIFY(simulation.runUntil(20.0));
        const System& system = simulation.system();
        const State& state = simulation.state();
        QVERIFY(state.tears.front().time > 1.0);
        QVERIFY(state.splits.size() >= 10); // rows above the slit
        QCOMPARE(system.key.size(), particles + state.splits.size());
        QCOMPARE(std::count(state.panelGone.begin(), state.panelGone.end(), 1), 0);
        QVERIFY(std::abs(totalMass(system) - mass) < 1e-12);
        QVERIFY(std::abs(fabricArea(system, state) / area - 1.0) < 0.05);
        QVERIFY(piecesOf(system, state) >= 2);
    }

    // Panels that carry the pull of ripstop tear above its strength of 8 kN/m and nowhere below,
    // first at the end of the slit, and from there to the upper edge; they are all there
    // afterwards.
    void ripstopTears()
    {
        Simulation& simulation = m_flights.of("tearing_sheet", 0.0);
        const std::size_t particles = simulation.system().key.size();
        const double mass = totalMass(simulation.system());
        QVERIFY(simulation.runUntil(3.0));
        const System& system = simulation.system();
        const State& state = simulation.state();
        QVERIFY(!state.tears.empty());
        QCOMPARE(probe(simulation, "torn"), double(state.tears.size()));
        for (const State::Tear& tear : state.tears)
            QVERIFY(tear.force > 8000.0);
        const Parameters made = partOf(sample("tearing_sheet")).parameters;
        const double slitEnd = made.at("level") - made.at("height") * (1.0 - made.at("slit"));
        QVERIFY(std::abs(state.tears.front().place.y() - slitEnd) < 0.1 * made.at("height"));
        QCOMPARE(system.key.size(), particles + state.splits.size());
        QCOMPARE(std::count(state.panelGone.begin(), state.panelGone.end(), 1), 0);
        QVERIFY(std::abs(totalMass(system) - mass) < 1e-12);
        QVERIFY(piecesOf(system, state) >= 2);
    }

    // Threads of 0.5 m, of springs of 0.025 m and 100 N/m, drawn at v = 0.05 m/s to a strain of
    // 0.3: 3 s and 0.75 N. A wave of v / c, c = sqrt(100 N/m / 0.25 kg/m^2) = 20 m/s, runs to and
    // fro and may add its height twice, which is 0.05 s of drawing; on the mean no thread can be
    // late. The halves recoil with w = pi c / (2 0.25 m) = 126/s, damped at nu w^2 / (2 k) = 0.8/s,
    // and are still after 17 s, where a whole thread would pull with 2.5 N.
    void stripTears()
    {
        Simulation& simulation = m_flights.of("tear_test", 0.0);
        const double timeStep = simulation.system().timeStep;
        QVERIFY(simulation.runUntil(20.0));
        const std::vector<State::Tear>& tears = simulation.state().tears;
        QVERIFY(tears.size() >= 5); // each thread
        const State::Tear& first = tears.front();
        QVERIFY(first.time > 2.95 && first.time < 3.0 + timeStep);
        QVERIFY(std::abs(first.force - 0.75) < 0.01 * 0.75);
        QVERIFY(std::abs(first.energy - 0.5 * 0.75 * 0.0075) < 0.02 * 0.5 * 0.75 * 0.0075);
        for (std::size_t i = 1; i < tears.size(); ++i) // one in a step
            QVERIFY(std::ceil(tears[i].time / timeStep - 1e-6)
                    > std::ceil(tears[i - 1].time / timeStep - 1e-6));
        const auto frame = simulation.frame();
        for (const double tension : frame->tension) // two halves
            QVERIFY(std::abs(tension) < 0.01 * 0.75);
    }

    // T = 4 sqrt(L / g) K(sin(a / 2)) = 2.04134 s for 1 m and 30 degrees: after whole periods the
    // bob is back where it was let go. 1 % of a period off would be 0.06 rad of phase.
    void pendulumKeepsTime()
    {
        const double period = 2.0413384658583684;
        Simulation& simulation = m_flights.of("pendulum", 0.0);
        int turns = 0;
        double last = 0.0;
        double time = 0.0;
        double before = simulation.state().velocity.back().x();
        while (turns < 8 && time < 20.0) {
            QVERIFY(simulation.step());
            time = simulation.state().time;
            const double now = simulation.state().velocity.back().x();
            if (before < 0.0 && now >= 0.0) // outermost on the left: half a period later
                ++turns, last = time;
            before = now;
        }
        QCOMPARE(turns, 8);
        QVERIFY2(std::abs(last / (7.5 * period) - 1.0) < 0.005, qPrintable(QString::number(last)));
    }

    // Let go at 20 degrees, 65.05 kg (the line hangs on by half) pull m g (3 - 2 cos 20) at the
    // lowest point, and no rod of the line is stretched by as much as 0.1 %.
    void heavyLoadIsHeld()
    {
        Simulation& simulation = m_flights.of("heavy_load", 0.0);
        const double expected =
            65.05 * 9.80665 * (3.0 - 2.0 * std::cos(20.0 * std::numbers::pi / 180.0));
        double largest = 0.0;
        double strain = 0.0;
        while (simulation.state().time < 7.0) {
            QVERIFY(simulation.runUntil(simulation.state().time + 0.05));
            const auto frame = simulation.frame();
            largest =
                std::max(largest, *std::max_element(frame->tension.begin(), frame->tension.end()));
            for (const double one : frame->strain)
                strain = std::max(strain, std::abs(one));
        }
        QVERIFY2(std::abs(largest / expected - 1.0) < 0.02, qPrintable(QString::number(largest)));
        QVERIFY2(strain < 0.001, qPrintable(QString::number(strain)));
    }

    // EA = 100 kN: (M + m / 2) g L / (EA) of 65 kg and 0.5 kg on 10 m; the ends come first.
    void stretchedLineIsAsLongAsItsStiffnessSays()
    {
        Simulation& simulation = m_flights.of("stretched_line", 0.0);
        QVERIFY(simulation.runUntil(18.0));
        const auto& position = simulation.state().position;
        const double longer = Vec3(position[0] - position[1]).norm() - 10.0;
        const double expected = (65.0 + 0.5 * 0.5) * 9.80665 * 10.0 / 1e5;
        QVERIFY2(std::abs(longer / expected - 1.0) < 0.01, qPrintable(QString::number(longer)));
        QVERIFY(simulation.frame()->accuracy.isMet());
    }

    void sheetsLieOnTop_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"cloth_over_cylinder", "sheet_on_boxes", "sheet_on_terrain"})
            QTest::newRow(name) << QString(name);
    }

    // Ten seconds after it was let go, no particle is nearer to a cylinder, to a box or to the
    // ground than the thickness says, and the sheet rests.
    void sheetsLieOnTop()
    {
        QFETCH(QString, name);
        Simulation& simulation = m_flights.of(name, 0.0);
        for (double time = 0.5; time <= 10.0; time += 0.5) {
            QVERIFY(simulation.runUntil(time));
            for (const Obstacle& obstacle : simulation.system().obstacles)
                for (const Vec3& x : simulation.state().position) {
                    const Vec3 own = obstacle.turn.transpose() * (x - obstacle.position);
                    double room = x.y();
                    if (obstacle.shape == ColliderShape::Box)
                        room = nearestOnBox(0.5 * obstacle.size, own).distance;
                    if (obstacle.shape == ColliderShape::Cylinder)
                        room = nearestOnCylinder({obstacle.radius, 0.5 * obstacle.size.y()}, own)
                                   .distance;
                    if (obstacle.shape == ColliderShape::HeightField) {
                        const Ground ground = groundAt(*obstacle.grid, obstacle.size, own);
                        room = (own.y() - ground.height) * ground.normal.y();
                    }
                    QVERIFY2(room > obstacle.thickness - 1e-6, qPrintable(QString::number(room)));
                }
        }
        QVERIFY2(probe(simulation, "speed") < 0.01, "and it rests");
        QVERIFY(simulation.state().position[0].y() < 0.9); // it came down
    }

    // A ball that is solved together with real cloth does not stretch it: a sheet of 14 cells that
    // lies on a ball weighs 0.46 N, which strains a strip of 10 cm of it by 0.01 %, and the impact
    // with 2 m/s by a few times that. Put right after the solve, contact strained it by 1.5 %.
    void ripstopLiesOnTheBall()
    {
        Simulation& simulation = m_flights.of("ripstop_over_ball", 0.0);
        QVERIFY(simulation.runUntil(4.0));
        QVERIFY2(probe(simulation, "max strain") < 1e-3,
                 qPrintable(QString::number(probe(simulation, "max strain"))));
        QVERIFY(simulation.frame()->accuracy.isMet());
        const Vec3 top(0.0, 0.8625, 0.5); // of the ball
        double nearest = 1.0;
        for (const Vec3& x : simulation.state().position)
            nearest = std::min(nearest, (x - top).norm());
        QVERIFY2(nearest < 0.05, "it is still on the ball");
    }

    // Rings slide along their rail and nowhere else, and the curtain is drawn together.
    void curtainIsDrawn()
    {
        Simulation& simulation = m_flights.of("curtain", 0.0);
        const std::vector<GuidedParticle> rings = simulation.system().guided;
        QVERIFY(rings.size() >= 5);
        const State before = simulation.state();
        QVERIFY(simulation.runUntil(6.0));
        double left = 1e9, right = -1e9;
        for (const GuidedParticle& ring : rings) {
            const auto p = std::size_t(ring.particle);
            const Vec3 x = simulation.state().position[p];
            QCOMPARE(x.y(), before.position[p].y());
            QCOMPARE(x.z(), before.position[p].z());
            left = std::min(left, x.x());
            right = std::max(right, x.x());
        }
        QVERIFY2(right - left < 0.8, qPrintable(QString::number(right - left)));
    }

    // Waves on it run slower than the wind, so that they grow: the flag must not come to rest.
    void flagFlutters()
    {
        Simulation& simulation = m_flights.of("flag", 0.0);
        QVERIFY(simulation.runUntil(10.0));
        double left = 0.0;
        double right = 0.0;
        while (simulation.state().time < 20.0) {
            QVERIFY(simulation.step());
            left = std::min(left, simulation.state().position.back().z());
            right = std::max(right, simulation.state().position.back().z());
        }
        qInfo("the corner swings %.2f m", right - left);
        QVERIFY(right - left > 0.05);
    }

    // Last, as these flights go on where the tests above have left them.
    void runs_data()
    {
        QTest::addColumn<QString>("name");
        for (const QString& name : sampleNames())
            QTest::newRow(qPrintable(name)) << name;
    }

    void runs()
    {
        QFETCH(QString, name);
        const Scene scene = sample(name);
        QVERIFY(!hasErrors(problemsOf(scene)));
        QVERIFY(!scene.settings.title.empty());

        Simulation& simulation = m_flights.of(name, std::numeric_limits<double>::infinity());
        const bool whole = simulation.runUntil(20.0);
        QVERIFY2(whole, whole ? "" : simulation.trouble()->message.english().c_str());
        for (const Vec3& position : simulation.state().position)
            QVERIFY(position.allFinite());
    }

private:
    SharedFlights m_flights;
};

const RegisteredTest registered("test_scenes", runPlain<TestScenes>);

} // namespace ripstop::test_scenes
#include "test_scenes.moc"
