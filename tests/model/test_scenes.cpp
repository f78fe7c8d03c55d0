// The sample scenes: each loads, is what its builder makes, and runs 20 s; the craft fly.
#include "builders/builder.h"
#include "compile/compile.h"
#include "io/scene_file.h"
#include "run/simulation.h"
#include "scene/check.h"

#include <Eigen/Geometry>
#include <QDir>
#include <QtTest>

#include <numbers>
#include <set>

#include <cmath>

using namespace ripstop;

namespace {

Scene sample(const QString& name)
{
    const Result<Scene> scene =
        readScene((QStringLiteral(SCENES_DIR) + "/" + name + ".ripstop.json").toStdString());
    if (!scene)
        qFatal("%s", scene.message().c_str());
    return *scene;
}

Simulation started(const QString& name)
{
    const auto system = compile(sample(name));
    if (!system)
        qFatal("%s", system.message().c_str());
    return Simulation(*system);
}

double probe(const Simulation& simulation, std::string_view name)
{
    const auto frame = simulation.frame();
    for (std::size_t i = 0; i < frame->probe.size(); ++i)
        if (frame->layout->probes[i].name == name)
            return frame->probe[i];
    qFatal("no such probe");
}

const Part& partOf(const Scene& scene)
{
    const Part* found = nullptr;
    forEachPart(scene, [&](Id, const Part& part) { found = &part; });
    return *found;
}

QStringList sampleNames()
{
    QStringList names;
    const QDir folder(QStringLiteral(SCENES_DIR));
    for (const QString& file : folder.entryList({"*.ripstop.json"}, QDir::Files, QDir::Name))
        names << file.chopped(int(sceneExtension.size()));
    return names;
}

} // namespace

class TestScenes : public QObject
{
    Q_OBJECT

private slots:
    void allAreThere()
    {
        const QStringList names = sampleNames();
        for (const char* name :
             {"bending_test", "cloth", "delta_kite", "flag", "glider_over_hills", "glider_polar",
              "hang_glider", "heavy_load", "parachute", "pendulum", "rope", "self_contact",
              "sheet_on_boxes", "sheet_on_terrain", "split_sheet", "stiffened_rod", "tear_test",
              "torn_sheet"})
            QVERIFY2(names.contains(name), name);
    }

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

        Simulation simulation = started(name);
        const bool whole = simulation.runUntil(20.0);
        QVERIFY2(whole, whole ? "" : simulation.trouble()->message.c_str());
        for (const Vec3& position : simulation.state().position)
            QVERIFY(position.allFinite());
    }

    // README.md and scenes/README.md have a table with a row for each scene, and no other rows.
    void listsNameEveryScene_data()
    {
        QTest::addColumn<QString>("file");
        QTest::newRow("README.md") << QStringLiteral(SCENES_DIR "/../README.md");
        QTest::newRow("scenes/README.md") << QStringLiteral(SCENES_DIR "/README.md");
    }
    void listsNameEveryScene()
    {
        QFETCH(QString, file);
        QFile page(file);
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

    void isWhatItsBuilderMakes_data() { runs_data(); }

    // If this fails after a change of a builder, run scenes/make.
    void isWhatItsBuilderMakes()
    {
        QFETCH(QString, name);
        const Scene scene = sample(name);
        const Part& part = partOf(scene);
        const Builder* builder = findBuilder(part.builder);
        QVERIFY(builder);
        const Result<Scene> again = build(*builder, part.parameters);
        QVERIFY(bool(again));
        QVERIFY(partOf(*again) == part);
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

    // It starts at 35 degrees, climbs, and stays above 60 % of its line at 45 to 80 degrees.
    void kiteClimbsAndHolds()
    {
        Simulation simulation = started("delta_kite");
        QVERIFY(probe(simulation, "line angle") < 36.0);
        const double length = partOf(sample("delta_kite")).parameters.at("line_length");
        const double hand = partOf(sample("delta_kite")).parameters.at("hand_height");
        double lowest = 90.0;
        double highest = 0.0;
        for (double time = 10.0; time <= 20.0; time += 0.5) {
            QVERIFY(simulation.runUntil(time));
            const double angle = probe(simulation, "line angle");
            lowest = std::min(lowest, angle);
            highest = std::max(highest, angle);
            QVERIFY(probe(simulation, "height") - hand > 0.6 * length);
            QVERIFY(probe(simulation, "line tension") > 0.0);
        }
        qInfo("line angle %.1f to %.1f degrees", lowest, highest);
        QVERIFY(lowest > 45.0 && highest < 80.0);
        QVERIFY(highest - lowest < 2.0);
    }

    // T-F1: tan(beta) = (L - W) / D and T = sqrt((L - W)^2 + D^2) of the line where it is tied to
    // the steady kite; lift and drag are summed up over the panels.
    void kitePullsAsStaticsSay()
    {
        const Scene scene = sample("delta_kite");
        Simulation simulation = started("delta_kite");
        QVERIFY(simulation.runUntil(20.0));
        const Part& part = partOf(scene);
        const auto isLine = [&](const Link& link) {
            return findItem<Material>(scene, link.material)->name.starts_with("line");
        };
        const Id tow = std::find_if(part.links.begin(), part.links.end(), isLine)->from;
        std::set<Id> onLine;
        for (const Link& link : part.links)
            if (isLine(link))
                onLine.insert({link.from, link.to});
        onLine.erase(tow);
        double weight = 0.0;
        for (const Particle& particle : part.particles)
            weight += onLine.contains(particle.id) ? 0.0 : particle.mass * 9.80665;

        constexpr int steps = 480;
        Vec3 force = Vec3::Zero(); // means over the steps, as is the pull of the line on the kite
        Vec3 pull = Vec3::Zero();
        for (int step = 0; step < steps; ++step) {
            QVERIFY(simulation.step());
            const auto frame = simulation.frame();
            for (const Vec3& load : frame->panelLoad)
                force += load / steps;
            for (std::size_t i = 0; i < part.links.size(); ++i)
                if (isLine(part.links[i]) && part.links[i].from == tow) {
                    const auto& place = frame->layout->links[i];
                    const Vec3 along = frame->position[std::size_t(place.b)]
                                       - frame->position[std::size_t(place.a)];
                    pull += frame->tension[i] / steps * along.normalized();
                }
        }
        const double up = force.y() - weight;
        const double beta = std::atan2(up, force.x());
        const double line = std::atan2(-pull.y(), -pull.x());
        qInfo("line at the kite %.2f degrees, statics %.2f; pull %.2f N, statics %.2f",
              line * 180.0 / std::numbers::pi, beta * 180.0 / std::numbers::pi, pull.norm(),
              std::hypot(up, force.x()));
        QVERIFY(std::abs(line - beta) < 0.01);
        QVERIFY(std::abs(pull.norm() / std::hypot(up, force.x()) - 1.0) < 0.02);
    }

    // The gusts of light turbulence shake the pull, and the kite stays up.
    void kiteFliesInGusts()
    {
        Simulation simulation = started("kite_in_gusts");
        double least = 1e9;
        double most = 0.0;
        for (double time = 5.0; time <= 20.0; time += 0.1) {
            QVERIFY(simulation.runUntil(time));
            least = std::min(least, probe(simulation, "line tension"));
            most = std::max(most, probe(simulation, "line tension"));
            QVERIFY(probe(simulation, "height") > 10.0);
        }
        qInfo("pull %.1f to %.1f N", least, most);
        QVERIFY(most > 1.3 * least);
    }

    // Glide ratio above 2 and steady; the linear-normal law allows some 3.5 (validation 4.7).
    void gliderGlides()
    {
        Simulation simulation = started("hang_glider");
        double lowest = 1e9;
        double highest = 0.0;
        for (double time = 5.0; time <= 20.0; time += 0.5) {
            QVERIFY(simulation.runUntil(time));
            lowest = std::min(lowest, probe(simulation, "glide ratio"));
            highest = std::max(highest, probe(simulation, "glide ratio"));
        }
        qInfo("glide ratio %.2f to %.2f", lowest, highest);
        QVERIFY(lowest > 2.0);
        QVERIFY(highest / lowest < 1.1);
        QVERIFY(probe(simulation, "mean glide ratio") > 2.0);
        QVERIFY(probe(simulation, "distance flown") > 100.0);
        QVERIFY(probe(simulation, "height") > 10.0); // still in the air
    }

    // Within 20 % of the best glide of modern wings, 13.4 (USHPA-4 of XCSoar's PolarStore),
    // steadily.
    void gliderWithInducedFlowGlidesFar()
    {
        Simulation simulation = started("glider_polar");
        QVERIFY(simulation.runUntil(20.0)); // it starts with a swing
        const double from = probe(simulation, "distance flown");
        const double high = probe(simulation, "height");
        QVERIFY(simulation.runUntil(54.0));
        const double glide =
            (probe(simulation, "distance flown") - from) / (high - probe(simulation, "height"));
        qInfo("glide ratio %.2f", glide);
        QVERIFY(std::abs(glide / 13.4 - 1.0) < 0.2);
    }

    // T-F2: weight shift forward flies faster, to the right turns right, and let go it recovers.
    void gliderObeysThePilot()
    {
        const Scene scene = sample("hang_glider");
        std::uint32_t pitch = 0;
        std::uint32_t roll = 0;
        for (const Entry& entry : scene.items)
            if (std::holds_alternative<Control>(entry.item))
                (nameOf(entry.item) == "pitch" ? pitch : roll) = std::uint32_t(entry.id);

        Simulation diver = started("hang_glider");
        diver.command({{pitch, 0.2}});
        QVERIFY(diver.runUntil(8.0));
        QVERIFY(probe(diver, "speed") > 12.0);

        Simulation turner = started("hang_glider");
        turner.command({{roll, 0.3}});
        QVERIFY(turner.runUntil(5.0));
        turner.command({{roll, 0.0}});
        QVERIFY(turner.runUntil(12.0));
        Vec3 velocity = Vec3::Zero();
        for (const Vec3& v : turner.state().velocity)
            velocity += v / double(turner.state().velocity.size());
        QVERIFY(velocity.z() > 2.0); // right of +x
        QVERIFY(probe(turner, "glide ratio") > 2.0);
    }

    // Descent 3.1: v = sqrt(2 m g / (rho C sum(A ny^2))), tolerance 3 %. Skin friction carries a
    // little, too; it is 0.02 against a normal force coefficient above 1.
    void parachuteSinksAsItsDragPredicts()
    {
        const Scene scene = sample("parachute");
        const Part& part = partOf(scene);
        double mass = 0.0;
        for (const Particle& particle : part.particles)
            mass += particle.mass;
        double dragArea = 0.0; // m^2
        for (const Panel& panel : part.panels) {
            const Vec3 a = findRow(part.particles, panel.a)->position;
            const Vec3 b = findRow(part.particles, panel.b)->position;
            const Vec3 c = findRow(part.particles, panel.c)->position;
            const Vec3 doubled = (b - a).cross(c - a);
            const double up = doubled.normalized().y();
            dragArea += findItem<Material>(scene, panel.material)->normalCoefficient * 0.5
                        * doubled.norm() * up * up;
        }
        const double predicted = std::sqrt(2.0 * mass * 9.80665 / (1.225 * dragArea));

        Simulation simulation = started("parachute");
        for (double time = 10.0; time <= 20.0; time += 1.0) {
            QVERIFY(simulation.runUntil(time));
            const double rate = probe(simulation, "sink rate");
            QVERIFY2(std::abs(rate / predicted - 1.0) < 0.03,
                     qPrintable(QString("%1 and not %2 m/s").arg(rate).arg(predicted)));
        }
        QVERIFY(probe(simulation, "height") > 0.0);
    }

    // Peirce 1930: whatever the fabric, twice its bending length droops to 41.5 degrees; the heavy
    // elastica says 41.49.
    void stripsDroopToTheRamps()
    {
        Simulation simulation = started("bending_test");
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
        Simulation simulation = started("torn_sheet");
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

    // Threads of 0.5 m, of springs of 0.025 m and 100 N/m, drawn at v = 0.05 m/s to a strain of
    // 0.3: 3 s and 0.75 N. A wave of v / c, c = sqrt(100 N/m / 0.25 kg/m^2) = 20 m/s, runs to and
    // fro and may add its height twice, which is 0.05 s of drawing; on the mean no thread can be
    // late. The halves recoil with w = pi c / (2 0.25 m) = 126/s, damped at nu w^2 / (2 k) = 0.8/s,
    // and are still after 17 s, where a whole thread would pull with 2.5 N.
    void stripTears()
    {
        Simulation simulation = started("tear_test");
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
        for (const double tension : simulation.frame()->tension) // two halves
            QVERIFY(std::abs(tension) < 0.01 * 0.75);
    }

    // T = 4 sqrt(L / g) K(sin(a / 2)) = 2.04134 s for 1 m and 30 degrees: after whole periods the
    // bob is back where it was let go. 1 % of a period off would be 0.06 rad of phase.
    void pendulumKeepsTime()
    {
        const double period = 2.0413384658583684;
        Simulation simulation = started("pendulum");
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
        Simulation simulation = started("heavy_load");
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

    void sheetsLieOnTop_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"sheet_on_boxes", "sheet_on_terrain"})
            QTest::newRow(name) << QString(name);
    }

    // Ten seconds after it was let go, no particle is nearer to a box or to the ground than the
    // thickness says, and the sheet rests.
    void sheetsLieOnTop()
    {
        QFETCH(QString, name);
        Simulation simulation = started(name);
        for (double time = 0.5; time <= 10.0; time += 0.5) {
            QVERIFY(simulation.runUntil(time));
            for (const Obstacle& obstacle : simulation.system().obstacles)
                for (const Vec3& x : simulation.state().position) {
                    const Vec3 own = obstacle.turn.transpose() * (x - obstacle.position);
                    double room = x.y();
                    if (obstacle.shape == ColliderShape::Box)
                        room = nearestOnBox(0.5 * obstacle.size, own).distance;
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

    // Waves on it run slower than the wind, so that they grow: the flag must not come to rest.
    void flagFlutters()
    {
        Simulation simulation = started("flag");
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
};

QTEST_APPLESS_MAIN(TestScenes)
#include "test_scenes.moc"
