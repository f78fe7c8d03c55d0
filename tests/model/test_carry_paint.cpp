// What is painted on a part of a builder, when it is built again: it stays where it was on the
// cloth, and what finds no place is counted.
#include "derived/flat_panel.h"
#include "model/rebuilding.h"
#include "registered_test.h"
#include "scene/particle_of.h"
#include "select/elements.h"
#include "shaping/brush.h"

#include <QtTest>

#include <cmath>

namespace ripstop::test_carry_paint {

using namespace rebuilding;

namespace {

// A kite of which panels carry the cloth.
Scene kite(const Parameters& more = {})
{
    Parameters given{{"cloth", 2}, {"spars", 1}, {"cord", 3}};
    given.insert(more.begin(), more.end());
    return built("delta_kite", given);
}

Part& partIn(Scene& scene) { return std::get<Part>(*findItem(scene, partId(scene))); }

Vec3 middleOf(const Scene& scene, const Panel& panel)
{
    const auto at = [&](Id id) -> Vec3 { return particleOf(scene, id)->position; };
    return (at(panel.a) + at(panel.b) + at(panel.c)) / 3.0;
}

double uprightOf(const Scene& scene, const Panel& panel)
{
    return uprightGrain(*particleOf(scene, panel.a), *particleOf(scene, panel.b),
                        *particleOf(scene, panel.c));
}

// Of a design that is changed, what it loses.
Rebuilt rebuiltWith(const Scene& scene, const Parameters& given)
{
    Parameters parameters = chosenNow(scene, partId(scene)).parameters;
    for (const auto& [key, value] : given)
        parameters[key] = value;
    return *rebuilt(scene, partId(scene), parameters);
}

void paintRightHalf(Scene& scene)
{
    for (Panel& panel : partIn(scene).panels)
        if (middleOf(scene, panel).z() > 0.0) {
            panel.strengthFactor = 0.5;
            panel.stiffnessFactor = 2.0;
        }
}

} // namespace

class TestCarryPaint : public QObject
{
    Q_OBJECT

private slots:
    // A wider kite with the same mesh: each row keeps its own numbers, and nothing is lost.
    void theSameMeshKeepsEachRow()
    {
        Scene scene = kite();
        auto& panels = partIn(scene).panels;
        for (std::size_t i = 0; i < panels.size(); ++i)
            panels[i].strengthFactor = 1.0 + double(i);
        partIn(scene).links.back().stiffnessFactor = 3.0;
        const Rebuilt wider = rebuiltWith(scene, {{"span", 2.5}});
        QVERIFY(wider.lost.isNothing());
        QCOMPARE(wider.painted, panels.size()); // the first one has 1, as it was built, plus a link
        const Scene changed = after(scene, wider.edit);
        for (std::size_t i = 0; i < panels.size(); ++i)
            QCOMPARE(part(changed).panels[i].strengthFactor, 1.0 + double(i));
        QCOMPARE(part(changed).links.back().stiffnessFactor, 3.0);
        QVERIFY(part(changed).particles.front().position != part(scene).particles.front().position
                || part(changed).particles[1].position != part(scene).particles[1].position);
        QCOMPARE(handWork(changed, partId(changed)).painted, panels.size());
    }

    void nothingChangesWithTheSameParameters()
    {
        Scene scene = kite();
        paintRightHalf(scene);
        partIn(scene).panels.front().grain += 30.0;
        QVERIFY(changing(scene, {}) == scene);
    }

    // Of a finer and of a coarser mesh, the panels that lie farther from the middle than the larger
    // panels are wide have what their side has.
    void anotherMeshKeepsPlaces_data()
    {
        QTest::addColumn<double>("factor");
        QTest::newRow("finer") << 2.0;
        QTest::newRow("coarser") << 0.5;
    }

    void anotherMeshKeepsPlaces()
    {
        QFETCH(double, factor);
        Scene scene = kite();
        paintRightHalf(scene);
        const double segments = part(scene).parameters.at("segments");
        const double wanted = std::max(std::round(factor * segments), 2.0);
        const Rebuilt again = rebuiltWith(scene, {{"segments", wanted}});
        const Scene changed = after(scene, again.edit);
        QVERIFY(part(changed).panels.size() != part(scene).panels.size());
        const double halfSpan = 0.5 * part(scene).parameters.at("span");
        const double border = halfSpan / std::min(segments, wanted);
        int seen = 0;
        for (const Panel& panel : part(changed).panels) {
            const double z = middleOf(changed, panel).z();
            if (std::abs(z) < border)
                continue;
            ++seen;
            QCOMPARE(panel.strengthFactor, z > 0.0 ? 0.5 : 1.0);
            QCOMPARE(panel.stiffnessFactor, z > 0.0 ? 2.0 : 1.0);
        }
        QVERIFY(seen > 4);
        QCOMPARE(again.painted,
                 std::size_t(std::ranges::count_if(part(changed).panels, [](const Panel& panel) {
                     return panel.strengthFactor != 1.0;
                 })));
        QCOMPARE(again.lost.changed + again.lost.moved + again.lost.removed, std::size_t(0));
    }

    // A grain of 30 degrees to the picture is that in whatever mesh and shape.
    void grainKeepsItsAngleToThePicture_data()
    {
        QTest::addColumn<Parameters>("given");
        QTest::newRow("wider") << Parameters{{"span", 2.5}};
        QTest::newRow("finer") << Parameters{{"segments", 24}};
    }

    void grainKeepsItsAngleToThePicture()
    {
        QFETCH(Parameters, given);
        Scene scene = kite();
        Brush brush{.what = Painted::Grain, .radius = 100.0, .falloff = Falloff::Hard};
        brush.values[std::size_t(Painted::Grain)] = 30.0;
        BrushStroke stroke(scene, brush);
        QVERIFY(stroke.paint(Vec3::Zero(), Vec3::Zero()));
        (void)apply(scene, stroke.edit());
        const Scene changed = changing(scene, given);
        for (const Panel& panel : part(changed).panels) {
            const double off = panel.grain - uprightOf(changed, panel) - 30.0;
            QVERIFY2(std::abs(std::remainder(off, 180.0)) < 1e-6, qPrintable(QString::number(off)));
        }
    }

    // The keel has no texture, and keeps its paint by where it is: what is painted on its front
    // half is no mean of all of it.
    void clothWithoutATextureKeepsPlaces()
    {
        Scene scene = kite();
        const auto isKeel = [](const Scene& one, const Panel& panel) {
            return findItem<Material>(one, panel.material)->name == "keel cloth";
        };
        const auto boxOf = [&](const Scene& one) {
            Eigen::AlignedBox3d box;
            for (const Panel& panel : part(one).panels)
                if (isKeel(one, panel))
                    box.extend(middleOf(one, panel));
            return box;
        };
        for (Panel& panel : partIn(scene).panels)
            if (isKeel(scene, panel) && middleOf(scene, panel).x() > boxOf(scene).center().x())
                panel.strengthFactor = 0.5;
        const Scene changed = changing(scene, {{"keel", 10}});
        const Eigen::AlignedBox3d box = boxOf(changed);
        int seen = 0;
        for (const Panel& panel : part(changed).panels) {
            const double off = middleOf(changed, panel).x() - box.center().x();
            if (!isKeel(changed, panel) || std::abs(off) < 0.2 * box.sizes().x())
                continue;
            ++seen;
            QCOMPARE(panel.strengthFactor, off > 0.0 ? 0.5 : 1.0);
        }
        QVERIFY(seen > 10);
    }

    // The weak place of a rope stays at its share of the length, a quarter from the top.
    void aLineKeepsItsWeakPlace()
    {
        Scene scene = built("rope", {{"segments", 8}, {"length", 4}, {"angle", 0}});
        partIn(scene).links[1].strengthFactor = 0.2; // from 1/8 to 2/8
        const Scene changed = changing(scene, {{"segments", 32}, {"length", 10}});
        const auto& links = part(changed).links;
        QCOMPARE(links.size(), std::size_t(32));
        for (std::size_t i = 0; i < links.size(); ++i) {
            const double share = (double(i) + 0.5) / 32.0;
            if (std::abs(share - 0.125) < 0.03 || std::abs(share - 0.25) < 0.03)
                continue; // beside its ends
            QCOMPARE(links[i].strengthFactor, share > 0.125 && share < 0.25 ? 0.2 : 1.0);
        }
    }

    // What was painted on a tail that is taken off is counted, as other work by hand is.
    void whatFindsNoPlaceIsCounted()
    {
        Scene scene = built("rectangular_kite");
        Group& tail = *itemNamed<Group>(scene, "tail nodes");
        std::size_t painted = 0;
        for (Link& link : partIn(scene).links)
            if (std::ranges::count(tail.members, link.from)
                && std::ranges::count(tail.members, link.to)) {
                link.strengthFactor = 0.5;
                ++painted;
            }
        QVERIFY(painted > 0);
        QCOMPARE(handWork(scene, partId(scene)).painted, painted);
        const Rebuilt bare = rebuiltWith(scene, {{"tail_length", 0.0}});
        QCOMPARE(bare.lost.painted, painted);
        QCOMPARE(bare.painted, std::size_t(0));
        QVERIFY(rebuiltWith(scene, {{"gusts", 1.0}}).lost.isNothing());
    }

    // Where a panel was cut away, the others keep what was painted on them; it comes again, bare.
    void rowsThatWereRemovedDoNotShiftThePaint()
    {
        Scene scene = kite();
        paintRightHalf(scene);
        const Scene whole = scene;
        const std::size_t cut = 5;
        partIn(scene).panels.erase(partIn(scene).panels.begin() + std::ptrdiff_t(cut));
        const Rebuilt again = rebuiltWith(scene, {});
        QCOMPARE(again.lost.removed, std::size_t(1));
        const Scene changed = after(scene, again.edit);
        QCOMPARE(part(changed).panels.size(), part(whole).panels.size());
        for (std::size_t i = 0; i < part(whole).panels.size(); ++i)
            QCOMPARE(part(changed).panels[i].strengthFactor,
                     i == cut ? 1.0 : part(whole).panels[i].strengthFactor);
    }
};

const RegisteredTest registered("test_carry_paint", runPlain<TestCarryPaint>);

} // namespace ripstop::test_carry_paint
#include "test_carry_paint.moc"
