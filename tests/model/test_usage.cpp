// Which values of a design have an effect, and what is said of those that have none
// (scene/usage.h).
//
// A small scene with one element of each kind is asked for each row why a value is idle; then
// values are changed, and the answers have to follow: own values in place of the material's,
// paths, air, and what an edit makes anew.
#include "builders/builder.h"
#include "registered_test.h"
#include "scene/items.h"
#include "scene/path.h"
#include "scene/usage.h"

#include <QtTest>

namespace ripstop::test_usage {

namespace {

// Ids: 1 part (2, 3, 4 particles; 5 a rod, 6 a spring; 7 a panel), 8 the material of the rod, 9 of
// the spring, 10 of the panel, 11 wind, 12 collider.
Scene mixed()
{
    Scene scene;
    Part part;
    for (const std::uint32_t id : {2, 3, 4})
        part.particles.push_back({.id = Id{id}});
    part.links.push_back({.id = Id{5}, .from = Id{2}, .to = Id{3}, .material = Id{8}});
    part.links.push_back(
        {.id = Id{6}, .from = Id{3}, .to = Id{4}, .material = Id{9}, .kind = LinkKind::Spring});
    part.panels.push_back({.id = Id{7}, .a = Id{2}, .b = Id{3}, .c = Id{4}, .material = Id{10}});
    scene.items = {{Id{1}, part},        {Id{8}, Material{}}, {Id{9}, Material{}},
                   {Id{10}, Material{}}, {Id{11}, Wind{}},    {Id{12}, Collider{}}};
    scene.nextId = Id{13};
    return scene;
}

const Property& propertyOf(const Scene& scene, Id id, std::string_view key)
{
    const ConstRef thing = *find(scene, id);
    return *findProperty(kindOf(thing), key);
}

std::optional<std::string> why(const Scene& scene, Id id, std::string_view key)
{
    return whyIdle(scene, usageOf(scene), propertyOf(scene, id, key), id);
}

void set(Scene& scene, Id id, std::string_view key, Value value)
{
    const Property& property = propertyOf(scene, id, key);
    (void)apply(scene, Edit{Message(), {SetValues{&property, {id}, {std::move(value)}}}});
}

bool says(const std::optional<std::string>& reason, const char* words)
{
    return reason && reason->find(words) != std::string::npos;
}

} // namespace

class TestUsage : public QObject
{
    Q_OBJECT

private slots:
    // Kites keep their shape by rigidity particles, so that no spar of theirs bends; a spar of its
    // own does.
    void rigidityHoldsSpars()
    {
        const auto reason = [](const char* builder, const char* name) {
            const Scene scene = *build(*findBuilder(builder), newDesign(*findBuilder(builder), {}));
            return why(scene, *findNamed(scene, Kind::Material, name), "flexuralRigidity");
        };
        for (const char* kite : {"delta_kite", "rectangular_kite"})
            QVERIFY2(says(reason(kite, "spar"), "rigidity particles"), kite);
        QVERIFY(!reason("hang_glider", "tube"));
        const Edit edit{
            {}, {SetValues{findProperty(Kind::Material, "flexuralRigidity"), {Id{8}}, {1.0}}}};
        QVERIFY(changesUsage(edit)); // who has a stiffness is a spar
    }

    // Which values a designer changes without effect, and which with one.
    void values_data()
    {
        QTest::addColumn<int>("id");
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("because"); // empty: it does something
        const auto row = [](const char* name, int id, const char* key, const char* because) {
            QTest::newRow(name) << id << key << because;
        };
        row("stiffness of a rod", 5, "stiffness", "the link is a rod");
        row("compliance of a rod", 5, "compliance", "");
        row("compliance of a spring", 6, "compliance", "the link is a spring");
        row("stiffness of a spring", 6, "stiffness", "");
        row("stiffness of a material of rods", 8, "stiffness", "all rods");
        row("compliance of a material of springs", 9, "compliance", "all springs");
        row("stiffness of a material of springs", 9, "stiffness", "");
        row("stiffness of fabric without links", 10, "stiffness", "no link is made of it");
        row("porosity of a material of links", 8, "porosity", "no panel is made of it");
        row("skin friction of fabric", 10, "skinFriction", "");
        row("tear limit of what never tears", 8, "tearLimit", "never tears");
        row("drag coefficient of a line without width", 8, "dragCoefficient", "diameter is 0");
        row("roughness of an even wind", 11, "roughness", "logarithmic");
        row("velocity of an even wind", 11, "velocity", "");
        row("radius of a plane", 12, "radius", "only round shapes");
        row("sweeps of the automatic solver", int(settingsId), "sweeps", "one sweep");
        row("its wanted strain", int(settingsId), "strainGoal", "");
        row("areal density of a line", 8, "arealDensity", "no panel is made of it");
        row("warp strength of a line", 8, "warpStrength", "its links are all lines");
        row("linear density of a line", 8, "linearDensity", "");
        row("areal density of fabric", 10, "arealDensity", "");
        row("line strength of fabric", 10, "lineStrength", "no link of it has the role line");
        row("canopy pressure of fabric", 1, "canopyPressure", "");
        row("friction without self-contact", 1, "selfFriction", "no self-contact");
        row("added mass without canopy pressure", 1, "addedMass", "no canopy pressure");
    }
    void values()
    {
        QFETCH(int, id);
        QFETCH(QString, key);
        QFETCH(QString, because);
        const auto reason = why(mixed(), Id{std::uint32_t(id)}, key.toStdString());
        QCOMPARE(reason.has_value(), !because.isEmpty());
        if (reason)
            QVERIFY2(QString::fromStdString(*reason).contains(because), reason->c_str());
    }

    void aPartOfLinesIsNoCloth()
    {
        Scene scene = mixed();
        for (Entry& entry : scene.items)
            if (auto* part = std::get_if<Part>(&entry.item))
                part->panels.clear();
        for (const char* key : {"carrier", "canopyPressure", "areaTarget"})
            QVERIFY2(says(why(scene, Id{1}, key), "no panels"), key);
        QVERIFY(!why(scene, Id{1}, "massTarget"));
    }

    // Iterations are for rods: where all is springs they do nothing. The solver matters, since the
    // automatic one solves springs together that are too stiff to be forces.
    void sweepsNeedRods()
    {
        Scene scene = mixed();
        for (const Solver solver :
             {Solver::AveragedJacobi, Solver::PaperJacobi, Solver::GaussSeidel, Solver::Direct}) {
            scene.settings.solver = solver;
            QVERIFY(!why(scene, settingsId, "sweeps"));
            QVERIFY(why(scene, settingsId, "strainGoal"));
        }
        set(scene, Id{5}, "kind", std::string("spring"));
        QVERIFY(says(why(scene, settingsId, "sweeps"), "no link is a rod"));
        QVERIFY(!why(scene, settingsId, "solver"));
    }

    void ownValuesTakeThePlaceOfTheMaterials()
    {
        Scene scene = mixed();
        set(scene, Id{6}, "stiffness", 40.0);
        QVERIFY(says(why(scene, Id{9}, "stiffness"), "its own"));
        set(scene, Id{6}, "stiffness", std::monostate());
        QVERIFY(!why(scene, Id{9}, "stiffness"));
    }

    void thePlaceOfWhatFollowsAPath()
    {
        Scene scene = mixed();
        QVERIFY(!why(scene, Id{12}, "position"));
        set(scene, Id{12}, "path", std::string("0: 0 1 0"));
        QVERIFY(says(why(scene, Id{12}, "position"), "path"));
    }

    void withoutAirItsNumbersAreIdle()
    {
        Scene scene = mixed();
        scene.settings.airDensity = 0.0;
        QVERIFY(says(why(scene, Id{11}, "velocity"), "air density"));
        QVERIFY(says(why(scene, Id{10}, "skinFriction"), "air density"));
    }

    // The count is made anew after every edit that could change it.
    void editsThatChangeTheUsage()
    {
        const auto setting = [](Kind kind, const char* key) {
            return Edit{Message(), {SetValues{findProperty(kind, key), {Id{5}}, {1.0}}}};
        };
        QVERIFY(!changesUsage(setting(Kind::Particle, "mass")));
        QVERIFY(!changesUsage(setting(Kind::Material, "stiffness")));
        QVERIFY(!changesUsage(setting(Kind::Link, "restLength")));
        for (const char* key : {"kind", "material", "role", "width", "stiffness", "tearLimit"})
            QVERIFY2(changesUsage(setting(Kind::Link, key)), key);
        QVERIFY(changesUsage(setting(Kind::Panel, "material")));
        QVERIFY(changesUsage({{}, {RemoveItem{Id{1}}}}));
    }
};

const RegisteredTest registered("test_usage", runPlain<TestUsage>);

} // namespace ripstop::test_usage
#include "test_usage.moc"
