// What a built part is made of by now, after steps through the library, and that it stays so when
// the part is built again.
#include "materials/neighbours.h"
#include "model/rebuilding.h"
#include "registered_test.h"

namespace ripstop::test_chosen_materials {

using namespace rebuilding;

namespace {

Id materialNamed(const Scene& scene, std::string_view name)
{
    for (const Entry& entry : scene.items)
        if (const auto* material = std::get_if<Material>(&entry.item);
            material && material->name == name)
            return entry.id;
    return noId;
}

double massOf(const Scene& scene)
{
    double sum = 0.0;
    for (const Particle& particle : part(scene).particles)
        sum += particle.mass;
    return sum;
}

// Of the links of a material, m.
double lengthOf(const Scene& scene, std::string_view material)
{
    double sum = 0.0;
    for (const Link& link : part(scene).links)
        if (link.material == materialNamed(scene, material))
            sum += link.restLength;
    return sum;
}

} // namespace

class TestChosenMaterials : public QObject
{
    Q_OBJECT

private slots:
    // A line of the library is exchanged twice: nothing of that is lost with another parameter, and
    // a parameter that is about the line itself wins.
    void exchangedMaterialsStay()
    {
        const Parameters real{{"cloth", 2}, {"spars", 1}, {"cord", 3}};
        Scene first = inserting({}, "delta_kite", {}, real);
        Scene scene = first;
        const auto stronger = [&] {
            const Result<StepEdit> step =
                stepEdit(scene, {materialNamed(scene, "line")}, MaterialStep::Stronger);
            QVERIFY(step);
            scene = after(scene, step->edit.edit);
        };
        stronger();
        stronger();
        const double density = *itemNamed<Material>(scene, "line")->linearDensity;
        const double densityAtFirst = *itemNamed<Material>(first, "line")->linearDensity;
        QVERIFY(density > densityAtFirst);
        QVERIFY(handWork(scene, partId(scene)).isNothing());

        // what is added of the line weighs what the line is made of by now: kg/m times m
        const Parameters wish{{"line_length", part(scene).parameters.at("line_length") + 5.0}};
        Scene longer = changing(scene, wish);
        QCOMPARE(*itemNamed<Material>(longer, "line")->linearDensity, density);
        QVERIFY(handWork(longer, partId(longer)).isNothing());
        const Scene asBought = changing(first, wish);
        QVERIFY(std::abs(lengthOf(longer, "line") - lengthOf(scene, "line") - 5.0) < 1e-9);
        const double more = massOf(longer) - massOf(scene);
        const double atFirst = massOf(asBought) - massOf(first);
        QVERIFY(std::abs(more - atFirst - 5.0 * (density - densityAtFirst)) < 1e-12);

        // LTC65 is no line that the builder offers, and is told
        ChosenNow now = chosenNow(scene, partId(scene));
        const auto staying = [&] { return rebuilt(scene, partId(scene), now.parameters)->staying; };
        QCOMPARE(staying().at(0).preset->name, std::string("liros_ltc65"));
        now.parameters["cord"] = 1;
        QVERIFY(staying().empty());

        // LTC80 is one, so that the line of before can be chosen again
        scene = after(
            scene,
            presetEdit(scene, **findPreset("liros_ltc80"), {materialNamed(scene, "line")})->edit);
        QCOMPARE(chosenNow(scene, partId(scene)).parameters.at("cord"), 4.0);
        Scene back = changing(scene, {{"cord", 3}});
        QCOMPARE(*itemNamed<Material>(back, "line")->linearDensity, densityAtFirst);
        QVERIFY(std::abs(massOf(back) - massOf(first)) < 1e-12);

        // another line, and the kite is that which is built with it
        const Scene other = changing(scene, {{"cord", 1}});
        Parameters asked = real;
        asked["cord"] = 1;
        const Scene wanted = inserting({}, "delta_kite", {}, asked);
        QVERIFY(handWork(other, partId(other)).isNothing());
        QVERIFY(std::abs(massOf(other) - massOf(wanted)) < 1e-12);
    }
};

const RegisteredTest registered("test_chosen_materials", runPlain<TestChosenMaterials>);

} // namespace ripstop::test_chosen_materials
#include "test_chosen_materials.moc"
