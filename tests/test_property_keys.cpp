// Keys of properties are for files, paths and people. Code that needs one property names its field
// (propertyOf<&Particle::mass>()), and asks for the rest by the columns of the table: so no key
// stands as text outside the table, and none comes back.
#include "registered_test.h"
#include "scene/property.h"

#include <QtTest>

#include <QDirIterator>
#include <QRegularExpression>

namespace ripstop::test_property_keys {

namespace {

// Where a text that reads like a key is something else. No file of an old version of the format is
// among them: its reader knows keys only from the table.
struct Other
{
    const char* place; // a file, or a folder that ends in a slash
    const char* words; // that are meant, or * for any
    const char* because;
};

// clang-format off
constexpr Other others[]{
    {"model/scene/property.cpp",         "*",                  "the table itself"},
    {"model/base/quantity.h",            "formula",            "names of choices"},
    {"model/builders/",                  "*",                  "builders have parameters of their own, as in {width: 2}"},
    {"model/verify/",                    "*",                  "parameters of builders"},
    {"model/shapes/",                    "u v",                "words of mesh files"},
    {"model/shapes/shape_files.cpp",     "picture",            "a word of a sentence"},
    {"model/bundle/manifest.cpp",        "title",              "fields of the manifest"},
    {"model/export/hdf5.cpp",            "position probes step velocity", "names of arrays"},
    {"model/scene/items.h",              "material",           "what a new one is called"},
    {"model/scene/reference.cpp",        "material probes",    "names of kinds"},
    {"model/check/check.cpp",            "axis formula guide picture roughness", "sorts of problems"},
    {"model/check/step_check.cpp",       "step",               "sorts of problems"},
    {"model/shaping/operation.cpp",      "axis guide mass",    "operations and their parameters"},
    {"model/shaping/draw_operations.cpp", "kind mass material side", "parameters of operations"},
    {"model/author/stability.cpp",       "step substeps",      "sorts of findings, and a word of a sentence"},
    {"model/select/condition.cpp",       "name",               "what stands for a name in an example"},
    {"model/materials/material_file.cpp", "kind name",          "fields of files of materials"},
    {"model/study/",                     "*",                  "fields of studies and of their ledgers"},
    {"views/document/autosave.cpp",      "file title",         "the note beside unsaved work"},
    {"views/document/rescue.cpp",        "file title",         "the note beside unsaved work"},
    {"views/import/import_form.cpp",     "material name size", "names of widgets"},
    {"views/look/quantity_values.h",     "material",           "what the view can be coloured by"},
    {"views/plots/band_graphs.cpp",      "grid",               "a layer of the plot"},
    {"views/plots/chart.cpp",            "grid",               "a layer of the plot"},
    {"views/plots/plot_menu.cpp",        "picture",            "the name of an icon"},
    {"views/start/start_page.cpp",       "builder",            "names of pictures"},
    {"views/timeline/timeline.cpp",      "step",               "names of pictures"},
    {"views/transport/transport.cpp",    "step substeps",      "names of pictures and widgets"},
    {"app/",                             "*",                  "names of pictures, actions, options and printed fields"},
};
// clang-format on

QString relative(const QString& file) { return file.mid(int(strlen(SOURCE_DIR)) + 1); }

QStringList sources()
{
    QStringList files;
    for (const char* top : {"/model", "/views", "/app"}) {
        QDirIterator found(QStringLiteral(SOURCE_DIR) + top, {"*.h", "*.cpp", "*.inl"}, QDir::Files,
                           QDirIterator::Subdirectories);
        while (found.hasNext())
            files << found.next();
    }
    files.sort();
    return files;
}

const QSet<QString>& keys()
{
    static const QSet<QString> all = [] {
        QSet<QString> found;
        for (const Property& property : allProperties())
            found << QString::fromUtf8(property.key.data(), qsizetype(property.key.size()));
        return found;
    }();
    return all;
}

// The code of a file, without comments and raw texts.
QString codeOf(const QString& file)
{
    // whichever begins first hides the others
    static const QRegularExpression part(
        R"re(R"(\w*)\([\s\S]*?\)\1"|//[^\n]*|/\*[\s\S]*?\*/|("(?:\\.|[^\x22\\\n])*"|'(?:\\.|[^'\\\n])'))re");
    QFile source(file);
    if (!source.open(QIODevice::ReadOnly))
        return {};
    const QString text = QString::fromUtf8(source.readAll());
    QString code;
    qsizetype last = 0;
    auto parts = part.globalMatch(text);
    while (parts.hasNext()) {
        const auto match = parts.next();
        code += text.mid(last, match.capturedStart() - last) + match.captured(2);
        last = match.capturedEnd();
    }
    return code + text.mid(last);
}

const Other* otherAt(const QString& file, const QString& word)
{
    for (const Other& other : others) {
        const QLatin1String place(other.place);
        const bool isHere = place.endsWith('/') ? file.startsWith(place) : file == place;
        if (isHere
            && (qstrcmp(other.words, "*") == 0
                || QString::fromLatin1(other.words).split(' ').contains(word)))
            return &other;
    }
    return nullptr;
}

} // namespace

class TestPropertyKeys : public QObject
{
    Q_OBJECT

private slots:
    void noKeyStandsAsText()
    {
        static const QRegularExpression text(R"re("(\w+)")re");
        QVERIFY(keys().contains("airDensity") && keys().contains("mass"));
        QStringList found;
        QSet<const Other*> met;
        for (const QString& file : sources()) {
            auto texts = text.globalMatch(codeOf(file));
            while (texts.hasNext()) {
                const QString word = texts.next().captured(1);
                if (!keys().contains(word))
                    continue;
                const Other* other = otherAt(relative(file), word);
                met << other;
                if (!other)
                    found << relative(file) + ": \"" + word + '"';
            }
        }
        QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')
                                             + "\nName the field, as propertyOf<&Link::width>(), "
                                               "or give the table a column."));
        for (const Other& other : others)
            QVERIFY2(met.contains(&other),
                     qPrintable(QString("%1 has no such text").arg(other.place)));
    }

    // Also not where such words are at home: what is compared with a key, and what is looked up in
    // the table.
    void noKeyIsComparedOrLookedUp_data()
    {
        QTest::addColumn<QString>("pattern");
        QTest::addColumn<QString>("example"); // an example of what is to be found
        // clang-format off
        QTest::newRow("compared")           << R"re([kK]ey\b(?:\(\))?\s*[!=]=\s*"(\w+)")re"      << "if (set->property->key == \"mass\")";
        QTest::newRow("the other way")      << R"re("(\w+)"\s*[!=]=\s*[\w.()>-]*[kK]ey\b)re"    << "\"mass\" != property.key";
        QTest::newRow("looked up")          << R"re(\bfindProperty\s*\([^;{}\x22]*"(\w+)")re"      << "findProperty(kindOf(*thing), \"mass\")";
        QTest::newRow("given with a kind")  << R"re(\bKind::\w+,\s*"(\w+)")re"                  << "set(Kind::Particle, \"mass\", 0.1)";
        // clang-format on
    }

    void noKeyIsComparedOrLookedUp()
    {
        QFETCH(QString, pattern);
        QFETCH(QString, example);
        const QRegularExpression expression(pattern);
        QCOMPARE(expression.match(example).captured(1), QString("mass"));
        for (const QString& file : sources()) {
            auto places = expression.globalMatch(codeOf(file));
            while (places.hasNext()) {
                const auto match = places.next();
                QVERIFY2(!keys().contains(match.captured(1)),
                         qPrintable(relative(file) + ": " + match.captured()));
            }
        }
    }

    // Each field has one row, which it finds.
    void everyFieldFindsItsRow()
    {
        for (const Property& property : allProperties()) {
            QCOMPARE(property.place.kind, property.kind);
            QCOMPARE(&propertyAt(property.place), &property);
        }
        QCOMPARE(propertyOf<&Particle::textureU>().key, std::string_view("u"));
        QVERIFY((isOneOf<&Link::from, &Probe::from>(*findProperty(Kind::Probe, "from"))));
        QVERIFY((!isOneOf<&Link::from, &Link::to>(*findProperty(Kind::Probe, "from"))));
    }

    // A text means a colour, a number does not.
    void meaningsFitTheirValues()
    {
        QMap<Kind, int> names;
        for (const Property& property : allProperties()) {
            const char* const name = property.key.data();
            switch (property.meaning) {
            case Meaning::Plain:
                break;
            case Meaning::Name:
                ++names[property.kind];
                [[fallthrough]];
            case Meaning::Color:
            case Meaning::Path:
            case Meaning::File:
            case Meaning::Keys:
            case Meaning::Notes:
                QVERIFY2(std::holds_alternative<std::string>(property.initial), name);
                QVERIFY2(property.choices.empty(), name);
                break;
            case Meaning::Shown:
                QVERIFY2(std::holds_alternative<bool>(property.initial), name);
                break;
            case Meaning::Polar:
                QVERIFY2(std::holds_alternative<NumberRows>(property.initial), name);
                QCOMPARE(property.columns, 3);
                break;
            case Meaning::Times:
                QVERIFY2(std::holds_alternative<NumberRows>(property.initial), name);
                QVERIFY2(property.columns > 1, name);
                break;
            }
        }
        for (int kind = int(Kind::Part); kind < kindCount; ++kind)
            QCOMPARE(names.value(Kind(kind)), 1);
    }

    // A slider goes where the property may go, and only numbers have one.
    void usualRangesAreAllowed()
    {
        for (const Property& property : allProperties()) {
            const auto usual = property.usual;
            if (!usual)
                continue;
            const char* const name = property.key.data();
            QVERIFY2(usual->low < usual->high, name);
            QVERIFY2(!usual->logarithmic || usual->low > 0.0, name);
            QVERIFY2(usual->low >= property.range.low
                         || std::holds_alternative<Vec3>(property.initial),
                     name);
            QVERIFY2(usual->high <= property.range.high, name);
        }
    }
};

const RegisteredTest registered("test_property_keys", runPlain<TestPropertyKeys>);

} // namespace ripstop::test_property_keys
#include "test_property_keys.moc"
