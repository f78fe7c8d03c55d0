// What makes a value count that does nothing: widths from the mesh, panels that carry, and the rest
// of the table of remedies.
//
// Stages: widths against those of woven sheets and of a triangle, worked out by hand; panels of a
// kite in place of its seams; then every remedy of every value in all designs: it is undone, and
// the value counts afterwards or has another reason.
#include "model/material_sheets.h"
#include "registered_test.h"

#include "author/carry_fabric.h"
#include "author/remedy.h"
#include "author/strip_widths.h"
#include "check/check.h"
#include "materials/presets.h"
#include "scene/element_index.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace ripstop::test_remedy {

namespace {

// The first material of this name.
Id materialCalled(const Scene& scene, std::string_view name)
{
    for (const Entry& entry : scene.items)
        if (const Material* material = std::get_if<Material>(&entry.item);
            material && material->name == name)
            return entry.id;
    return noId;
}

void giveTo(Scene& scene, Id material, const char* preset)
{
    give(std::get<Material>(*findItem(scene, material)), **findPreset(preset));
}

} // namespace

class TestRemedy : public QObject
{
    Q_OBJECT

private slots:
    // The builder of cloth knows the widths: q and p of threads inside, half of them at edges, and
    // D^3 / (2 p q) of diagonals. Taken away, they come back from the mesh, also where the cloth is
    // gathered to a third of its width: it is as wide as it was cut.
    void widthsOfWovenSheets_data()
    {
        QTest::addColumn<double>("gathered");
        QTest::newRow("flat") << 1.0;
        QTest::newRow("gathered") << 0.3;
    }

    void widthsOfWovenSheets()
    {
        QFETCH(double, gathered);
        Parameters parameters = sheet(4, 2, 0.3);
        parameters["columns"] = 6; // cells that are not square
        Scene woven = *build(*findBuilder("cloth"), parameters);
        Scene bare = woven;
        for (Link& link : partOf(bare).links) {
            link.role = LinkRole::Line;
            link.width = 0.0;
            link.cellAspect = 1.0;
        }
        for (Particle& particle : partOf(bare).particles)
            particle.position.x() *= gathered;
        const auto made = widthsFromMesh(bare, materialsOf(bare));
        QVERIFY(made);
        const Scene before = bare;
        const Edit undo = apply(bare, made->edit);
        std::size_t threads = 0, biases = 0;
        for (const Link& link : partOf(bare).links) {
            const Link& wanted = *findRow(partOf(woven).links, link.id);
            QCOMPARE(link.role, wanted.role);
            NEAR(link.width, wanted.width, 1e-9);
            NEAR(link.cellAspect, wanted.cellAspect, 1e-9);
            threads += link.role == LinkRole::Thread;
            biases += link.role == LinkRole::Bias;
        }
        QCOMPARE(made->threads, threads);
        QCOMPARE(made->biases, biases);
        QCOMPARE(threads, std::size_t(6 * 5 + 4 * 7)); // sides of 6 x 4 cells
        QCOMPARE(biases, std::size_t(2 * 6 * 4));
        (void)apply(bare, undo);
        QVERIFY(bare == before);
    }

    // Van Gelder: each side of a triangle stands for all of it, w = A / L.
    void widthsOfATriangle()
    {
        Scene scene;
        Part part;
        const double side = 0.4;
        const double height = side * std::sqrt(0.75);
        scene.items.push_back({takeId(scene), Material{.name = "cloth"}});
        const Id cloth = scene.items.back().id;
        for (const Vec3& at : {Vec3(0, 0, 0), Vec3(side, 0, 0), Vec3(0.5 * side, height, 0)})
            part.particles.push_back({.id = takeId(scene), .position = at});
        const auto& p = part.particles;
        for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {0, 2}})
            part.links.push_back({.id = takeId(scene),
                                  .from = p[std::size_t(a)].id,
                                  .to = p[std::size_t(b)].id,
                                  .material = cloth,
                                  .restLength = side});
        const Scene bare = [&] {
            Scene copy = scene;
            copy.items.push_back({takeId(copy), part});
            return copy;
        }();
        QVERIFY(widthsFromMesh(bare, {cloth}).message().english().find("draw panels")
                != std::string::npos);
        part.panels.push_back(
            {.id = takeId(scene), .a = p[0].id, .b = p[1].id, .c = p[2].id, .material = cloth});
        scene.items.push_back({takeId(scene), part});
        (void)apply(scene, widthsFromMesh(scene, {cloth})->edit);
        for (const Link& link : partOf(scene).links) {
            QCOMPARE(link.role, LinkRole::Thread);
            NEAR(link.width, 0.5 * height, 1e-12);
        }
    }

    // The newcomer's way: a delta of bare rods, whose sail is given a cloth.
    void theSailOfAKiteCarries()
    {
        Scene scene = *build(*findBuilder("delta_kite"), {});
        const Id sail = materialCalled(scene, "sail");
        giveTo(scene, sail, "ripstop_075");
        const Property& stiffness = propertyOf<&Material::membraneStiffness>();
        QVERIFY(whyIdle(scene, usageOf(scene), stiffness, sail));
        const auto remedies = remediesOf(scene, usageOf(scene), stiffness, sail);
        QCOMPARE(remedies.size(), std::size_t(1)); // no link is of it that could get a width
        const Scene before = scene;
        const std::size_t links = partOf(scene).links.size();
        const Result<Edit> edit = remedies.front()->edit(scene, stiffness, {sail});
        QVERIFY(edit);
        const Edit undo = apply(scene, *edit);
        QVERIFY(!whyIdle(scene, usageOf(scene), stiffness, sail));
        QCOMPARE(partOf(scene).carrier, FabricKind::Panels);
        QVERIFY(!firstError(scene, ElementIndex(scene)));
        QVERIFY(partOf(scene).links.size() < links); // seams went
        const auto count = [](const Scene& of, Id material) {
            std::size_t sum = 0;
            forEachPart(of, [&](Id, const Part& part) {
                sum += std::size_t(std::ranges::count(part.links, material, &Link::material));
            });
            return sum;
        };
        for (const char* kept : {"spar", "line"}) // what holds the sail stays
            QCOMPARE(count(scene, materialCalled(scene, kept)),
                     count(before, materialCalled(before, kept)));
        (void)apply(scene, undo);
        QVERIFY(scene == before);
    }

    // With its border and keel of the same cloth it flies.
    void theSailFlies()
    {
        Scene scene = *build(*findBuilder("delta_kite"), {});
        const std::vector<Id> cloth{materialCalled(scene, "sail"), materialCalled(scene, "border"),
                                    materialCalled(scene, "keel cloth")};
        for (const Id id : cloth)
            giveTo(scene, id, "ripstop_075");
        (void)apply(scene, *panelsCarry(scene, cloth));
        Simulation simulation(*compile(scene, 1, 1));
        QVERIFY(simulation.runUntil(0.5));
        const State& state = simulation.state();
        for (const auto& velocity : state.velocity)
            QVERIFY(velocity.norm() < 30.0); // m/s, of a wind of 6
    }

    void panelsWithoutStiffnessAreRefused()
    {
        const Scene scene = *build(*findBuilder("delta_kite"), {});
        const Result<Edit> edit = panelsCarry(scene, {materialCalled(scene, "sail")});
        QVERIFY(!edit && edit.message().english().find("sail has no membrane") == 0);
    }

    // With elastic panels the strengths are the limits; with threads the pull per width is.
    void strengthsBecomeLimits()
    {
        Scene scene = *build(*findBuilder("cloth"), sheet(4, 2, 0.3));
        const Id threads = materialCalled(scene, "structural");
        giveTo(scene, threads, "ripstop_075");
        const Property& limit = propertyOf<&Material::tearLimit>();
        const auto remedies = remediesOf(scene, usageOf(scene), limit, threads);
        QCOMPARE(remedies.size(), std::size_t(1));
        (void)apply(scene, *remedies.front()->edit(scene, limit, {threads}));
        const Material& material = *findItem<Material>(scene, threads);
        QCOMPARE(material.tearRule, TearRule::Tension);
        QCOMPARE(material.tearLimit, 8000.0); // N/m, its warp strength
    }

    void everyRemedyHelps_data()
    {
        QTest::addColumn<QString>("builder");
        for (const Builder& builder : allBuilders())
            QTest::newRow(builder.name.data()) << QString::fromUtf8(builder.name.data());
    }
    void everyRemedyHelps()
    {
        QFETCH(QString, builder);
        Scene scene = *build(*findBuilder(builder.toStdString()), {});
        scene.settings.airDensity = 0.0;
        for (const Entry& entry : scene.items)
            if (std::holds_alternative<Material>(entry.item))
                giveTo(scene, entry.id, "ripstop_075");
        for (const Solver solver : {Solver::PaperJacobi, Solver::Auto}) {
            scene.settings.solver = solver;
            const Usage usage = usageOf(scene);
            for (const Property& property : allProperties()) {
                if (isElement(property.kind))
                    continue;
                for (const Entry& entry : scene.items)
                    tryRemedies(scene, usage, property, entry.id);
                tryRemedies(scene, usage, property, settingsId);
            }
        }
    }

private:
    static void tryRemedies(const Scene& scene, const Usage& usage, const Property& property, Id id)
    {
        const auto why = whyIdle(scene, usage, property, id);
        const auto remedies = remediesOf(scene, usage, property, id);
        QVERIFY(why || remedies.empty());
        for (const Remedy* remedy : remedies) {
            Scene better = scene;
            const Result<Edit> edit = remedy->edit(scene, property, {id});
            if (!edit)
                continue; // it says why
            const Edit undo = apply(better, *edit);
            QVERIFY2(whyIdle(better, usageOf(better), property, id) != why,
                     (std::string(property.key) + ": " + remedy->label.english()).c_str());
            (void)apply(better, undo);
            QVERIFY(better == scene);
        }
    }
};

const RegisteredTest registered("test_remedy", runPlain<TestRemedy>);

} // namespace ripstop::test_remedy
#include "test_remedy.moc"
