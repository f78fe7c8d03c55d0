// Marks of the library along a number, and steps to the next material.
//
// Stages: where named materials lie; which one is next by weight, stiffness and strength, by the
// numbers that resources/materials.json has of them; what a step does to masses, and that it is
// undone; what is refused; and the same from the command line.
#include "model/material_sheets.h"
#include "registered_test.h"

#include "io/scene_file.h"
#include "materials/marks.h"
#include "materials/neighbours.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <set>

Q_DECLARE_METATYPE(ripstop::MaterialStep)

namespace ripstop::test_library_steps {

namespace {

Material made(const char* preset)
{
    Material material;
    material.name = "sail";
    give(material, **findPreset(preset));
    return material;
}

QString nameOf(const Result<const Preset*>& preset)
{
    return preset ? QString::fromStdString((*preset)->name)
                  : QString::fromStdString(preset.message().english());
}

double massOf(Scene& scene)
{
    double mass = 0.0;
    for (const Particle& particle : partOf(scene).particles)
        mass += particle.mass;
    return mass;
}

} // namespace

class TestLibrarySteps : public QObject
{
    Q_OBJECT

private slots:
    void marksLieWhereTheMaterialsAre()
    {
        const std::vector<LibraryMark> marks =
            marksOf(propertyOf<&Material::membraneStiffness>(), made("ripstop_075"));
        QVERIFY(std::ranges::is_sorted(marks, {}, &LibraryMark::value));
        const auto at = [&](double value) {
            const auto mark = std::ranges::find(marks, value, &LibraryMark::value);
            QStringList names;
            if (mark != marks.end())
                for (const Preset* preset : mark->presets)
                    names << QString::fromUtf8(preset->name.data());
            return names;
        };
        QCOMPARE(at(26700.0), QStringList{"ripstop_050"});
        QCOMPARE(at(40000.0), (QStringList{"ripstop_075", "nylite_90"})); // they share it
        QCOMPARE(at(90000.0), QStringList{"icarex_p31"});
        QCOMPARE(at(110000.0), QStringList{"pet_film_1mil"}); // a sheet as well
        for (const LibraryMark& mark : marks)
            for (const Preset* preset : mark.presets)
                QVERIFY2(isSheet(preset->kind), preset->name.c_str());
    }

    // EA of a line has marks of lines, that of a spar those of spars, and EI those of spars.
    void marksStayInTheFamily()
    {
        const auto kinds = [](const Property& property, const char* preset) {
            std::set<PresetKind> found;
            for (const LibraryMark& mark : marksOf(property, made(preset)))
                for (const Preset* one : mark.presets)
                    found.insert(one->kind);
            return found;
        };
        const Property& axial = propertyOf<&Material::axialStiffness>();
        QCOMPARE(kinds(axial, "liros_ltc80"), std::set{PresetKind::Line});
        QCOMPARE(kinds(axial, "carbon_tube_6"), std::set{PresetKind::Spar});
        QCOMPARE(kinds(propertyOf<&Material::flexuralRigidity>(), "wood_6"),
                 std::set{PresetKind::Spar});
        QVERIFY(marksOf(propertyOf<&Material::dampingTime>(), made("wood_6")).empty());
    }

    void rangesReachAFactorOfFour()
    {
        QCOMPARE(rangeAmongMarks(40000.0), (SliderRange{10000.0, 160000.0, true}));
    }

    void namesAreShort()
    {
        QCOMPARE(shortLabelOf(**findPreset("ripstop_050")), std::string_view("0.5 oz"));
        QCOMPARE(shortLabelOf(**findPreset("icarex_p31")), std::string_view("Icarex"));
        QCOMPARE(shortLabelOf(**findPreset("dyneema_line_50")), std::string_view("D 50 daN"));
        for (const Preset& preset : allPresets())
            QVERIFY2(preset.shortLabel.size() <= 11, preset.name.c_str());
    }

    void nextMaterial_data()
    {
        QTest::addColumn<QString>("from");
        QTest::addColumn<MaterialStep>("step");
        QTest::addColumn<QString>("to");
        using enum MaterialStep;
        // 42.5 g/m^2 lies next below 47; of the two cloths of 42.5, E t of 33 kN/m is nearer to 40
        QTest::newRow("lighter kite cloth") << "ripstop_075" << Lighter << "dominico_30d";
        QTest::newRow("heavier kite cloth") << "ripstop_075" << Heavier << "nylite_90";
        QTest::newRow("stiffer kite cloth") << "ripstop_075" << Stiffer << "ripstop_150";
        QTest::newRow("stiffer than 46 kN/m") << "ripstop_150" << Stiffer << "icarex_p31";
        QTest::newRow("softer than Icarex") << "icarex_p31" << Softer << "ripstop_150";
        // knits of 187 to 284 g/m^2 lie between and have no strength
        QTest::newRow("heavier Dacron") << "surf_dacron" << Heavier << "dacron_sail";
        QTest::newRow("a film among fabrics") << "pet_film_1mil" << Lighter << "icarex_p31";
        // 0.28 g/m, where Dyneema of 50 daN has 0.2
        QTest::newRow("lighter line") << "dyneema_line_100" << Lighter << "liros_ltc45";
        // 8 kN/m of warp, where the twill of MIL-C-7020 has 8.756
        QTest::newRow("stronger kite cloth") << "ripstop_075" << Stronger << "mil_7020_2";
        // 450 N of which splices leave 0.9, 405 N. Of the braid's 785 N knots leave 0.6, 471 N; of
        // two lines of 500 N 300 N, and 0.2 g/m is nearer to 0.28 than 0.6 is.
        QTest::newRow("stronger line") << "liros_ltc45" << Stronger << "dyneema_1";
        QTest::newRow("weaker line") << "liros_ltc45" << Weaker << "dyneema_line_50";
        // EI of 1.227, where the carbon tube has 1.229; a dowel of 0.95 has no weight
        QTest::newRow("stiffer spar") << "carbon_rod_3" << Stiffer << "fibreglass_rod_5";
    }
    void nextMaterial()
    {
        QFETCH(QString, from);
        QFETCH(MaterialStep, step);
        QFETCH(QString, to);
        QCOMPARE(nameOf(neighbour(made(qPrintable(from)), step)), to);
    }

    // Up and down the whole ladder by weight: it ends, and each step is one.
    void stepsGoOnToTheEnd()
    {
        Material material = made("skytex_21");
        int steps = 0;
        for (;; ++steps) {
            const double before = *material.arealDensity;
            const auto next = neighbour(material, MaterialStep::Heavier);
            if (!next)
                break;
            give(material, **next);
            QVERIFY(*material.arealDensity > before);
        }
        QVERIFY(steps >= 10);
        QCOMPARE(*material.arealDensity, 0.210); // the heaviest that is known as well
    }

    // A number that was tuned by hand is one to step from as well.
    void stepsFromBetween()
    {
        Material material = made("ripstop_075");
        material.membraneStiffness = 41000.0;
        QCOMPARE(nameOf(neighbour(material, MaterialStep::Stiffer)), QString("ripstop_150"));
        const auto softer = neighbour(material, MaterialStep::Softer);
        QVERIFY(softer);
        const PresetNumber* stiffness =
            findNumber(**softer, propertyOf<&Material::membraneStiffness>());
        QCOMPARE(std::get<double>(stiffness->value), 40000.0);
    }

    void noStepIsRefused()
    {
        Material material;
        material.name = "ideal";
        QVERIFY(nameOf(neighbour(material, MaterialStep::Lighter)).contains("ideal has no"));
        QVERIFY(nameOf(neighbour(material, MaterialStep::Stronger)).contains("has no strength"));
        const QString none = nameOf(neighbour(made("aluminium_62"), MaterialStep::Stiffer));
        QVERIFY2(none.contains("nothing stiffer than sail"), qPrintable(none));
    }

    // 1 m x 1 m of cloth: 47 g become 42.5 g, and undo brings back the scene.
    void massesFollowAStep()
    {
        Scene scene = *build(*findBuilder("cloth"), sheet(6, 2, 0.3));
        const std::vector<Id> cloth{materialsOf(scene).front()};
        (void)apply(scene, presetEdit(scene, **findPreset("ripstop_075"), cloth)->edit);
        NEAR(massOf(scene), 0.047, 1e-12);
        const Scene before = scene;
        const Result<StepEdit> step = stepEdit(scene, cloth, MaterialStep::Lighter);
        QVERIFY(step && step->edit.notWeighed.empty());
        QStringList words;
        for (const Message& change :
             changesBy(*step->given.front().preset, *findItem<Material>(scene, cloth.front())))
            words << QString::fromStdString(change.english());
        QVERIFY(words.contains("Areal density 47 \u2192 42.5 g/m\u00b2"));
        QVERIFY(words.contains("Membrane stiffness 40 \u2192 33 kN/m"));
        const Edit undo = apply(scene, step->edit.edit);
        NEAR(massOf(scene), 0.0425, 1e-12);
        (void)apply(scene, undo);
        QVERIFY(scene == before);
    }

    // Two materials that share particles and go to different presets in one edit.
    void severalStepAtOnce()
    {
        Scene scene = *build(*findBuilder("cloth"), sheet(6, 2, 0.3));
        const std::vector<Id> all = materialsOf(scene);
        const std::vector<GivenPreset> given{{all[0], *findPreset("ripstop_075")},
                                             {all[1], *findPreset("icarex_p31")}};
        (void)apply(scene, presetEdit(scene, given)->edit);
        const Result<StepEdit> step = stepEdit(scene, {all[0], all[1]}, MaterialStep::Softer);
        QVERIFY(step);
        (void)apply(scene, step->edit.edit);
        QCOMPARE(*findItem<Material>(scene, all[1])->membraneStiffness, 46000.0);
        QVERIFY(*findItem<Material>(scene, all[0])->membraneStiffness < 40000.0);
    }

    void commandLine()
    {
        const QTemporaryDir folder;
        const QString cloth = folder.filePath("cloth.ripstop.json");
        Scene scene = *build(*findBuilder("cloth"), sheet(3, 2, 0.3));
        (void)apply(
            scene,
            presetEdit(scene, **findPreset("ripstop_075"), {materialsOf(scene).front()})->edit);
        QVERIFY(!saveScene(scene, cloth.toStdString()));
        const QString out = folder.filePath("new.ripstop.json");
        QString printed;
        const auto exitCode = [&](const QStringList& arguments) {
            QProcess process;
            process.start(CLI_PROGRAM, arguments);
            const bool ended = process.waitForFinished();
            printed =
                QString::fromUtf8(process.readAllStandardOutput() + process.readAllStandardError());
            return ended ? process.exitCode() : -1;
        };
        const QStringList step{"presets", cloth, "--material", "cloth", "-o", out, "--step"};
        QCOMPARE(exitCode(step + QStringList{"thinner"}), 2);
        QCOMPARE(exitCode(step + QStringList{"lighter", "--apply", "skytex_27"}), 2);
        QCOMPARE(exitCode(step + QStringList{"lighter"}), 0);
        QVERIFY2(printed.contains("Areal density 47 \u2192 42.5 g/m\u00b2"), qPrintable(printed));
        const Result<Scene> read = readScene(out.toStdString());
        const Preset* preset = presetOf(*findItem<Material>(*read, materialsOf(*read).front()));
        QVERIFY(preset);
        QCOMPARE(preset->name, std::string("dominico_30d"));
    }
};

const RegisteredTest registered("test_library_steps", runPlain<TestLibrarySteps>);

} // namespace ripstop::test_library_steps
#include "test_library_steps.moc"
