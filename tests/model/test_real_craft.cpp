// Parachutes and hang gliders of what one can buy: what they weigh, how their cloth is cut, and
// what it pulls with.
//
// Stages: what is offered is in the library; masses summed up by hand; the grain of every panel.
// test_real_flights.cpp flies them.
#include "check/check.h"
#include "check/strength_gaps.h"
#include "derived/cloth_area.h"
#include "derived/flat_panel.h"
#include "model/real_craft.h"
#include "registered_test.h"

#include <QtTest>

#include <cmath>

namespace ripstop::test_real_craft {

namespace {

double middleOfGore(double x, double z) // rad, of 24
{
    constexpr double gore = 2.0 * pi / 24.0;
    return (std::floor(std::atan2(z, x) / gore) + 0.5) * gore;
}

// Where the warp of a panel runs on the cloth as it is printed, rad: from the side ab, turned
// towards c by the grain.
double warpOnPicture(const Part& part, const Panel& panel)
{
    const auto at = [&](Id id) {
        const Particle& row = *findRow(part.particles, id);
        return Eigen::Vector2d(row.textureU, row.textureV);
    };
    const Eigen::Vector2d ab = at(panel.b) - at(panel.a);
    const Eigen::Vector2d ac = at(panel.c) - at(panel.a);
    const double hand = ab.x() * ac.y() - ab.y() * ac.x() > 0.0 ? 1.0 : -1.0;
    return std::atan2(ab.y(), ab.x()) + hand * panel.grain * pi / 180.0;
}

} // namespace

class TestRealCraft : public QObject
{
    Q_OBJECT

private slots:
    void libraryHasWhatIsOffered_data()
    {
        QTest::addColumn<QByteArray>("builder");
        QTest::addColumn<QByteArray>("parameter");
        QTest::addColumn<QList<QByteArray>>("needed");
        const QList<QByteArray> cloth{"membraneStiffness", "arealDensity", "shearStiffness"};
        const QList<QByteArray> line{"axialStiffness", "linearDensity", "lineStrength"};
        QTest::newRow("canopy") << QByteArray("parachute") << QByteArray("cloth") << cloth;
        QTest::newRow("lines") << QByteArray("parachute") << QByteArray("cord") << line;
        QTest::newRow("tapes") << QByteArray("parachute") << QByteArray("tape") << line;
        QTest::newRow("cross") << QByteArray("cross_parachute") << QByteArray("cloth") << cloth;
        QTest::newRow("sail") << QByteArray("hang_glider") << QByteArray("cloth") << cloth;
        QTest::newRow("tubes") << QByteArray("hang_glider") << QByteArray("spars")
                               << QList<QByteArray>{"axialStiffness", "flexuralRigidity",
                                                    "linearDensity"};
    }

    void libraryHasWhatIsOffered()
    {
        QFETCH(QByteArray, builder);
        QFETCH(QByteArray, parameter);
        QFETCH(QList<QByteArray>, needed);
        for (const std::string_view name :
             parameterOf(builder, parameter.data()).choices.subspan(1))
            for (const QByteArray& key : needed)
                QVERIFY2(number(std::string(name).c_str(), key.data()) > 0.0, name.data());
    }

    // Hems are 2 cm of Dacron of 40 kN/m, wires steel cables of 920 lb (AC 43.13-1B, table 7-3);
    // seams and skirt 2 cm of nylon of 7355 N/m.
    void hemsAndWiresHaveTheirStrength()
    {
        const auto strength = [](const Scene& scene, std::string_view name) {
            const auto found = std::ranges::find_if(
                scene.items, [&](const Entry& entry) { return nameOf(entry.item) == name; });
            return std::get<Material>(found->item).lineStrength.value_or(0.0);
        };
        const Scene glider = craft("hang_glider", dacron());
        QCOMPARE(strength(glider, "hem"), 800.0);
        QVERIFY(std::abs(strength(glider, "wire") - 920.0 * 4.4482216) < 1.0);
        for (const Id id : materialsWithoutStrength(glider))
            QCOMPARE(nameOf(*findItem(glider, id)), std::string("frame"));
        const Scene canopy = craft("parachute", nylon({{"pressure", 1.68}}));
        QCOMPARE(strength(canopy, "gore seams"), 147.1);
        QCOMPARE(strength(canopy, "skirt"), 147.1);
        QVERIFY(materialsWithoutStrength(canopy).empty());
        const Scene papers = craft("hang_glider", {});
        QCOMPARE(strength(papers, "wire"), 0.0);
    }

    // The cloth has the area of D0. Gores are triangles of sides R: S/2 R^2 sin(2 pi / S) of it,
    // S R of seams, 2 S R sin(pi / S) of skirt, each of a hem of 2 cm of cloth; and S lines.
    void canopyWeighsWhatItIsMadeOf_data()
    {
        QTest::addColumn<QByteArray>("tape");
        QTest::newRow("hems") << QByteArray("hem");
        QTest::newRow("tubular nylon") << QByteArray("mil_5625_050");
    }

    void canopyWeighsWhatItIsMadeOf()
    {
        QFETCH(QByteArray, tape);
        const Scene scene =
            craft("parachute",
                  nylon({{"pressure", 1.68}, {"tape", choice("parachute", "tape", tape.data())}}));
        constexpr double S = 24.0;
        const double R = 2.5 * std::sqrt(2.0 * pi / (S * std::sin(2.0 * pi / S)));
        const double density = number("mil_7020_1", "arealDensity");
        const double hem = tape == "hem" ? 0.02 * density : number("mil_5625_050", "linearDensity");
        const double expected = density * 0.25 * pi * 5.0 * 5.0
                                + hem * S * R * (1.0 + 2.0 * std::sin(pi / S))
                                + number("mil_5040_1", "linearDensity") * S * 4.5 + 25.0;
        QVERIFY2(std::abs(massOf(partOf(scene)) / expected - 1.0) < 1e-9,
                 qPrintable(QString("%1 of %2 kg").arg(massOf(partOf(scene))).arg(expected)));
    }

    // Five squares of side w; hems along the rim of the square, 4 w, and of each arm, two sides and
    // an end, 12 w; a line of 4 m from the corners of the arms, shorter ones from nodes nearer to
    // the axis.
    void crossWeighsWhatItIsMadeOf()
    {
        constexpr double width = 2.0;
        const Scene scene =
            craft("cross_parachute", nylonCross({{"width", width}, {"pressure", 1.68}}));
        const Part& part = partOf(scene);
        double lines = 0.0;
        for (const Link& link : part.links)
            if (findItem<Material>(scene, link.material)->name == "suspension line")
                lines += link.restLength;
        QVERIFY(lines > 28.0 * 3.8 && lines < 28.0 * 4.0);
        const double density = number("mil_7020_1", "arealDensity");
        const double expected = density * 5.0 * width * width + 0.02 * density * 16.0 * width
                                + number("mil_5040_1", "linearDensity") * lines + 10.0;
        QVERIFY2(std::abs(massOf(part) / expected - 1.0) < 1e-9,
                 qPrintable(QString("%1 of %2 kg").arg(massOf(part)).arg(expected)));
    }

    // Cloth by its area, three tubes by their lengths.
    void gliderWeighsWhatItIsMadeOf()
    {
        const Scene scene = craft("hang_glider", dacron({{"fittings", 9.0}}));
        const Part& part = partOf(scene);
        double tubes = 0.0;
        for (const Link& link : part.links)
            if (findItem<Material>(scene, link.material)->name == "tube")
                tubes += link.restLength;
        // the keel has 4 m and a little more, as it is bent by its reflex
        const double edge = std::hypot(4.8, 4.0, 4.8 * std::tan(3.0 * pi / 180.0));
        QVERIFY(std::abs(tubes - (2.0 * edge + 4.0)) < 0.01 * tubes);
        const double expected = ClothArea(part).whole() * number("dacron_sail", "arealDensity")
                                + tubes * number("aluminium_50", "linearDensity") + 9.0 + 65.0;
        QVERIFY2(std::abs(massOf(part) / expected - 1.0) < 1e-9,
                 qPrintable(QString("%1 of %2 kg").arg(massOf(part)).arg(expected)));
    }

    // Two on each side, from one post to nodes of the trailing edge, as long as the way there as it
    // is cut. With a slack each is as long as the way to a place below its node: from
    // L^2 = d^2 + 2 s h + s^2 follows how far the post stands above, whatever the slack.
    void luffLinesAreAsLongAsTheSailIsCut()
    {
        const auto linesOf = [](double slack) {
            const Scene scene =
                craft("hang_glider", dacron({{"luff_lines", 2.0}, {"luff_slack", slack}}));
            std::vector<Link> lines;
            for (const Link& link : partOf(scene).links)
                if (link.resists == Resists::Tension
                    && findItem<Material>(scene, link.material)->name == "wire")
                    lines.push_back(link);
            return std::pair(scene, lines);
        };
        const auto [scene, taut] = linesOf(0.0);
        const auto slack = linesOf(0.1).second, slacker = linesOf(0.3).second;
        QCOMPARE(taut.size(), std::size_t(4));
        QCOMPARE(linesOf(0.0).first, scene);
        const Part& part = partOf(scene);
        const auto isOnHem = [&](Id node) {
            return std::ranges::any_of(part.links, [&](const Link& link) {
                return (link.from == node || link.to == node)
                       && findItem<Material>(scene, link.material)->name == "hem";
            });
        };
        for (std::size_t i = 0; i < taut.size(); ++i) {
            QCOMPARE(taut[i].from, taut[0].from);
            QVERIFY(isOnHem(taut[i].to));
            const Vec3 way = findRow(part.particles, taut[i].to)->position
                             - findRow(part.particles, taut[i].from)->position;
            QVERIFY(std::abs(taut[i].restLength - way.norm()) < 1e-9);
            const auto above = [&](const Link& line, double s) {
                return (line.restLength * line.restLength - way.squaredNorm() - s * s) / (2.0 * s);
            };
            QVERIFY(above(slack[i], 0.1) > 0.0);
            QVERIFY(std::abs(above(slack[i], 0.1) - above(slacker[i], 0.3)) < 1e-9);
        }
        QCOMPARE(partOf(craft("hang_glider", {{"luff_lines", 2.0}})).links,
                 partOf(craft("hang_glider", {})).links); // an ideal sail holds itself
    }

    // The warp of flat cloth runs along the middle of each gore, or at the grain to it. The picture
    // that is printed on it is the cloth as it is cut.
    void warpFollowsTheGores_data()
    {
        QTest::addColumn<double>("grain");
        QTest::newRow("block cut") << 0.0;
        QTest::newRow("bias cut") << 45.0;
    }

    void warpFollowsTheGores()
    {
        QFETCH(double, grain);
        const Scene scene =
            craft("parachute", nylon({{"grain", grain}, {"pressure", 1.68}, {"rings", 12.0}}));
        const Part& part = partOf(scene);
        QCOMPARE(part.carrier, FabricKind::Panels);
        for (const Panel& panel : part.panels) {
            Eigen::Vector2d middle = Eigen::Vector2d::Zero();
            for (const Id corner : {panel.a, panel.b, panel.c}) {
                const Particle& row = *findRow(part.particles, corner);
                middle += Eigen::Vector2d(row.textureU - 0.5, row.textureV - 0.5) / 3.0;
            }
            const double along = middleOfGore(middle.x(), middle.y());
            const double off = std::remainder(
                warpOnPicture(part, panel) - along - grain * pi / 180.0, pi); // it runs both ways
            QVERIFY2(std::abs(off) < 1e-6, qPrintable(QString("%1 rad").arg(off)));
        }
    }

    // The gores of a cap are planes from ring to ring, so the warp lies in the plane through the
    // axis and the middle of its gore.
    void warpFollowsTheGoresOfACap()
    {
        const Scene scene = craft("parachute", nylon({{"rings", 12.0}}));
        const Part& part = partOf(scene);
        for (const Panel& panel : part.panels) {
            const auto at = [&](Id id) { return findRow(part.particles, id)->position; };
            const Vec3 ab = at(panel.b) - at(panel.a), ac = at(panel.c) - at(panel.a);
            const Vec3 along = ab.normalized();
            const Vec3 across = (ac - ac.dot(along) * along).normalized();
            const double grain = panel.grain * pi / 180.0;
            const Vec3 warp = std::cos(grain) * along + std::sin(grain) * across;
            const Vec3 middle = (at(panel.a) + at(panel.b) + at(panel.c)) / 3.0;
            const double turn = middleOfGore(middle.x(), middle.z());
            QVERIFY(std::abs(warp.dot(Vec3(-std::sin(turn), 0.0, std::cos(turn)))) < 1e-9);
        }
    }

    // The halves of a sail are cut as mirror images.
    void warpFollowsTheTrailingEdge_data()
    {
        QTest::addColumn<double>("grain");
        QTest::newRow("along the trailing edge") << 0.0;
        QTest::newRow("at an angle") << 30.0;
        QTest::newRow("along the keel") << 90.0;
    }

    void warpFollowsTheTrailingEdge()
    {
        QFETCH(double, grain);
        // flat, so that the picture is the cloth but for its two scales, 9.6 m and 4 m
        const Scene scene = craft("hang_glider", dacron({{"grain", grain},
                                                         {"billow", 0.0},
                                                         {"washout", 0.0},
                                                         {"reflex", 0.0},
                                                         {"dihedral", 0.0}}));
        const Part& part = partOf(scene);
        for (const Panel& panel : part.panels) {
            std::array<Eigen::Vector2d, 3> at;
            double side = 0.0;
            for (int corner = 0; corner < 3; ++corner) {
                const Particle& row = *findRow(
                    part.particles, std::array{panel.a, panel.b, panel.c}[std::size_t(corner)]);
                at[std::size_t(corner)] = {9.6 * (row.textureU - 0.5), 4.0 * row.textureV};
                side += row.textureU - 0.5;
            }
            const Eigen::Vector2d ab = at[1] - at[0], ac = at[2] - at[0];
            const double hand = ab.x() * ac.y() - ab.y() * ac.x() > 0.0 ? 1.0 : -1.0;
            const double warp =
                std::atan2(ab.y(), ab.x()) + hand * panel.grain * pi / 180.0; // from the right
            const double wanted = (side > 0.0 ? -1.0 : 1.0) * grain * pi / 180.0;
            QVERIFY(std::abs(std::remainder(warp - wanted, pi)) < 1e-6);
        }
    }

    void nothingIsIdealInARealCraft_data()
    {
        QTest::addColumn<QByteArray>("builder");
        QTest::addColumn<Parameters>("given");
        QTest::newRow("parachute") << QByteArray("parachute") << nylon({{"pressure", 1.68}});
        QTest::newRow("cross parachute")
            << QByteArray("cross_parachute") << nylonCross({{"pressure", 1.68}});
        QTest::newRow("square parachute")
            << QByteArray("cross_parachute") << nylonCross({{"pressure", 1.68}, {"arms", 0.0}});
        QTest::newRow("hang glider") << QByteArray("hang_glider") << dacron();
    }

    void nothingIsIdealInARealCraft()
    {
        QFETCH(QByteArray, builder);
        QFETCH(Parameters, given);
        const Scene scene = craft(builder, given);
        QVERIFY(problemsOf(scene).empty());
        const auto system = compile(scene);
        QVERIFY(bool(system));
        for (const Rod& rod : (*system)->rods)
            QVERIFY(rod.compliance > 0.0);
        for (const Entry& entry : scene.items)
            if (const Material* material = std::get_if<Material>(&entry.item))
                QVERIFY2(material->name != "seams", "nothing is made of it");
    }
};

const RegisteredTest registered("test_real_craft", runPlain<TestRealCraft>);

} // namespace ripstop::test_real_craft
#include "test_real_craft.moc"
