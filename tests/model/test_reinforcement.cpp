// Patches on craft of real cloth: what they weigh, where they lie, and what a patched corner bears.
//
// Stages: masses of every builder that has them; their place on a fine mesh; the strength of two
// layers, on strips that are drawn until they tear; a kite that tears at its line and one that a
// patch holds; what is refused.
#include "builders/reinforcement.h"

#include "check/check.h"
#include "model/real_craft.h"
#include "model/systems.h"
#include "model/tensile_strip.h"
#include "registered_test.h"

#include <QtTest>

#include <cmath>

namespace ripstop::test_reinforcement {

namespace {

Parameters patched(const char* builder, double patch, const Parameters& more = {})
{
    Parameters given = newDesign(*findBuilder(builder), more);
    given["patch"] = patch;
    return given;
}

bool isPatch(const Scene& scene, const Panel& panel)
{
    return findItem<Material>(scene, panel.material)->name.ends_with(" patch");
}

// m^2, of the cloth as it is cut: by the sides of its panels, after Heron.
double patchedArea(const Scene& scene)
{
    double area = 0.0;
    for (const Panel& panel : partOf(scene).panels) {
        const double a = panel.restAB, b = panel.restBC, c = panel.restCA;
        const double s = 0.5 * (a + b + c);
        if (isPatch(scene, panel))
            area += std::sqrt(s * (s - a) * (s - b) * (s - c));
    }
    return area;
}

Material numbersOf(const char* preset)
{
    Material material;
    give(material, **findPreset(preset));
    return material;
}

// Whether a strip of this cloth tears by its strength under `pull`, N/m, along its warp.
bool tears(const Material& cloth, double pull)
{
    Strip made = strip(coarse, 0.0, pull * width);
    Material& material = made.cloth();
    material.membraneStiffness = cloth.membraneStiffness;
    material.weftStiffness = cloth.weftStiffness;
    material.warpStrength = cloth.warpStrength;
    material.weftStrength = cloth.weftStrength;
    material.tearRule = TearRule::Strength;
    Simulation simulation(*compile(made.scene));
    if (!simulation.runUntil(3.0))
        qFatal("it did not hang");
    return !simulation.state().tears.empty();
}

} // namespace

class TestReinforcement : public QObject
{
    Q_OBJECT

private slots:
    void massesAddUp_data()
    {
        QTest::addColumn<QByteArray>("builder");
        for (const char* builder : {"delta_kite", "diamond_kite", "rectangular_kite", "hang_glider",
                                    "parachute", "cross_parachute"})
            QTest::newRow(builder) << QByteArray(builder);
    }

    // What a patch weighs is its areal density times what it covers.
    void massesAddUp()
    {
        QFETCH(QByteArray, builder);
        const Scene plain = craft(builder, patched(builder, 0.0));
        const Scene scene = craft(builder, patched(builder, 2.0));
        QVERIFY(problemsOf(scene).empty());
        QCOMPARE(patchedArea(plain), 0.0);
        const double area = patchedArea(scene);
        QVERIFY(area > 0.0);
        const auto choices = parameterOf(builder, "patch").choices;
        const double expected = number(std::string(choices[2]).c_str(), "arealDensity") * area;
        const double more = massOf(partOf(scene)) - massOf(partOf(plain));
        QVERIFY2(std::abs(more / expected - 1.0) < 1e-9,
                 qPrintable(QString("%1 of %2 kg").arg(more).arg(expected)));
    }

    // Quarters of a circle in four corners, and four circles where the bridle is tied: 5 pi r^2.
    void liesWhereItIsPulled()
    {
        constexpr double radius = 0.1; // m
        const Scene scene = craft(
            "rectangular_kite",
            patched("rectangular_kite", 1.0,
                    {{"columns", 60.0}, {"rows", 60.0}, {"bow", 0.0}, {"patch_radius", radius}}));
        const double expected = 5.0 * pi * radius * radius;
        const double area = patchedArea(scene);
        QVERIFY2(std::abs(area / expected - 1.0) < 0.03,
                 qPrintable(QString("%1 of %2 m^2").arg(area).arg(expected)));
    }

    void idealClothHasNone()
    {
        for (const char* builder : {"delta_kite", "hang_glider", "parachute", "cross_parachute"})
            QCOMPARE(partOf(craft(builder, {{"patch", 2.0}})).panels,
                     partOf(craft(builder, {})).panels);
    }

    // Both layers are stretched alike, E = E1 + E2, and the first breaks at N = E min(N1/E1,
    // N2/E2). The corner tears at that load, so that the ratio of loads is that of the strengths: 2
    // of the same cloth; of another one 46 of 40 kN/m more stiffness, and the cloth that breaks
    // first.
    void cornerTearsByTheRatioOfStrengths_data()
    {
        QTest::addColumn<QByteArray>("patch");
        QTest::newRow("the same cloth") << QByteArray("ripstop_075");
        QTest::newRow("heavier cloth") << QByteArray("ripstop_150");
        QTest::newRow("stiffer cloth") << QByteArray("surf_dacron");
    }

    void cornerTearsByTheRatioOfStrengths()
    {
        QFETCH(QByteArray, patch);
        const char* base = "ripstop_075";
        const auto at = [](const char* cloth, const char* key) { return number(cloth, key); };
        const double lower = at(base, "membraneStiffness");
        const double upper = at(patch, "membraneStiffness");
        const double ratio =
            (lower + upper)
            * std::min(at(base, "warpStrength") / lower, at(patch, "warpStrength") / upper)
            / at(base, "warpStrength");
        qInfo("bears %.2f times as much", ratio);
        if (patch == base)
            QCOMPARE(ratio, 2.0);
        const Material single = numbersOf(base);
        Material both = single;
        addLayer(both, numbersOf(patch));
        // seams keep 0.8 of it, which is the share of the lower cloth in both
        const double bears = at(base, "warpStrength");
        QVERIFY(!tears(single, 0.98 * bears) && tears(single, 1.02 * bears));
        QVERIFY(!tears(both, 0.98 * ratio * bears) && tears(both, 1.02 * ratio * bears));
    }

    // The jerk of the launch pulls at the tip of the keel with a third of what its cloth bears.
    // Where seams keep little of that it tears; doubled, it holds.
    void patchHoldsTheLine_data()
    {
        QTest::addColumn<bool>("hasPatch");
        QTest::newRow("without") << false;
        QTest::newRow("with") << true;
    }

    void patchHoldsTheLine()
    {
        QFETCH(bool, hasPatch);
        const double same = choice("delta_kite", "patch", "ripstop_075");
        Scene scene = craft("delta_kite",
                            patched("delta_kite", hasPatch ? same : 0.0,
                                    {{"wind", 12.0},
                                     {"spars", choice("delta_kite", "spars", "fibreglass_tube_8")},
                                     {"cord", choice("delta_kite", "cord", "liros_ltc400")}}));
        for (Entry& entry : scene.items)
            if (Material* cloth = std::get_if<Material>(&entry.item);
                cloth && cloth->name.starts_with("keel cloth")) {
                cloth->tearRule = TearRule::Strength;
                cloth->jointEfficiency = 0.25;
            }
        Simulation simulation(*compile(scene));
        QVERIFY(simulation.runUntil(5.0));
        QCOMPARE(simulation.state().tears.empty(), hasPatch);
    }

    void tooSmallForTheMeshIsRefused()
    {
        Parameters given = patched("delta_kite", 2.0, {{"patch_radius", 0.02}});
        const Result<Scene> scene = build(*findBuilder("delta_kite"), given);
        QVERIFY(!scene);
        QVERIFY(scene.message().english().starts_with("patch_radius: patches of 0.02 m"));
    }
};

const RegisteredTest registered("test_reinforcement", runPlain<TestReinforcement>);

} // namespace ripstop::test_reinforcement
#include "test_reinforcement.moc"
