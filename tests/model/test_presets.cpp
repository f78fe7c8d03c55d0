// Presets of materials, and weighing by their densities.
//
// Stages: what presets set and the numbers that they are derived from; then weighing by densities,
// with undo and with particles of unknown mass; one preset after another; and what is refused,
// also on the command line.
#include "model/material_sheets.h"
#include "model/sample_scenes.h"
#include "registered_test.h"

#include "builders/builder.h"
#include "compile/compile.h"
#include "derived/link_stiffness.h"
#include "io/scene_file.h"
#include "materials/presets.h"
#include "measure/diagnostics.h"
#include "scene/path.h"
#include "scene/weigh.h"
#include "simulation/simulation.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ripstop::test_presets {

class TestPresets : public QObject
{
    Q_OBJECT

private slots:
    void presetsSetWhatThereIs()
    {
        std::vector<std::string> names;
        for (const Preset& preset : allPresets()) {
            QVERIFY2(std::find(names.begin(), names.end(), preset.name) == names.end(),
                     preset.name.c_str());
            names.push_back(preset.name);
            for (const PresetNumber& number : preset.values) {
                const Property* property = findProperty(Kind::Material, number.key);
                QVERIFY2(property, preset.name.c_str());
                QVERIFY2(!refusal(*property, number.value), preset.name.c_str());
                QVERIFY2(!number.source.empty(), preset.name.c_str());
            }
        }
        QVERIFY(findPreset("skytex_26").message().english().find("skytex_2") != std::string::npos);
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
        // listed masses; a fit through diameters would be 25 % less and 16 % more
        QTest::newRow("LTC80 0.57 g/m") << "liros_ltc80"
                                        << "linearDensity" << 0.57e-3 << 1e-12;
        QTest::newRow("LTC120 0.84 g/m") << "liros_ltc120"
                                         << "linearDensity" << 0.84e-3 << 1e-12;
        QTest::newRow("TSL140 EA at 300 N") << "liros_tsl140"
                                            << "axialStiffness" << 34e3 << 0.01;
        QTest::newRow("TSL280 EA") << "liros_tsl280"
                                   << "axialStiffness" << 65e3 << 0.01;
        // 7075-T6 of MIL-HDBK-5J: 71.0 GPa, 2796 kg/m^3, yields at 455 N/mm^2
        const double pi = std::acos(-1.0), outer = 42e-3, inner = 40.2e-3;
        const double area = pi / 4 * (outer * outer - inner * inner);
        const double moment = pi / 64 * (std::pow(outer, 4) - std::pow(inner, 4));
        QTest::newRow("7075 tube mass") << "aluminium_42"
                                        << "linearDensity" << 2796 * area << 0.001;
        QTest::newRow("7075 tube EI") << "aluminium_42"
                                      << "flexuralRigidity" << 71.0e9 * moment << 0.001;
        QTest::newRow("7075 tube yields")
            << "aluminium_42"
            << "breakingMoment" << 455e6 * moment / (outer / 2) << 0.001;
        // 908 g in the middle of 0.6604 m: 4 mm carbon rods of 1.54 N m^2 hold 1200 N/mm^2
        QTest::newRow("carbon 4 mm breaks") << "carbon_rod_4"
                                            << "breakingMoment" << 1200e6 * pi * 64e-9 / 32 << 0.01;
        // strip strength over 22.5 % elongation
        QTest::newRow("7020 I E t") << "mil_7020_1"
                                    << "membraneStiffness" << 7355 / 0.225 << 0.001;
        // 33.3 kgf/cm
        QTest::newRow("paraglider cloth E t") << "paraglider_ripstop"
                                              << "membraneStiffness" << 33.3 * 980.665 << 0.001;
        // v of 254.4 v + 37.6 v^2 = 124.5 Pa over sqrt(2 dp / rho)
        const double v = (-254.4 + std::sqrt(254.4 * 254.4 + 4 * 37.6 * 124.5)) / (2 * 37.6);
        QTest::newRow("7020 III leaks") << "mil_7020_3"
                                        << "porosity" << v / std::sqrt(2 * 124.5 / 1.225) << 0.002;
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
        for (const PresetNumber& number : (*findPreset(preset.toStdString()))->values)
            if (number.key == key.toStdString()) {
                NEAR(std::get<double>(number.value), expected, share);
                return;
            }
        QFAIL("has no such number");
    }

    void presetWeighsAnewAndIsUndone_data() { addResolutions(); }
    void presetWeighsAnewAndIsUndone()
    {
        QFETCH(int, cells);
        Scene scene = *build(*findBuilder("cloth"), sheet(cells, 2, 0.3));
        scene.settings.integrator = Integrator::SemiImplicitEuler; // springs stay forces
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
        const double g = 859.0 / 32660.0;
        const double thread = 32660.0 * (0.5 * (1.0 + std::sqrt(1.0 + 4.0 * g * g)) - g);
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

    void anotherDensityWeighsAnew()
    {
        Scene scene = *build(*findBuilder("cloth"), sheet(6, 2, 0.3));
        const auto mass = [&] {
            double sum = 0.0;
            for (const Particle& particle : partOf(scene).particles)
                sum += particle.mass;
            return sum;
        };
        partOf(scene).particles[5].mass += 1.0; // a load that somebody hung there
        Scene before = scene;
        const Edit undo = apply(scene, *assignment(scene, "cloth.arealDensity=0.04"));
        NEAR(mass(), 1.04, 1e-12);
        NEAR(partOf(scene).particles[24].mass, partOf(before).particles[24].mass * 0.04 / density,
             1e-12);
        (void)apply(scene, undo);
        QVERIFY(scene == before);
        // of a material of unknown density it is only noted
        (void)apply(scene, *assignment(scene, "cloth.arealDensity="));
        (void)apply(scene, *assignment(scene, "cloth.arealDensity=0.04"));
        NEAR(mass(), density + 1.0, 1e-12);
        // and a density that the particles cannot have had is refused
        for (Particle& particle : partOf(scene).particles)
            particle.mass = 1e-5;
        QVERIFY(assignment(scene, "cloth.arealDensity=0.01").message().english().find("weighs less")
                != std::string::npos);
    }

    void weighingTakesTheDensities_data() { addResolutions(); }
    void weighingTakesTheDensities()
    {
        QFETCH(int, cells);
        Scene scene = *build(*findBuilder("cloth"), sheet(cells, 2, 0.3));
        const Part before = partOf(scene);
        Part& part = partOf(scene);
        // a particle that belongs to no link
        part.particles.push_back({takeId(scene), Vec3(5.0, 5.0, 5.0)});
        for (Particle& particle : part.particles)
            particle.mass = 0.7;
        (void)apply(scene, weighing(scene));
        NEAR(part.particles.back().mass, 0.7, 1e-12);
        double sum = 0.0;
        for (std::size_t i = 0; i + 1 < part.particles.size(); ++i) {
            NEAR(part.particles[i].mass, before.particles[i].mass, 1e-12);
            sum += part.particles[i].mass;
        }
        NEAR(sum, density, 1e-12);
        Scene rope = *build(*findBuilder("rope"), {{"segments", cells}, {"density", 0.05}});
        for (Particle& particle : partOf(rope).particles)
            particle.mass = 3.0;
        (void)apply(rope, weighing(rope));
        NEAR(partOf(rope).particles.front().mass, 0.05 / cells, 1e-9); // 2 m, half a segment
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
        NEAR(mass, 2.0 * 0.57e-3, 1e-9); // 2 m
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
    void whatTearsByStrengthGoesOnToDoSo()
    {
        Scene scene = *build(*findBuilder("rope"), {{"segments", 4}});
        const std::vector<Id> cord = materialsOf(scene);
        const Material& material = *findItem<Material>(scene, cord.front());
        for (const std::string rule : {"strength", "energy"}) {
            (void)apply(scene, *assignment(scene, material.name + ".tearRule=" + rule));
            const TearRule before = material.tearRule;
            QVERIFY(isByStrength(before));
            for (const char* name : {"dyneema_1", "liros_ltc80"}) {
                const Preset& preset = **findPreset(name);
                (void)apply(scene, presetEdit(scene, preset, cord)->edit);
                QCOMPARE(material.tearRule, before);
                QCOMPARE(presetOf(material), &preset);
            }
        }
    }

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
        QVERIFY(!made && made.message().english().find("weighs less") != std::string::npos);
    }

    // The rigidity particles of a kite carry a part of its frame, so that its knots weigh less than
    // its spars: another spar changes the whole by what it is lighter or heavier.
    void sparsOfCraftAreChanged_data()
    {
        QTest::addColumn<QString>("sample");
        QTest::addColumn<QString>("rod");
        for (const char* sample : {"diamond_kite", "ripstop_kite", "rectangular_kite"})
            for (const char* rod : {"carbon_rod_2", "carbon_rod_3", "carbon_tube_8"})
                QTest::addRow("%s of %s", sample, rod) << sample << rod;
    }
    void sparsOfCraftAreChanged()
    {
        QFETCH(QString, sample);
        QFETCH(QString, rod);
        const Scene before = ripstop::sample(sample);
        Scene scene = before;
        const Id spar = *findNamed(scene, Kind::Material, "spar");
        const Preset& preset = **findPreset(rod.toStdString());
        const auto edit = presetEdit(scene, preset, {spar});
        QVERIFY2(edit, edit ? "" : edit.message().english().c_str());
        (void)apply(scene, edit->edit);
        double length = 0.0, change = 0.0; // m, kg
        forEachPart(before, [&](Id, const Part& part) {
            for (const Link& link : part.links)
                length += link.material == spar ? link.restLength : 0.0;
            for (const Particle& particle : part.particles)
                change -= particle.mass;
        });
        forEachPart(scene, [&](Id, const Part& part) {
            for (const Particle& particle : part.particles) {
                change += particle.mass;
                QVERIFY(particle.mass > 0.0);
            }
        });
        const double lighter = *findItem<Material>(scene, spar)->linearDensity
                               - *findItem<Material>(before, spar)->linearDensity;
        NEAR(change, lighter * length, 1e-6);
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
        QCOMPARE(*material(1).membraneStiffness, 32660.0);
        QCOMPARE(*material(2).membraneStiffness, membrane); // shear was not asked for
    }
};

const RegisteredTest registered("test_presets", runPlain<TestPresets>);

} // namespace ripstop::test_presets
#include "test_presets.moc"
