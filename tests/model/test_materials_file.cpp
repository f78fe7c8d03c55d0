// Files of materials: the library that the program carries in itself, and what is said of files
// that are not as they should be.
//
// Stages: the library can be read and says of each number where it is from; no cloth in it is
// stiffer than its yarn or gives energy when it is stretched; what is written is read again; bad
// files, each with its sentence.
#include "materials/material_file.h"
#include "materials/presets.h"
#include "model/cli_call.h"
#include "model/files.h"
#include "registered_test.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace ripstop::test_materials_file {

namespace {

// JSON with ' in the place of ".
std::string json(std::string text)
{
    std::ranges::replace(text, '\'', '"');
    return text;
}

std::string fileWith(const std::string& materials)
{
    return json("{'format': 'ripstop-materials', 'version': 1, 'materials': [" + materials + "]}");
}

// A fabric with these numbers.
std::string fabric(const std::string& numbers)
{
    return fileWith("{'name': 'mine', 'kind': 'fabric', 'yarn': 'nylon', 'numbers': {" + numbers
                    + "}}");
}

// A line with this strength, and what follows its numbers.
std::string line(const std::string& rest = "")
{
    return "{'name': 'a', 'kind': 'line', 'numbers': {'lineStrength': {'value': 100, 'unit': 'N', "
           "'standing': 'measured', 'source': 'me'}}"
           + rest + "}";
}

std::string number(const std::string& key, const std::string& value, const std::string& unit)
{
    return "'" + key + "': {'value': " + value + ", 'unit': '" + unit
           + "', 'standing': 'measured', 'source': 'me'}";
}

double valueOf(const Preset& preset, const Property& property)
{
    const PresetNumber* number = findNumber(preset, property);
    return number ? std::get<double>(number->value) : std::nan("");
}

} // namespace

class TestMaterialsFile : public QObject
{
    Q_OBJECT

private slots:
    void libraryIsRead()
    {
        const auto presets = readMaterials(presetFileText(), "materials.json");
        QVERIFY2(bool(presets), presets ? "" : presets.message().english().c_str());
        QVERIFY(presets->size() >= 90);
        QCOMPARE(presets->size(), allPresets().size());
        QCOMPARE(QByteArray(presetFileText().data(), qsizetype(presetFileText().size())),
                 contentOf(SOURCE_DIR "/resources/materials.json"));
    }

    // E t of a weave is at most half its weight times the modulus of its yarn per weight: 4.0 N/tex
    // of nylon 6.6, 9.7 of polyester. Stretching costs energy whichever way it goes when
    // nu^2 < E1 / E2.
    void noClothIsStifferThanItsYarn()
    {
        for (const Preset& preset : allPresets()) {
            const double warp = valueOf(preset, propertyOf<&Material::membraneStiffness>());
            if (!isSheet(preset.kind))
                continue;
            const double density = valueOf(preset, propertyOf<&Material::arealDensity>());
            const double share = preset.yarn == Yarn::Nylon ? 4.0e6 : 9.7e6; // N m/kg
            const double given = valueOf(preset, propertyOf<&Material::weftStiffness>());
            const double weft = std::isnan(given) ? warp : given;
            const double most =
                preset.kind == PresetKind::Film ? density * share : 0.5 * density * share;
            QVERIFY2(std::max(warp, weft) <= most * (1.0 + 1e-9), preset.name.c_str());
            const double ratio = valueOf(preset, propertyOf<&Material::poissonRatio>());
            QVERIFY2(std::isnan(ratio) || ratio * ratio < warp / weft, preset.name.c_str());
        }
    }

    // Those that are flown with have what a margin needs; only what was never told is missing.
    void strengthsAreThere()
    {
        for (const Preset& preset : allPresets()) {
            const auto has = [&](const Property& property) {
                return findNumber(preset, property) != nullptr;
            };
            const bool known = preset.kind == PresetKind::Line
                                   ? has(propertyOf<&Material::lineStrength>())
                               : preset.kind == PresetKind::Spar
                                   ? has(propertyOf<&Material::breakingMoment>())
                                   : has(propertyOf<&Material::warpStrength>())
                                         && has(propertyOf<&Material::weftStrength>());
            QVERIFY2(known || !preset.note.empty(), preset.name.c_str());
            const PresetNumber* rule = findNumber(preset, propertyOf<&Material::tearRule>());
            if (preset.kind == PresetKind::Line && known) // all break alike
                QVERIFY2(rule && rule->value == Value(std::string("strength")),
                         preset.name.c_str());
        }
    }

    // The stiffness of a line that a curve is known of is the secant of one of its points.
    void curvesMeetTheStiffness()
    {
        int curves = 0;
        for (const Preset& preset : allPresets()) {
            if (preset.curve.points.empty())
                continue;
            ++curves;
            const double stiffness = valueOf(preset, propertyOf<&Material::axialStiffness>());
            QVERIFY2(std::ranges::any_of(
                         preset.curve.points,
                         [&](const StretchPoint& point) {
                             return std::abs(point.load / point.strain / stiffness - 1.0) < 1e-4;
                         }),
                     preset.name.c_str());
        }
        QVERIFY(curves >= 20);
    }

    void whatIsWrittenIsReadAgain()
    {
        const std::vector<Preset> presets(allPresets().begin(), allPresets().end());
        const auto read = readMaterials(materialsText(presets), "copy");
        QVERIFY2(bool(read), read ? "" : read.message().english().c_str());
        QCOMPARE(read->size(), presets.size());
        for (std::size_t i = 0; i < presets.size(); ++i) {
            QCOMPARE(QString::fromStdString(sourcesOf((*read)[i])),
                     QString::fromStdString(sourcesOf(presets[i])));
            QCOMPARE((*read)[i].values.size(), presets[i].values.size());
            for (std::size_t j = 0; j < presets[i].values.size(); ++j)
                QVERIFY((*read)[i].values[j].value == presets[i].values[j].value);
            QCOMPARE((*read)[i].curve.points.size(), presets[i].curve.points.size());
        }
    }

    // 27 g/m^2 is the same double as 0.027 kg/m^2; 33 kN/m and 12 % are 33000 and 0.12.
    void unitsAreConverted()
    {
        const auto read = readMaterials(fabric(number("arealDensity", "27", "g/m^2") + ","
                                               + number("membraneStiffness", "33", "kN/m") + ","
                                               + number("breakElongation", "12", "%")),
                                        "mine");
        QVERIFY2(bool(read), read ? "" : read.message().english().c_str());
        const Preset& preset = read->front();
        QCOMPARE(valueOf(preset, propertyOf<&Material::arealDensity>()), 0.027);
        QCOMPARE(valueOf(preset, propertyOf<&Material::membraneStiffness>()), 33000.0);
        QCOMPARE(std::get<double>(preset.breakElongation->value), 0.12);
    }

    void whatIsNotKnownIsKept()
    {
        const std::string text = fileWith(line(", 'colour': 'red'"));
        Preset preset = readMaterials(text, "mine")->front();
        preset.name = "b";
        const std::string longer = withMaterial(text, preset);
        QVERIFY(longer.find("\"colour\": \"red\"") != std::string::npos);
        QCOMPARE(readMaterials(longer, "mine")->size(), std::size_t(2));
        QCOMPARE(readMaterials(withMaterial(longer, preset), "mine")->size(), std::size_t(2));
    }

    void badFilesAreExplained_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("sentence"); // a part of it
        const auto row = [](const char* name, const std::string& text, const char* sentence) {
            QTest::newRow(name) << QString::fromStdString(text) << QString(sentence);
        };
        row("empty", "", "line 1, column 1");
        row("a comma too much", "{\n  \"format\": \"ripstop-materials\",\n}", "line 3, column 1");
        row("a scene", json("{'format': 'ripstop-scene', 'version': 1}"), "no file of materials");
        row("a list", "[]", "no file of materials");
        row("of tomorrow", json("{'format': 'ripstop-materials', 'version': 2, 'materials': []}"),
            "newer Ripstop");
        row("no list", json("{'format': 'ripstop-materials', 'version': 1}"),
            "needs \"materials\"");
        row("no name", fileWith("{'kind': 'line'}"), "Material 1 of the list has no name");
        row("no kind", fileWith("{'name': 'a'}"), "material a: The kind must be one of fabric");
        row("no numbers", fileWith("{'name': 'a', 'kind': 'line'}"), "needs \"numbers\"");
        row("misspelt", fabric(number("membraneStifness", "1", "N/m")),
            "did you mean \"membraneStiffness\"");
        row("not physical", fabric(number("stallAngle", "1", "deg")), "There is no number");
        row("without unit", fabric(number("membraneStiffness", "1", "")), "needs its unit, N/m");
        row("wrong unit", fabric(number("membraneStiffness", "1", "N")),
            "cannot be in N; it is measured in N/m");
        row("negative", fabric(number("membraneStiffness", "-1", "N/m")), "must be above 0");
        row("text", fabric(number("membraneStiffness", "'1'", "N/m")), "needs a number");
        row("no source", fabric("'porosity': {'value': 0, 'standing': 'measured'}"),
            "needs its source");
        row("no standing", fabric("'porosity': {'value': 0, 'source': 'me'}"),
            "needs its standing, one of measured");
        row("a choice", fabric("'tearRule': {'value': 'teeth'}"), "must be one of");
        row("twice", fileWith(line() + ", " + line()), "Two materials are called a");
        // 37.3 g/m^2 of nylon can have 74.6 kN/m
        row("stiffer than its yarn",
            fabric(number("arealDensity", "37.3", "g/m^2") + ","
                   + number("membraneStiffness", "75", "kN/m")),
            "more than the yarn in it can hold, 7.46e+04 N/m");
        // 0.8^2 > 1 / 2
        row("gives energy",
            fabric(number("membraneStiffness", "1", "kN/m") + ","
                   + number("weftStiffness", "2", "kN/m") + ","
                   + number("poissonRatio", "0.8", "")),
            "Poisson's ratio 0.8 is too large");
        row("curve that falls",
            fileWith(line(", 'curve': {'loadUnit': 'N', 'strainUnit': '%', 'standing': 'listed', "
                          "'source': 'me', 'points': [[2, 1], [1, 2]]}")),
            "must rise from point to point");
        row("curve without units", fileWith(line(", 'curve': {'points': []}")),
            "needs a loadUnit like N");
    }
    void badFilesAreExplained()
    {
        QFETCH(QString, text);
        QFETCH(QString, sentence);
        const auto read = readMaterials(text.toStdString(), "own.json");
        QVERIFY(!read);
        const QString said = QString::fromStdString(read.message().english());
        QVERIFY2(said.startsWith("own.json") && said.contains(sentence), qPrintable(said));
    }

    // The manual is committed: ripstop-cli presets --manual > docs/material-library.md
    void manualIsUpToDate()
    {
        const Outcome outcome = call({"presets", "--manual"});
        QCOMPARE(QString(outcome.out), QString(contentOf(SOURCE_DIR "/docs/material-library.md")));
        QVERIFY(call({"presets", "--show", "liros_ltc80"}).out.contains("secant at 300 N"));
        QCOMPARE(call({"presets", "--show", "liros_ltc8"}).exitCode, 2);
    }
};

const RegisteredTest registered("test_materials_file", runPlain<TestMaterialsFile>);

} // namespace ripstop::test_materials_file
#include "test_materials_file.moc"
