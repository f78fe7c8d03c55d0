// Own materials: a file of the user's, beside the library.
//
// Stages: what is saved is there again, in commands too; names; then files that are bad or cannot
// be written, of which nothing is lost while the built-in materials work on.
#include "materials/own_materials.h"
#include "materials/presets.h"
#include "model/cli_call.h"
#include "model/files.h"
#include "registered_test.h"

#include "builders/builder.h"
#include "io/scene_file.h"
#include "scene/path.h"

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

namespace ripstop::test_own_materials {

namespace {

Preset cord()
{
    Material material;
    material.axialStiffness = 12e3;
    material.linearDensity = 2e-3;
    material.lineStrength = 500.0;
    return presetFrom(material, PresetKind::Line, "shop_cord", "weighed and pulled in my shop");
}

} // namespace

class TestOwnMaterials : public QObject
{
    Q_OBJECT

private slots:
    void whatIsSavedIsThere()
    {
        QTemporaryDir folder;
        const std::filesystem::path file =
            folder.filePath("deep/down/materials.json").toStdString();
        QVERIFY(readOwnMaterials(file).presets.empty() && !readOwnMaterials(file).problem);
        QVERIFY(!saveOwnMaterial(file, cord(), SameName::Refused));
        const OwnMaterials own = readOwnMaterials(file);
        QCOMPARE(own.presets.size(), std::size_t(1));
        QVERIFY(own.presets.front().own);
        const Result<const Preset*> found = findPreset("shop_cord", own.presets);
        QVERIFY(found && (*found)->kind == PresetKind::Line);
        QVERIFY(!findPreset("shop_cord"));

        // a material of a scene that has its numbers is known by its name
        Scene scene = *build(*findBuilder("rope"), {{"segments", 4}});
        const Id id = *findNamed(scene, Kind::Material, "cord");
        const auto made = presetEdit(scene, **found, {id});
        QVERIFY(bool(made));
        (void)apply(scene, made->edit);
        QCOMPARE(*findItem<Material>(scene, id)->lineStrength, 500.0);
        QVERIFY(presetOf(*findItem<Material>(scene, id), own.presets) == *found);

        // one of the same name is not lost by mistake
        Preset other = cord();
        other.label = "Other";
        const auto refused = saveOwnMaterial(file, other, SameName::Refused);
        QVERIFY(refused && refused->message.english().find("already") != std::string::npos);
        QVERIFY(!saveOwnMaterial(file, other, SameName::Replaced));
        QCOMPARE(readOwnMaterials(file).presets.front().label, std::string("Other"));
        QCOMPARE(readOwnMaterials(file).presets.size(), std::size_t(1));
        QCOMPARE(QDir(folder.filePath("deep/down")).entryList(QDir::Files).size(), 1);
    }

    // What the material has from a preset keeps the source that this has.
    void sourcesGoAlong()
    {
        const Preset& known = **findPreset("liros_ltc80");
        Material material;
        for (const PresetNumber& number : known.values)
            findProperty(Kind::Material, number.key)->set(&material, number.value);
        material.lineStrength = 640.0;
        const Preset preset = presetFrom(material, PresetKind::Line, "old_line", "used", &known);
        const PresetNumber* weight = findNumber(preset, propertyOf<&Material::linearDensity>());
        QVERIFY(weight->standing == NumberStanding::Listed);
        const PresetNumber* strength = findNumber(preset, propertyOf<&Material::lineStrength>());
        QVERIFY(strength->standing == NumberStanding::Assumed && strength->source == "used");
        QCOMPARE(preset.curve.points.size(), std::size_t(2));
    }

    void names()
    {
        QCOMPARE(materialNameOf("Spinnaker cloth, 60 g"), std::string("spinnaker_cloth_60_g"));
        QCOMPARE(materialNameOf(" (!) "), std::string());
        const QTemporaryDir folder;
        Preset preset = cord();
        preset.name = "skytex_27";
        const auto refused =
            saveOwnMaterial(folder.filePath("a").toStdString(), preset, SameName::Replaced);
        QVERIFY(refused && refused->message.english().find("comes with") != std::string::npos);
    }

    // A later version may bring a material of the same name: the others stay.
    void aBuiltInNameIsLeftOut()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath("materials.json");
        QVERIFY(!saveOwnMaterial(file.toStdString(), cord(), SameName::Refused));
        const QByteArray before = contentOf(file);
        write(file, QByteArray(before).replace("shop_cord", "skytex_27"));
        QVERIFY(!saveOwnMaterial(file.toStdString(), cord(), SameName::Refused));
        const OwnMaterials own = readOwnMaterials(file.toStdString());
        QVERIFY(own.problem && own.presets.size() == 1);
        QCOMPARE(own.presets.front().name, std::string("shop_cord"));
    }

    void badFilesStayAsTheyAre_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("cut off") << QByteArray("{\"format\": \"ripstop-materials\", \"vers");
        QTest::newRow("a scene") << QByteArray("{\"format\": \"ripstop-scene\", \"version\": 1}");
        QTest::newRow("bytes") << QByteArray("\x00\xff\x01", 3);
        QTest::newRow("of tomorrow")
            << QByteArray("{\"format\":\"ripstop-materials\",\"version\":7,\"materials\":[]}");
    }
    void badFilesStayAsTheyAre()
    {
        QFETCH(QByteArray, content);
        const QTemporaryDir folder;
        const QString file = folder.filePath("materials.json");
        write(file, content);
        const OwnMaterials own = readOwnMaterials(file.toStdString());
        QVERIFY(own.problem && own.presets.empty());
        QVERIFY(own.problem->message.english().find("materials.json") != std::string::npos);
        const auto refused = saveOwnMaterial(file.toStdString(), cord(), SameName::Replaced);
        QVERIFY(refused && refused->message.english().find("lose nothing") != std::string::npos);
        QCOMPARE(contentOf(file), content);

        const Outcome outcome = call({"presets", "--materials", file, "--show", "skytex_27"});
        QCOMPARE(outcome.exitCode, 0);
        QVERIFY2(outcome.error.contains("Only built-in materials"), qPrintable(outcome.error));
    }

    void commandLine()
    {
        const QTemporaryDir folder;
        const QString rope = folder.filePath("rope.ripstop.json"),
                      own = folder.filePath("own.json"), out = folder.filePath("out.ripstop.json");
        QVERIFY(!saveScene(*build(*findBuilder("rope"), {{"segments", 4}}), rope.toStdString()));
        const QStringList save{
            "presets",     rope,      "--material", "cord",  "--save",
            "my_rope",     "--label", "My rope",    "--set", "cord.lineStrength=321",
            "--materials", own};
        QCOMPARE(call(save).exitCode, 0);
        const Outcome again = call(save);
        QCOMPARE(again.exitCode, 1);
        QVERIFY(again.error.contains("my_rope already"));
        QCOMPARE(call(save + QStringList{"--replace"}).exitCode, 0);
        const Outcome list = call({"presets", "--materials", own});
        QVERIFY2(list.out.contains("my_rope (line, own): My rope"), list.out.right(300));
        QCOMPARE(
            call({"presets", rope, "--apply", "my_rope", "--material", "cord", "-o", out}).exitCode,
            2); // without the file there is none
        QCOMPARE(call({"presets", rope, "--apply", "my_rope", "--material", "cord", "-o", out,
                       "--materials", own})
                     .exitCode,
                 0);
        const Result<Scene> scene = readScene(out.toStdString());
        QCOMPARE(
            *findItem<Material>(*scene, *findNamed(*scene, Kind::Material, "cord"))->lineStrength,
            321.0);
        QCOMPARE(call({"presets", rope, "--save", "x", "--materials", own}).exitCode, 2);
        QVERIFY(call({"presets", "--materials", folder.filePath("none")})
                    .error.contains("There is no file"));
    }
};

const RegisteredTest registered("test_own_materials", runPlain<TestOwnMaterials>);

} // namespace ripstop::test_own_materials
#include "test_own_materials.moc"
