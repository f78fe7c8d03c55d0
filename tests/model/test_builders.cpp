// Counts and masses of the builders, against the lattice formulas and the papers' tables
// (validation page 1.3 to 1.6).
//
// Stages: counts, and that every builder gives a sound scene over the ranges of its parameters;
// names and refusals; then masses, the drag of the parachute, and a glider whose wind carries its
// weight at the start.
#include "builders/builder.h"
#include "builders/statics.h"
#include "check/check.h"
#include "derived/canopy_shape.h"
#include "derived/cloth_area.h"
#include "registered_test.h"

#include <QtTest>

#include <set>

namespace ripstop::test_builders {

namespace {

struct Counts
{
    int particles = 0;
    int rods = 0;
    int springs = 0;
    int panels = 0;
};

Scene built(const char* name, const Parameters& given = {})
{
    const Result<Scene> scene = build(*findBuilder(name), given);
    return scene ? *scene : Scene{};
}

const Part& partOf(const Scene& scene)
{
    const Part* found = nullptr;
    forEachPart(scene, [&](Id, const Part& part) { found = &part; });
    return *found;
}

Counts countsOf(const Scene& scene)
{
    Counts counts;
    forEachPart(scene, [&](Id, const Part& part) {
        counts.particles += int(part.particles.size());
        counts.panels += int(part.panels.size());
        for (const Link& link : part.links)
            (link.kind == LinkKind::Rod ? counts.rods : counts.springs)++;
    });
    return counts;
}

// Whether a link lies on a ray from the axis, seen from above.
bool isOnRay(const Part& part, const Link& link, const Vec3& ray)
{
    const Vec3 way =
        findRow(part.particles, link.from)->position - findRow(part.particles, link.to)->position;
    const Vec3 level(way.x(), 0.0, way.z());
    return level.dot(ray) > (1.0 - 1e-9) * level.norm() * ray.norm();
}

const Group& group(const Scene& scene, std::string_view name)
{
    for (const Entry& entry : scene.items)
        if (const Group* group = std::get_if<Group>(&entry.item))
            if (group->name == name)
                return *group;
    qFatal("no such group");
}

} // namespace

class TestBuilders : public QObject
{
    Q_OBJECT

private slots:
    void counts_data()
    {
        QTest::addColumn<QString>("builder");
        QTest::addColumn<QVariantMap>("given");
        QTest::addColumn<int>("particles");
        QTest::addColumn<int>("rods");
        QTest::addColumn<int>("springs");
        QTest::addColumn<int>("panels");
        const auto row = [](const char* name, const char* builder, const QVariantMap& given,
                            int particles, int rods, int springs, int panels) {
            QTest::newRow(name) << builder << given << particles << rods << springs << panels;
        };
        // 1.4: V = (n+1)(n+2)/2 + 4, E = 3n(n+1)/2 + 2 (2n+1 + n/2) + 2 x 3n, T = n^2
        row("glider of the paper, 8 segments", "hang_glider", {}, 49, 198, 0, 64);
        row("glider of figure 12, 3 segments", "hang_glider", {{"segments", 3}}, 14, 52, 0, 9);
        row("glider, 12 segments", "hang_glider", {{"segments", 12}}, 95, 368, 0, 144);
        // 1.5: wing and keel share k+1 nodes; V = Vn + Vk - (k+1) + 2 + l + 1
        row("kite of the paper", "delta_kite", {}, 152, 458, 0, 221);
        row("kite, 8 segments, keel 3, line 10", "delta_kite",
            {{"segments", 8}, {"keel", 3}, {"line", 10}}, 45 + 10 - 4 + 2 + 11,
            108 + 18 + 2 * (17 + 4) + 10 + 8, 0, 64 + 9);
        // 1.6: V = 1 + 6S, E = 17S, T = 11S; lines of 4 add 3S and a payload, 4S rods; hoop 2, 2S
        row("parachute of the paper, hoop", "parachute", {}, 145 + 72 + 1 + 2, 408 + 96 + 48, 0,
            264);
        row("parachute without hoop", "parachute", {{"hoop", 0}}, 218, 504, 0, 264);
        row("parachute, 12 sectors", "parachute", {{"sectors", 12}}, 73 + 36 + 1 + 2, 204 + 48 + 24,
            0, 132);
        row("parachute, 28 sectors of the C-9", "parachute", {{"sectors", 28}, {"hoop", 0}},
            169 + 84 + 1, 476 + 112, 0, 308);
        row("parachute that holds air", "parachute", {{"pressure", 1.68}}, 218, 504, 0, 264);
        // a vent: V = 1 + 7S, T = 12S, E = 18S, a rim of S and lines of S to the crossing
        row("parachute with a vent", "parachute", {{"vent_diameter", 0.4}, {"hoop", 0}}, 169 + 73,
            480 + 96, 0, 288);
        row("rod of the papers", "stiffened_rod", {}, 6, 11, 0, 0);
        row("rope", "rope", {{"segments", 14}}, 15, 14, 0, 0);
        row("rope with second neighbours", "rope", {{"segments", 14}, {"stiffened", 1}}, 15, 27, 0,
            0);
        // (c+1)(r+1) nodes; structural c(r+1) + r(c+1), shear 2cr, bend (c-1)(r+1) + (r-1)(c+1)
        row("cloth", "cloth", {{"columns", 4}, {"rows", 3}}, 20, 0, 16 + 15 + 24 + 12 + 10, 24);
        // two cells cut: 2 structural, 4 shear and 4 bend springs and 4 panels less
        row("cloth with a slit", "cloth", {{"columns", 4}, {"rows", 4}, {"slit", 0.5}}, 25, 0,
            40 - 2 + 32 - 4 + 30 - 4, 32 - 4);
        // kites without a keel: two hubs with spokes, a tow point with legs, a tail of t nodes and
        // t rods, a line of l + 1 particles, l rods and l - 2 between second neighbours
        const int tail = 5, line = 10, lineRods = 18;
        // sail (n+1)^2, edges of two lattices less n shared and n on the spine; spokes to n + 1
        // nodes of the spine, n of the cross spar and 4 (n-1) of the edge; 3 legs
        row("diamond kite", "diamond_kite", {{"segments", 4}, {"line", 10}, {"tail_segments", 5}},
            25 + 2 + 1 + tail + line + 1, 60 - 4 + 4 + 2 * 21 + 3 + tail + lineRods, 0, 32);
        // (c+1)(r+1), c(r+1) + r(c+1) threads, cr diagonals; all 9 are on the frame; 4 legs
        row("rectangular kite", "rectangular_kite",
            {{"columns", 2}, {"rows", 2}, {"line", 10}, {"tail_segments", 5}},
            9 + 2 + 1 + tail + line + 1, 12 + 4 + 2 * 9 + 4 + tail + lineRods, 0, 8);
        // R (2^L - 1) + 1 particles, a line less each
        row("bridle of 2 rows and 4 levels", "bridle", {{"rows", 2}, {"levels", 4}}, 31, 30, 0, 0);
        // (n+1)^2 + 4 m (n+1); square 2n(n+1) + n^2 rods, an arm mn + m(n+1) + mn; lines and two
        // spokes to each node at the ends of the arms, or to the 4n of the rim; spokes to 4
        // corners, and a rod from hub to hub
        row("cross parachute", "cross_parachute", {{"cells", 2}, {"line_segments", 1}},
            9 + 4 * 2 * 3 + 1 + 2, 12 + 4 + 4 * (4 + 6 + 4) + 12 + 2 * (12 + 4) + 1, 0, 8 + 32);
        row("square parachute", "cross_parachute",
            {{"cells", 2}, {"arms", 0}, {"line_segments", 1}}, 9 + 1 + 2, 12 + 4 + 8 + 16 + 1, 0,
            8);
        // (c+1)(r+1), c(r+1) + r(c+1), a brace in each bay
        row("frame of spars", "frame", {{"columns", 3}, {"rows", 2}}, 12, 9 + 8 + 6, 0, 0);
        row("frame with rigidity particles", "frame",
            {{"columns", 3}, {"rows", 2}, {"braces", 0}, {"rigidity", 1}}, 14, 17 + 24, 0, 0);
        // pole 2.5 m of which 0.8 m carry 8 rows: 17 segments below them; ties at each row
        row("flag on a pole", "pole_flag", {{"columns", 3}, {"rows", 8}}, 36 + 17 + 9, 25 + 9,
            27 + 32 + 48, 48);
    }

    void counts()
    {
        QFETCH(QString, builder);
        QFETCH(QVariantMap, given);
        Parameters parameters;
        for (auto i = given.cbegin(); i != given.cend(); ++i)
            parameters[i.key().toStdString()] = i.value().toDouble();
        const Counts counts = countsOf(built(qPrintable(builder), parameters));
        QTEST(counts.particles, "particles");
        QTEST(counts.rods, "rods");
        QTEST(counts.springs, "springs");
        QTEST(counts.panels, "panels");
    }

    // Every builder at its defaults and at both ends of every range gives a scene that may run,
    // free of load, with ids in order and something in each group; where a limit does not go with
    // the rest, it says so.
    void soundAcrossRanges_data()
    {
        QTest::addColumn<QString>("name");
        for (const Builder& builder : allBuilders())
            QTest::newRow(builder.name.data()) << builder.name.data();
    }

    void soundAcrossRanges()
    {
        QFETCH(QString, name);
        const Builder& builder = *findBuilder(name.toStdString());
        std::vector<Parameters> cases{{}};
        for (const Parameter& parameter : builder.parameters) {
            cases.push_back({{std::string(parameter.key), parameter.low}});
            cases.push_back({{std::string(parameter.key), parameter.high}});
        }
        for (const Parameters& given : cases) {
            const QString what =
                given.empty()
                    ? "defaults"
                    : QString("%1=%2").arg(given.begin()->first.c_str()).arg(given.begin()->second);
            const Result<Scene> scene = build(builder, given);
            QVERIFY2(bool(scene),
                     qPrintable(scene ? what : what + ": " + scene.message().english().c_str()));
            const std::vector<Finding> problems = problemsOf(*scene);
            if (hasErrors(problems))
                QFAIL(qPrintable(what + ": "
                                 + QString::fromStdString(problems[0].message.english())));
            for (const Entry& entry : scene->items)
                if (const Group* group = std::get_if<Group>(&entry.item))
                    QVERIFY2(!group->members.empty(),
                             qPrintable(what + ": " + QString::fromStdString(group->name)));
            forEachPart(*scene, [&](Id, const Part& part) {
                checkPart(part, what);
                QCOMPARE(part.builder, std::string(builder.name));
                QCOMPARE(part.parameters.size(), builder.parameters.size());
            });
        }
    }

    void namesAreUnique()
    {
        for (const Builder& builder : allBuilders()) {
            const Scene scene = built(builder.name.data());
            std::set<std::string> names;
            for (const Entry& entry : scene.items)
                QVERIFY2(names.insert(nameOf(entry.item)).second, nameOf(entry.item).c_str());
        }
    }

    void aNewCraftIsOfRealMaterials_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name :
             {"delta_kite", "diamond_kite", "rectangular_kite", "hang_glider", "parachute"})
            QTest::newRow(name) << name;
    }

    // What is built for the first time carries its pull by cloth; what says nothing, as files of
    // before do, and what says that its cloth is ideal are the papers'.
    void aNewCraftIsOfRealMaterials()
    {
        QFETCH(QString, name);
        const Builder& builder = *findBuilder(name.toStdString());
        const Result<Scene> fresh = build(builder, newDesign(builder, {}));
        QVERIFY(bool(fresh));
        QCOMPARE(partOf(*fresh).carrier, FabricKind::Panels);
        QVERIFY(problemsOf(*fresh).empty());
        for (const Parameters& given : {Parameters{}, newDesign(builder, {{"cloth", 0.0}})}) {
            const Result<Scene> ideal = build(builder, given);
            QVERIFY(bool(ideal));
            QCOMPARE(partOf(*ideal).carrier, FabricKind::Threads);
            QVERIFY(*ideal == built(builder.name.data()));
        }
    }

    void whatIsGivenIsNotOffered()
    {
        const Builder& canopy = *findBuilder("parachute");
        const Parameters design = newDesign(canopy, {{"pressure", 0.0}, {"rings", 8.0}});
        QCOMPARE(design.at("pressure"), 0.0);
        QCOMPARE(design.at("rings"), 8.0);
        QVERIFY(design.at("cloth") > 0.0);
        QVERIFY(newDesign(*findBuilder("stiffened_rod"), {}).empty());
    }

    // Numbers of a material of one's own are not ignored for one of the library.
    void numbersOfOnesOwnAreTaken()
    {
        QVERIFY(newDesign(*findBuilder("rope"), {{"length", 3.0}}).contains("cord"));
        QVERIFY(!newDesign(*findBuilder("rope"), {{"axial", 1e5}}).contains("cord"));
        QVERIFY(!newDesign(*findBuilder("cloth"), {{"membrane", 4e4}}).contains("cloth"));
        const Parameters kite = newDesign(*findBuilder("delta_kite"), {{"line_density", 1e-3}});
        QVERIFY(!kite.contains("cord") && kite.contains("cloth") && kite.contains("spars"));
        QCOMPARE(newDesign(*findBuilder("rope"), {{"axial", 1e5}, {"cord", 2.0}}).at("cord"), 2.0);
        const Parameters canopy = newDesign(*findBuilder("parachute"), {{"drag", 0.5}});
        QVERIFY(!canopy.contains("pressure") && !canopy.contains("cloth"));
    }

    // Whoever says what is so anyway gets the design of who says nothing.
    void whatIsUsualChangesNothing()
    {
        for (const Builder& builder : allBuilders()) {
            const Result<Scene> plain = build(builder, newDesign(builder, {}));
            QVERIFY2(plain, builder.name.data());
            for (const Parameter& parameter : builder.parameters) {
                Parameters design =
                    newDesign(builder, {{std::string(parameter.key), parameter.atFirst()}});
                Parameters expected = newDesign(builder, {});
                expected[std::string(parameter.key)] = parameter.atFirst();
                QVERIFY2(design == expected, parameter.key.data());
            }
        }
    }

    void refusesWhatIsWrong()
    {
        const Builder& kite = *findBuilder("delta_kite");
        QVERIFY(QString::fromStdString(build(kite, {{"segmnts", 8}}).message().english())
                    .contains("did you mean \"segments\""));
        for (const Parameters& wrong :
             {Parameters{{"segments", 8.5}}, {{"segments", -1}}, {{"span", 1e9}}, {{"span", NAN}}})
            QVERIFY(!build(kite, wrong));
        QVERIFY(findBuilder("no_such_thing") == nullptr);
        // a table: a cell out of range, a row too short, a line that does not reach
        const Builder& bridle = *findBuilder("bridle");
        for (const auto& [table, place] : {std::pair{"1,-2", "row 1, column 2"},
                                           {"1,1;1", "row 2, column 2"},
                                           {"1,0.5,0.1", "row 1, column 3"}}) {
            Parameters given;
            setTable(given, *bridle.table, *tableFromText(*bridle.table, table));
            const Result<Scene> scene = build(bridle, given);
            QVERIFY2(!scene && QString::fromStdString(scene.message().english()).contains(place),
                     table);
        }
    }

    // 1.5: 14 + 2 line nodes; the last node and the hand are pinned at one place.
    void kiteHandIsOnePlace()
    {
        const Scene scene = built("delta_kite");
        const Group& held = group(scene, "hand end");
        QCOMPARE(held.members.size(), std::size_t(2));
        const auto& particles = partOf(scene).particles;
        const Particle* end = findRow(particles, held.members[0]);
        const Particle* hand = findRow(particles, held.members[1]);
        QVERIFY(end->pinned && hand->pinned);
        QCOMPARE(end->position, hand->position);
    }

    // 3.3: 20-30 kg wing, 55-70 kg pilot; 3.2: 0.1-0.3 kg; equal masses as the paper has them.
    void masses()
    {
        QVERIFY(std::abs(lumpedMassOf(partOf(built("hang_glider"))).mass - 90.0) < 1e-9);
        const double kite = lumpedMassOf(partOf(built("delta_kite"))).mass;
        QVERIFY2(kite > 0.1 && kite < 0.3, qPrintable(QString::number(kite)));
        // 1 m x 1 m at 0.25 kg/m^2
        QVERIFY(std::abs(lumpedMassOf(partOf(built("cloth"))).mass - 0.25) < 1e-12);
        // 2 m at 0.05 kg/m and a bob
        QVERIFY(std::abs(lumpedMassOf(partOf(built("rope", {{"end_mass", 1}}))).mass - 1.1)
                < 1e-12);
    }

    // Knacke: at v = 1 m/s upright the drag is 1/2 rho CD0 pi D0^2 / 4.
    void parachuteDrag()
    {
        const Scene scene = built("parachute");
        const Load load = airLoad(scene, partOf(scene), Vec3::UnitY());
        const double expected = 0.5 * 1.225 * 0.775 * 0.25 * M_PI * 25.0;
        QVERIFY(std::abs(load.force.y() / expected - 1.0) < 1e-9);
        QVERIFY(std::abs(load.force.x()) < 1e-9 && std::abs(load.force.z()) < 1e-9);
    }

    // A vent of the diameter d takes its disc off the cloth. Cloth ends at its rim, which lies flat
    // at d / 2 from where the lines over it cross; these go on where the seams of the gores end.
    // Who starts high up is told that the air there is that of everywhere, and what it would be:
    // rho = 1.225 (1 - 0.0065 h / 288.15)^4.2559 in the troposphere of the standard atmosphere (ISO
    // 2533).
    void altitudeSaysNothingOfTheAir()
    {
        int count = 0;
        for (const Builder& builder : allBuilders()) {
            const auto altitude =
                std::ranges::find(builder.parameters, "altitude", &Parameter::key);
            if (altitude == builder.parameters.end())
                continue;
            ++count;
            const double density = 1.225 * std::pow(1.0 - 0.0065 * altitude->high / 288.15, 4.2559);
            const QString help = QString::fromUtf8(altitude->help.data(), altitude->help.size());
            QVERIFY2(help.contains("settings.airDensity"), qPrintable(help));
            QVERIFY2(help.contains(
                         QString("%1 kg/m^3 at %2 m").arg(density, 0, 'f', 3).arg(altitude->high)),
                     qPrintable(help));
        }
        QCOMPARE(count, 3); // two parachutes and a glider
    }

    void ventOfAParachute_data()
    {
        QTest::addColumn<double>("cloth");
        QTest::addColumn<double>("pressure");
        QTest::newRow("ideal, a cap") << 0.0 << 0.0;
        QTest::newRow("ideal, cut flat") << 0.0 << 1.68;
        QTest::newRow("nylon") << 1.0 << 1.68;
    }

    void ventOfAParachute()
    {
        QFETCH(double, cloth);
        QFETCH(double, pressure);
        constexpr double vent = 0.5; // m, of 5 m
        const Parameters whole{{"cloth", cloth}, {"cord", cloth}, {"pressure", pressure}};
        Parameters vented = whole;
        vented["vent_diameter"] = vent;
        const Scene scene = built("parachute", vented);
        const Part& part = partOf(scene);
        QVERIFY(problemsOf(scene).empty());
        const Particle& crossing = part.particles.front();
        std::vector<Id> rim;
        for (const Link& link : part.links)
            if (link.from == crossing.id) {
                QCOMPARE(link.resists, Resists::Tension);
                rim.push_back(link.to);
            }
        QCOMPARE(rim.size(), std::size_t(24));
        for (const Id id : rim) {
            const Vec3 spoke = findRow(part.particles, id)->position - crossing.position;
            QVERIFY(std::abs(spoke.y()) < 1e-9);
            QVERIFY(spoke.norm() < 0.51 * vent && spoke.norm() > 0.45 * vent);
            // the seam begins there and goes on the same way
            const auto seam = std::ranges::find_if(part.links, [&](const Link& link) {
                return link.to == id && std::ranges::find(rim, link.from) == rim.end()
                       && link.from != crossing.id && isOnRay(part, link, spoke);
            });
            QVERIFY(seam != part.links.end());
        }
        for (const Panel& panel : part.panels)
            for (const Id corner : {panel.a, panel.b, panel.c})
                QVERIFY(corner != crossing.id);
        if (cloth > 0.0) {
            const double flat = ClothArea(part).whole();
            const double expected = 0.25 * M_PI * (25.0 - vent * vent);
            QVERIFY(std::abs(flat / expected - 1.0) < 1e-9);
        }
        if (pressure > 0.0) {
            const auto pieces = canopyPieces(part);
            QVERIFY(bool(pieces));
            QCOMPARE(pieces->size(), std::size_t(1));
            QCOMPARE(pieces->front().vents.size(), std::size_t(1));
            QVERIFY(std::ranges::is_permutation(pieces->front().vents[0], rim));
        } else {
            // on what is left of the nominal area
            const Load load = airLoad(scene, part, Vec3::UnitY());
            const double expected = 0.5 * 1.225 * 0.775 * 0.25 * M_PI * (25.0 - vent * vent);
            QVERIFY(std::abs(load.force.y() / expected - 1.0) < 1e-9);
        }
    }

    // The glider starts in trim: in its own wind the air carries the weight, through the centre of
    // mass.
    void gliderStartsInTrim()
    {
        const Scene scene = built("hang_glider");
        const Part& part = partOf(scene);
        const LumpedMass weight = lumpedMassOf(part);
        const Vec3 velocity = part.particles.front().velocity;
        QVERIFY(std::abs(velocity.norm() - 11.0) < 1e-9);
        const Load load = airLoad(scene, part, -velocity);
        const double pull = weight.mass * 9.80665;
        QVERIFY((load.force - Vec3(0.0, pull, 0.0)).norm() < 1e-6 * pull);
        const Vec3 moment = load.moment - weight.center.cross(load.force);
        QVERIFY(moment.norm() < 1e-6 * pull);
    }

private:
    static void checkPart(const Part& part, const QString& what)
    {
        for (std::size_t i = 1; i < part.particles.size(); ++i)
            QVERIFY2(part.particles[i - 1].id < part.particles[i].id, qPrintable(what));
        for (std::size_t i = 1; i < part.links.size(); ++i)
            QVERIFY2(part.links[i - 1].id < part.links[i].id, qPrintable(what));
        for (const Link& link : part.links) {
            const Vec3& a = findRow(part.particles, link.from)->position;
            const Vec3& b = findRow(part.particles, link.to)->position;
            const double stretch = (b - a).norm() - link.restLength;
            const bool slack = link.resists == Resists::Tension && stretch < 0.0; // cloth in folds
            QVERIFY2(slack || std::abs(stretch) < 1e-9, qPrintable(what));
        }
    }
};

const RegisteredTest registered("test_builders", runPlain<TestBuilders>);

} // namespace ripstop::test_builders
#include "test_builders.moc"
