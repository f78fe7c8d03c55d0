// Counts and masses of the builders, against the lattice formulas and the papers' tables
// (validation page 1.3 to 1.6).
#include "builders/builder.h"
#include "builders/statics.h"
#include "scene/check.h"

#include <QtTest>

#include <set>

using namespace ripstop;

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
        row("rod of the papers", "stiffened_rod", {}, 6, 11, 0, 0);
        row("rope", "rope", {{"segments", 14}}, 15, 14, 0, 0);
        row("rope with second neighbours", "rope", {{"segments", 14}, {"stiffened", 1}}, 15, 27, 0,
            0);
        // (c+1)(r+1) nodes; structural c(r+1) + r(c+1), shear 2cr, bend (c-1)(r+1) + (r-1)(c+1)
        row("cloth", "cloth", {{"columns", 4}, {"rows", 3}}, 20, 0, 16 + 15 + 24 + 12 + 10, 24);
        // two cells cut: 2 structural, 4 shear and 4 bend springs and 4 panels less
        row("cloth with a slit", "cloth", {{"columns", 4}, {"rows", 4}, {"slit", 0.5}}, 25, 0,
            40 - 2 + 32 - 4 + 30 - 4, 32 - 4);
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
    // free of load, with ids in order.
    void soundAcrossRanges()
    {
        for (const Builder& builder : allBuilders()) {
            std::vector<Parameters> cases{{}};
            for (const Parameter& parameter : builder.parameters) {
                if (parameter.whole && parameter.high > 100)
                    continue; // large meshes are slow to check and differ in size only
                cases.push_back({{std::string(parameter.key), parameter.low}});
                cases.push_back({{std::string(parameter.key), parameter.high}});
            }
            for (const Parameters& given : cases) {
                const Result<Scene> scene = build(builder, given);
                QVERIFY(bool(scene));
                const QString what = QString::fromStdString(
                    std::string(builder.name) + (given.empty() ? "" : " " + given.begin()->first));
                const std::vector<Problem> problems = problemsOf(*scene);
                if (hasErrors(problems))
                    QFAIL(qPrintable(what + ": " + QString::fromStdString(problems[0].message)));
                checkPart(partOf(*scene), what);
                QCOMPARE(partOf(*scene).builder, std::string(builder.name));
                QCOMPARE(partOf(*scene).parameters.size(), builder.parameters.size());
            }
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

    void refusesWhatIsWrong()
    {
        const Builder& kite = *findBuilder("delta_kite");
        QVERIFY(QString::fromStdString(build(kite, {{"segmnts", 8}}).message())
                    .contains("did you mean \"segments\""));
        for (const Parameters& wrong :
             {Parameters{{"segments", 8.5}}, {{"segments", -1}}, {{"span", 1e9}}, {{"span", NAN}}})
            QVERIFY(!build(kite, wrong));
        QVERIFY(findBuilder("no_such_thing") == nullptr);
        QCOMPARE(allBuilders().size(), std::size_t(7));
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
        QVERIFY(std::abs(weightOf(partOf(built("hang_glider"))).mass - 90.0) < 1e-9);
        const double kite = weightOf(partOf(built("delta_kite"))).mass;
        QVERIFY2(kite > 0.1 && kite < 0.3, qPrintable(QString::number(kite)));
        // 1 m x 1 m at 0.25 kg/m^2
        QVERIFY(std::abs(weightOf(partOf(built("cloth"))).mass - 0.25) < 1e-12);
        // 2 m at 0.05 kg/m and a bob
        QVERIFY(std::abs(weightOf(partOf(built("rope", {{"end_mass", 1}}))).mass - 1.1) < 1e-12);
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

    // The glider starts in trim: in its own wind the air carries the weight, through the centre of
    // mass.
    void gliderStartsInTrim()
    {
        const Scene scene = built("hang_glider");
        const Part& part = partOf(scene);
        const Weight weight = weightOf(part);
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

QTEST_APPLESS_MAIN(TestBuilders)
#include "test_builders.moc"
