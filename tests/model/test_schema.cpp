// The schema of scene files: the one in docs is that of this program, every sample is valid by it,
// and what the reader refuses or does not know is not.
#include "model/cli_call.h"
#include "registered_test.h"

#include <QDir>
#include <QJsonArray>
#include <QRegularExpression>
#include <QtTest>

namespace ripstop::test_schema {

namespace {

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// As much of JSON Schema as ours uses. The first flaw with its place, or nothing.
class Validator
{
public:
    explicit Validator(const QJsonObject& schema)
        : m_root(schema)
    {}

    QString flaw(const QJsonValue& value) const { return flaw(value, m_root, "file"); }

private:
    QString flaw(const QJsonValue& value, QJsonObject schema, const QString& place) const
    {
        if (schema.contains("$ref"))
            schema = m_root["$defs"][schema["$ref"].toString().section('/', -1)].toObject();
        if (schema.contains("oneOf"))
            return flawOfAll(value, schema["oneOf"].toArray(), place);
        if (schema.contains("const") && value != schema["const"])
            return place + " is not " + schema["const"].toString();
        if (schema.contains("enum") && !schema["enum"].toArray().contains(value))
            return place + " is no choice";
        const QString type = schema["type"].toString();
        if (!type.isEmpty() && !isOf(value, type))
            return place + " is no " + type;
        if (value.isDouble() && !isWithin(value.toDouble(), schema))
            return place + " is out of range";
        if (value.isString() && schema.contains("pattern")
            && !QRegularExpression(schema["pattern"].toString()).match(value.toString()).hasMatch())
            return place + " does not match";
        if (value.isArray())
            return flawOfList(value.toArray(), schema, place);
        return value.isObject() ? flawOfObject(value.toObject(), schema, place) : QString();
    }

    // Of types, the one that the value names; so the flaw of an item is told and not that it is
    // none of ten.
    QString flawOfAll(const QJsonValue& value, const QJsonArray& all, const QString& place) const
    {
        for (const QJsonValue& one : all) {
            const QString name = one.toObject()["$ref"].toString().section('/', -1);
            if (value["type"].toString() == name)
                return flaw(value, one.toObject(), place);
        }
        return place + " has an unknown type";
    }

    QString flawOfList(const QJsonArray& list, const QJsonObject& schema,
                       const QString& place) const
    {
        if (schema.contains("minItems")
            && (list.size() < schema["minItems"].toInt()
                || list.size() > schema["maxItems"].toInt()))
            return place + " has another length";
        for (qsizetype i = 0; i < list.size(); ++i)
            if (const QString found = flaw(list[i], schema["items"].toObject(),
                                           place + '[' + QString::number(i) + ']');
                !found.isEmpty())
                return found;
        return {};
    }

    QString flawOfObject(const QJsonObject& object, const QJsonObject& schema,
                         const QString& place) const
    {
        for (const QJsonValue& key : schema["required"].toArray())
            if (!object.contains(key.toString()))
                return place + " has no " + key.toString();
        const QJsonObject known = schema["properties"].toObject();
        const QJsonValue others = schema["additionalProperties"];
        for (auto it = object.begin(); it != object.end(); ++it) {
            const QString at = place + '.' + it.key();
            if (!known.contains(it.key()) && !others.isObject())
                return at + " is unknown";
            const QJsonValue rule = known.contains(it.key()) ? known[it.key()] : others;
            if (const QString found = flaw(it.value(), rule.toObject(), at); !found.isEmpty())
                return found;
        }
        return {};
    }

    static bool isOf(const QJsonValue& value, const QString& type)
    {
        if (type == "integer")
            return value.isDouble() && value.toDouble() == std::floor(value.toDouble());
        return type == "number"    ? value.isDouble()
               : type == "string"  ? value.isString()
               : type == "boolean" ? value.isBool()
               : type == "array"   ? value.isArray()
                                   : type == "object" && value.isObject();
    }

    static bool isWithin(double number, const QJsonObject& schema)
    {
        return !(schema.contains("minimum") && number < schema["minimum"].toDouble())
               && !(schema.contains("exclusiveMinimum")
                    && number <= schema["exclusiveMinimum"].toDouble())
               && !(schema.contains("maximum") && number > schema["maximum"].toDouble());
    }

    QJsonObject m_root;
};

const QString inDocs = SOURCE_DIR "/docs/ripstop-scene.schema.json";

} // namespace

class TestSchema : public QObject
{
    Q_OBJECT

private slots:
    // Written again by: ripstop-cli schema > docs/ripstop-scene.schema.json
    void isCurrent()
    {
        const Outcome outcome = call({"schema"});
        QCOMPARE(outcome.exitCode, 0);
        QVERIFY2(outcome.out == contentOf(inDocs),
                 "ripstop-cli schema > docs/ripstop-scene.schema.json");
    }

    void everySampleIsValid_data()
    {
        QTest::addColumn<QString>("file");
        for (const QString& name : QDir(SCENES_DIR).entryList({"*.ripstop.json"}))
            QTest::newRow(qPrintable(name)) << QString(SCENES_DIR "/" + name);
    }

    void everySampleIsValid()
    {
        QFETCH(QString, file);
        const QJsonDocument document = QJsonDocument::fromJson(contentOf(file));
        QVERIFY(document.isObject());
        QCOMPARE(validator().flaw(document.object()), QString());
    }

    void flawsAreFound_data()
    {
        QTest::addColumn<QByteArray>("items");
        QTest::addColumn<QString>("flaw");
        const auto row = [](const char* items, const char* flaw) {
            QTest::newRow(flaw) << QByteArray(items) << QString(flaw);
        };
        row(R"({"type": "wind", "id": 1, "velocty": [1, 0, 0]})",
            "file.items[0].velocty is unknown");
        row(R"({"type": "wind", "id": 1, "velocity": [1, 0]})",
            "file.items[0].velocity has another length");
        row(R"({"type": "wind", "id": 1, "kind": "storm"})", "file.items[0].kind is no choice");
        row(R"({"type": "wind", "id": 0})", "file.items[0].id is out of range");
        row(R"({"type": "wind"})", "file.items[0] has no id");
        row(R"({"type": "balloon", "id": 1})", "file.items[0] has an unknown type");
        row(R"({"type": "material", "id": 1, "color": "red"})",
            "file.items[0].color does not match");
        row(R"({"type": "material", "id": 1, "porosity": "none"})",
            "file.items[0].porosity is no number");
        row(R"({"type": "part", "id": 1, "particles": [{"id": 2, "mass": -1}]})",
            "file.items[0].particles[0].mass is out of range");
    }

    void flawsAreFound()
    {
        QFETCH(QByteArray, items);
        QFETCH(QString, flaw);
        const QByteArray text =
            "{\"format\": \"ripstop-scene\", \"version\": 1, \"items\": [" + items + "]}";
        const QJsonDocument document = QJsonDocument::fromJson(text);
        QVERIFY(document.isObject());
        QCOMPARE(validator().flaw(document.object()), flaw);
    }

private:
    static Validator validator()
    {
        return Validator(QJsonDocument::fromJson(contentOf(inDocs)).object());
    }
};

const RegisteredTest registered("test_schema", runPlain<TestSchema>);

} // namespace ripstop::test_schema
#include "test_schema.moc"
