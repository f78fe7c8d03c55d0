// Physical numbers of materials: links follow from them, whatever the mesh.
#include "model/systems.h"

#include "builders/builder.h"
#include "compile/compile.h"
#include "io/scene_file.h"
#include "measure/diagnostics.h"
#include "run/simulation.h"
#include "scene/link_stiffness.h"
#include "scene/presets.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace ripstop;

namespace {

constexpr double gravity = 9.80665; // m/s^2
constexpr double density = 0.25;    // kg/m^2
constexpr double membrane = 1000.0; // N/m

// A sheet of 1 m x 1 m of the same material at any resolution.
Parameters sheet(int cells, double hang, double shear)
{
    return {{"columns", cells},   {"rows", cells}, {"hang", hang},         {"shear", shear},
            {"density", density}, {"bend", 0},     {"membrane", membrane}, {"stiffness", 1},
            {"sphere", 0},        {"level", 2}};
}

Part& partOf(Scene& scene)
{
    for (Entry& entry : scene.items)
        if (Part* part = std::get_if<Part>(&entry.item))
            return *part;
    std::abort();
}

std::vector<Id> materialsOf(const Scene& scene)
{
    std::vector<Id> ids;
    for (const Entry& entry : scene.items)
        if (std::holds_alternative<Material>(entry.item))
            ids.push_back(entry.id);
    return ids;
}

State settled(const Scene& scene, double seconds)
{
    Simulation simulation(*compile(scene, 1, 1));
    (void)simulation.runUntil(seconds);
    return simulation.state();
}

void addResolutions()
{
    QTest::addColumn<int>("cells");
    QTest::newRow("10 x 10") << 10;
    QTest::newRow("20 x 20") << 20;
    QTest::newRow("40 x 40") << 40;
}

#define NEAR(got, expected, share)                                                                 \
    QVERIFY2(isNear(got, expected, (share)*std::abs(expected)), told(got, expected))

} // namespace

class TestMaterials : public QObject
{
    Q_OBJECT

private slots:
    // k = EA / L, and Y w / L without shear; G D^2 / (2 p q) on a diagonal
    void stiffnessOfOneLink()
    {
        Material m;
        m.stiffness = 7.0;
        m.compliance = 0.3;
        QCOMPARE(springStiffness(m, LinkRole::Line, 0.0, 2.0), 7.0);
        QCOMPARE(rodCompliance(m, LinkRole::Thread, 0.1, 2.0), 0.3);
        m.axialStiffness = 1e4;
        m.membraneStiffness = 600.0;
        QCOMPARE(springStiffness(m, LinkRole::Line, 0.0, 2.0), 5000.0);
        QCOMPARE(rodCompliance(m, LinkRole::Line, 0.0, 2.0), 2e-4);
        QCOMPARE(springStiffness(m, LinkRole::Thread, 0.1, 0.2), 300.0);
        QCOMPARE(springStiffness(m, LinkRole::Bias, 0.1, 0.2), 7.0); // no shear stiffness
        m.shearStiffness = 50.0;
        QCOMPARE(springStiffness(m, LinkRole::Bias, biasWidth(0.3, 0.4), 0.5),
                 50.0 * 0.25 / (2.0 * 0.12));
        // nothing to divide by
        QCOMPARE(springStiffness(m, LinkRole::Thread, 0.0, 0.2), 7.0);
        QCOMPARE(springStiffness(m, LinkRole::Line, 0.0, 0.0), 7.0);
        QCOMPARE(rodCompliance(m, LinkRole::Line, 0.0, 0.0), 0.3);
    }

    void whatALinkSaysItselfWins()
    {
        Scene scene = *build(*findBuilder("cloth"), sheet(2, 2, 0.3));
        partOf(scene).links[0].stiffness = 3.0;
        const auto compiled = compile(scene, 1, 1);
        QCOMPARE((*compiled)->springs[std::size_t((*compiled)->links[0].index)].stiffness, 3.0);
        QVERIFY((*compiled)->springs[std::size_t((*compiled)->links[1].index)].stiffness > 100.0);
    }

    void weighsTheSame_data() { addResolutions(); }
    void weighsTheSame()
    {
        QFETCH(int, cells);
        const auto compiled = compile(*build(*findBuilder("cloth"), sheet(cells, 2, 0.3)), 1, 1);
        const auto& mass = (*compiled)->mass;
        NEAR(std::accumulate(mass.begin(), mass.end(), 0.0), density, 1e-12);
    }

    // A strip that is strained by e along and by -nu e across, nu = C12 / C11, C12 = G,
    // C11 - C12^2 / C11 = E t, is at rest: no force but at the ends, and there E t W e.
    void stripPulledEvenly_data() { addResolutions(); }
    void stripPulledEvenly()
    {
        QFETCH(int, cells);
        const double shear = 0.3; // G / (E t)
        const auto compiled = compile(*build(*findBuilder("cloth"), sheet(cells, 2, shear)), 1, 1);
        const System& system = **compiled;
        State state = system.start;
        const double e = 1e-6;
        const double nu = shear / (0.5 * (1.0 + std::sqrt(1.0 + 4.0 * shear * shear)));
        for (auto& x : state.position)
            x = Vec3(x.x() * (1.0 + e), x.y(), x.z() * (1.0 - nu * e));
        std::vector<Vec3> force(system.mass.size(), Vec3::Zero());
        const std::vector<double> tension = tensions(system, state);
        for (std::size_t i = 0; i < system.links.size(); ++i) {
            const auto a = std::size_t(system.links[i].a);
            const auto b = std::size_t(system.links[i].b);
            const Vec3 along = Vec3(state.position[b] - state.position[a]).normalized();
            force[a] += tension[i] * along;
            force[b] -= tension[i] * along;
        }
        double pull = 0.0;
        for (std::size_t i = 0; i < force.size(); ++i) {
            if (i % std::size_t(cells + 1) == 0)
                pull += force[i].x();
            else if (i % std::size_t(cells + 1) != std::size_t(cells))
                QVERIFY(force[i].norm() < 1e-4 * membrane * e / cells);
        }
        NEAR(pull, membrane * e, 1e-4);
    }

    // F = E t W strain. Held ends keep the strip from becoming narrower, which makes it stiffer by
    // less than nu^2 = 0.0025.
    void stripBetweenGrips_data() { addResolutions(); }
    void stripBetweenGrips()
    {
        QFETCH(int, cells);
        Scene scene = *build(*findBuilder("cloth"), sheet(cells, 3, 0.05));
        scene.settings.gravity = Vec3::Zero();
        scene.settings.viscosity = 60.0;
        for (Particle& particle : partOf(scene).particles)
            particle.position.x() *= 1.01;
        const auto compiled = compile(scene, 1, 1);
        const State state = settled(scene, 0.3);
        const std::vector<double> tension = tensions(**compiled, state);
        double pull = 0.0;
        for (std::size_t i = 0; i < tension.size(); ++i) {
            const LinkPlace& link = (*compiled)->links[i];
            const Vec3 along =
                Vec3(state.position[std::size_t(link.b)] - state.position[std::size_t(link.a)]);
            if (link.a % (cells + 1) == 0 || link.b % (cells + 1) == 0)
                pull += tension[i] * std::abs(along.x()) / along.norm();
        }
        NEAR(pull, membrane * 0.01, 0.01);
    }

    // Level between two edges it hangs as a parabola of sag s: the tension per width is
    // T = w W^2 / (8 s) = E t 8 s^2 / (3 W^2), so s^3 = 3 w W^4 / (64 E t), w = density g.
    void sagsTheSame_data() { addResolutions(); }
    void sagsTheSame()
    {
        QFETCH(int, cells);
        Scene scene = *build(*findBuilder("cloth"), sheet(cells, 3, 0.05));
        scene.settings.viscosity = 20.0;
        scene.settings.airDensity = 0.0;
        const State state = settled(scene, 2.0);
        const std::size_t middle = std::size_t((cells + 1) * (cells / 2) + cells / 2);
        const double sag = 2.0 - state.position[middle].y();
        NEAR(sag, std::cbrt(3.0 * density * gravity / (64.0 * membrane)), 0.03);
    }

    // T-R2: a rope of mass M grows by M g L / (2 EA) of its own weight. With half a share of mass
    // at the lower end that holds exactly at any number of segments.
    void hangingRope_data()
    {
        QTest::addColumn<int>("segments");
        QTest::addColumn<bool>("springs");
        for (const int segments : {5, 20, 80})
            for (const bool springs : {true, false})
                QTest::addRow("%d %s", segments, springs ? "springs" : "rods")
                    << segments << springs;
    }
    void hangingRope()
    {
        QFETCH(int, segments);
        QFETCH(bool, springs);
        Scene scene = *build(*findBuilder("rope"), {{"segments", segments},
                                                    {"length", 10},
                                                    {"density", 0.1},
                                                    {"axial", 1e4},
                                                    {"angle", 0}});
        scene.settings.viscosity = 50.0;
        scene.settings.airDensity = 0.0;
        scene.settings.substeps = 20;
        scene.settings.solver = Solver::Direct;
        if (springs)
            for (Link& link : partOf(scene).links)
                link.kind = LinkKind::Spring;
        const State state = settled(scene, 1.0);
        // the rope's ends come first
        const double length = (state.position[0] - state.position[1]).norm();
        NEAR(length - 10.0, 4.903325e-3, 1e-3);
    }

    void presetsSetWhatThereIs()
    {
        std::vector<std::string> names;
        for (const Preset& preset : allPresets()) {
            QVERIFY2(!preset.source.empty(), preset.name.c_str());
            QVERIFY2(std::find(names.begin(), names.end(), preset.name) == names.end(),
                     preset.name.c_str());
            names.push_back(preset.name);
            for (const auto& [key, value] : preset.values) {
                const Property* property = findProperty(Kind::Material, key);
                QVERIFY2(property, preset.name.c_str());
                QVERIFY2(!refusal(*property, value), preset.name.c_str());
            }
        }
        QVERIFY(findPreset("skytex_26").message().find("skytex_2") != std::string::npos);
    }

    // Numbers that the table derives, worked out by hand from the same sources.
    void numbersOfPresets_data()
    {
        QTest::addColumn<QString>("preset");
        QTest::addColumn<QString>("key");
        QTest::addColumn<double>("expected");
        QTest::addColumn<double>("share"); // as far as those were rounded
        QTest::newRow("LTC80 EA at 300 N") << "liros_ltc80"
                                           << "axialStiffness" << 18.2e3 << 0.005;
        QTest::newRow("LTC80 0.43 g/m") << "liros_ltc80"
                                        << "linearDensity" << 0.43e-3 << 0.01;
        QTest::newRow("LTC120 0.98 g/m") << "liros_ltc120"
                                         << "linearDensity" << 0.98e-3 << 0.01;
        QTest::newRow("TSL140 EA at 300 N") << "liros_tsl140"
                                            << "axialStiffness" << 34e3 << 0.01;
        QTest::newRow("TSL280 EA") << "liros_tsl280"
                                   << "axialStiffness" << 65e3 << 0.01;
        QTest::newRow("7075 tube 0.327 kg/m") << "aluminium_42"
                                              << "linearDensity" << 0.327 << 0.002;
        // E pi (D^4 - d^4) / 64 of 42 and 40.2 mm, 71.7 GPa
        QTest::newRow("7075 tube EI") << "aluminium_42"
                                      << "flexuralRigidity" << 1760.0 << 0.002;
        QTest::newRow("P100 EI") << "skyshark_p100"
                                 << "flexuralRigidity" << 5.09 << 1e-9;
        // EI = E pi d^4 / 64 with E 122 GPa
        QTest::newRow("carbon 3 mm EI")
            << "carbon_rod_3"
            << "flexuralRigidity" << 122e9 * std::acos(-1.0) * 81e-12 / 64 << 0.01;
        QTest::newRow("7020 I 37.3 g/m2") << "mil_7020_1"
                                          << "arealDensity" << 37.3e-3 << 1e-9;
        // (EI = 1.95 N m2, 50 GPa, 6 mm) gives a bore of 4.73 mm
        QTest::newRow("tube 6 mm EA")
            << "fibreglass_tube_6"
            << "axialStiffness" << 50e9 * std::acos(-1.0) / 4 * (36e-6 - 22.4e-6) << 0.01;
    }
    void numbersOfPresets()
    {
        QFETCH(QString, preset);
        QFETCH(QString, key);
        QFETCH(double, expected);
        QFETCH(double, share);
        for (const auto& [name, value] : (*findPreset(preset.toStdString()))->values)
            if (name == key.toStdString()) {
                NEAR(std::get<double>(value), expected, share);
                return;
            }
        QFAIL("has no such number");
    }

    void presetWeighsAnewAndIsUndone_data() { addResolutions(); }
    void presetWeighsAnewAndIsUndone()
    {
        QFETCH(int, cells);
        Scene scene = *build(*findBuilder("cloth"), sheet(cells, 2, 0.3));
        const Scene before = scene;
        const auto made = presetEdit(scene, **findPreset("skytex_38"), materialsOf(scene));
        QVERIFY(made->notWeighed.empty());
        const Edit undo = apply(scene, made->edit);
        double mass = 0.0;
        for (const Particle& particle : partOf(scene).particles)
            mass += particle.mass;
        NEAR(mass, 0.038, 1e-12);
        // threads of a strip W between the edges: E t W / L each, but for what the bias takes
        const auto compiled = compile(scene, 1, 1);
        const double g = 1.0 / 38.0;
        const double thread = 4e4 * (0.5 * (1.0 + std::sqrt(1.0 + 4.0 * g * g)) - g);
        double sum = 0.0;
        for (std::size_t i = 0; i < (*compiled)->links.size(); ++i) {
            const LinkPlace& link = (*compiled)->links[i];
            if (link.a % (cells + 1) == 0 && link.b == link.a + 1)
                sum += (*compiled)->springs[std::size_t(link.index)].stiffness;
        }
        NEAR(sum, thread * cells, 1e-12);
        (void)apply(scene, undo);
        QVERIFY(scene == before);
    }

    // Validation 3.4: c = (B / (rho g))^(1/3), mm, as it says for each.
    void bendingLengths_data()
    {
        QTest::addColumn<double>("expected");
        QTest::newRow("gray_interlock") << 23.3;
        QTest::newRow("navy_sparkle_sweat") << 30.0;
        QTest::newRow("camel_ponte_roma") << 23.5;
        QTest::newRow("ivory_rib_knit") << 25.8;
        QTest::newRow("white_swim_solid") << 31.1;
        QTest::newRow("tango_red_jet_set") << 23.4;
        QTest::newRow("pink_ribbon_brown") << 37.4;
        QTest::newRow("denim_11oz") << 27.2;
        QTest::newRow("white_dots_on_black") << 34.5;
        QTest::newRow("royal_target") << 38.7;
    }
    void bendingLengths()
    {
        QFETCH(double, expected);
        Scene scene = *build(*findBuilder("cloth"), sheet(2, 2, 0.3));
        const std::vector<Id> materials = materialsOf(scene);
        const auto made = presetEdit(scene, **findPreset(QTest::currentDataTag()), materials);
        (void)apply(scene, made->edit);
        const Material& material = *findItem<Material>(scene, materials.front());
        const double length =
            1e3 * std::cbrt(material.bendingStiffness / (*material.arealDensity * gravity));
        QVERIFY2(isNear(length, expected, 0.06), told(length, expected));
    }

    void particlesOfUnknownDensityKeepTheirMass()
    {
        Scene scene = *build(*findBuilder("rope"), {{"segments", 4}});
        const Id cord = materialsOf(scene).front();
        std::get<Material>(*findItem(scene, cord)).linearDensity.reset();
        const Part before = partOf(scene);
        const auto made = presetEdit(scene, **findPreset("liros_ltc80"), {cord});
        QCOMPARE(made->notWeighed, std::vector<Id>{cord});
        (void)apply(scene, made->edit);
        QVERIFY(partOf(scene) == before);
        QCOMPARE(*findItem<Material>(scene, cord)->axialStiffness, 300.0 / 0.0165);
        QVERIFY(!findItem<Material>(scene, cord)->linearDensity);
    }

    void presetLeavesNothingOfTheOneBefore()
    {
        Scene scene = *build(*findBuilder("rope"), {{"segments", 4}});
        const std::vector<Id> cord = materialsOf(scene);
        (void)apply(scene, presetEdit(scene, **findPreset("liros_ltc80"), cord)->edit);
        double mass = 0.0;
        for (const Particle& particle : partOf(scene).particles)
            mass += particle.mass;
        NEAR(mass, 2.0 * 1e-3 * (0.134 * 0.7 + 0.6859 * 0.49), 1e-9);
        (void)apply(scene, presetEdit(scene, **findPreset("denim_11oz"), cord)->edit);
        const Material& material = *findItem<Material>(scene, cord.front());
        QVERIFY(!material.axialStiffness && !material.shearStiffness);
        QCOMPARE(*material.membraneStiffness, 2028.0);
        QCOMPARE(material.tearRule, TearRule::Never);
        QCOMPARE(material.diameter, 0.0);
        (void)apply(scene, presetEdit(scene, **findPreset("mil_7020_1"), cord)->edit);
        QVERIFY(material.porosity > 0.0);
        (void)apply(scene, presetEdit(scene, **findPreset("dyneema_1"), cord)->edit);
        QCOMPARE(material.porosity, 0.0);
    }

    // Whatever came before, a material with a preset is what the preset makes of a new one.
    void presetSetsWhatAnyPresetSets()
    {
        const Scene scene = *build(*findBuilder("rope"), {{"segments", 4}});
        const std::vector<Id> cord = materialsOf(scene);
        for (const Preset& preset : allPresets()) {
            Scene fresh = scene;
            (void)apply(fresh, presetEdit(fresh, preset, cord)->edit);
            for (const Preset& before : allPresets()) {
                Scene used = scene;
                (void)apply(used, presetEdit(used, before, cord)->edit);
                (void)apply(used, presetEdit(used, preset, cord)->edit);
                Material got = *findItem<Material>(used, cord.front());
                const Material wanted = *findItem<Material>(fresh, cord.front());
                // what the particles were given is known until they are weighed anew
                got.arealDensity = wanted.arealDensity;
                got.linearDensity = wanted.linearDensity;
                QVERIFY2(got == wanted, (before.name + ", " + preset.name).c_str());
            }
        }
    }

    void lighterThanNothingIsRefused()
    {
        Scene scene = *build(*findBuilder("rope"), {{"segments", 4}});
        const std::vector<Id> cord = materialsOf(scene);
        for (Particle& particle : partOf(scene).particles)
            particle.mass = 1e-5;
        const auto made = presetEdit(scene, **findPreset("liros_ltc80"), cord);
        QVERIFY(!made && made.message().find("weighs less") != std::string::npos);
    }

    void commandLine()
    {
        const QTemporaryDir folder;
        const QString cloth = folder.filePath("cloth.ripstop.json");
        QVERIFY(!saveScene(*build(*findBuilder("cloth"), sheet(3, 2, 0.3)), cloth.toStdString()));
        const QString out = folder.filePath("new.ripstop.json");
        const QStringList given{"presets", cloth, "--apply", "skytex_27", "-o", out};
        const auto exitCode = [](const QStringList& arguments) {
            QProcess process;
            process.start(CLI_PROGRAM, arguments);
            return process.waitForFinished() ? process.exitCode() : -1;
        };
        QCOMPARE(exitCode({"presets"}), 0);
        QCOMPARE(exitCode({"presets", "--json"}), 0);
        QCOMPARE(exitCode(given), 2); // which material?
        QCOMPARE(exitCode(given + QStringList{"--material", "clth"}), 2);
        QCOMPARE(exitCode({"presets", cloth, "--apply", "skytex", "-o", out}), 2);
        QCOMPARE(exitCode({"presets", cloth, "--material", "cloth", "-o", out}), 2); // which one?
        QCOMPARE(exitCode({"presets", cloth}), 2);
        QVERIFY(!QFile::exists(out));
        QCOMPARE(exitCode(given + QStringList{"--material", "cloth", "--material", "structural"}),
                 0);
        const Result<Scene> read = readScene(out.toStdString());
        const auto material = [&](std::size_t i) {
            return *findItem<Material>(*read, materialsOf(*read)[i]);
        };
        QCOMPARE(*material(0).arealDensity, 0.027);
        QCOMPARE(*material(1).membraneStiffness, 4e4);
        QCOMPARE(*material(2).membraneStiffness, membrane); // shear was not asked for
    }
};

QTEST_APPLESS_MAIN(TestMaterials)
#include "test_materials.moc"
