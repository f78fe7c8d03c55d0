// Colours by tear limit, the peak, and arrows on elements.
//
// Stages: colours by tear load and stress; the ghost of the design; trails; the range of colours
// and the peak; then arrows, and how many of them are drawn.
#include "layers/grain_layer.h"
#include "layers/vector_layer.h"
#include "look/design_ghost.h"
#include "look/loose_particles.h"
#include "look/quantity_values.h"
#include "look/trails.h"
#include "look/vectors.h"
#include "overlays/legend.h"
#include "overlays/overlay_paint.h"
#include "overlays/range_editor.h"
#include "views/bare_view.h"
#include "views/run_with_widgets.h"
#include "views/small_scenes.h"

#include <QLineEdit>
#include <QPainter>
#include <QtTest>

#include <cmath>
#include <limits>

namespace ripstop::test_see {

namespace {

// Two springs of 2 m in a row, pulled by 30 N and 10 N, and a panel.
Frame frame()
{
    auto layout = std::make_shared<Layout>();
    layout->particleId = {11, 12, 13};
    layout->links = {{21, LinkKind::Spring, 0, 1, 2.0}, {22, LinkKind::Spring, 1, 2, 2.0}};
    layout->panelId = {31};
    layout->panelCorners = {{0, 1, 2}};
    Frame frame;
    frame.layout = layout;
    frame.position = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}};
    frame.velocity = {{0, 0, 0}, {0, 1, 0}, {0, 0, -2}};
    frame.strain = {0.5, 0.1};
    frame.tension = {30.0, 10.0};
    frame.torn = {0, 0};
    frame.panelLoad = {{0, 0, 6}};
    frame.gone = {0};
    return frame;
}

} // namespace

class TestSee : public QObject
{
    Q_OBJECT

private slots:
    // What a link or a panel holds is seen by it; a torn one holds nothing any more.
    void whatNothingHoldsIsLoose()
    {
        Frame now = frame();
        auto layout = std::make_shared<Layout>(*now.layout);
        layout->particleId.push_back(14);
        now.layout = layout;
        now.position.push_back({9, 0, 0});
        QCOMPARE(looseParticles(now), (std::vector<std::uint8_t>{0, 0, 0, 1}));
        now.torn = {1, 1};
        QCOMPARE(looseParticles(now), (std::vector<std::uint8_t>{0, 0, 0, 1})); // the panel
        now.gone = {1};
        QCOMPARE(looseParticles(now), (std::vector<std::uint8_t>{1, 1, 1, 1}));
    }

    void tearLoad_data()
    {
        QTest::addColumn<int>("rule");
        QTest::addColumn<double>("limit");
        QTest::addColumn<double>("expected");
        QTest::newRow("never") << int(TearRule::Never) << 1.0 << 0.0;
        QTest::newRow("strain") << int(TearRule::Strain) << 2.0 << 0.25;
        QTest::newRow("force") << int(TearRule::Force) << 40.0 << 0.75;
        QTest::newRow("length") << int(TearRule::Length) << 6.0 << 0.5;
        QTest::newRow("no limit") << int(TearRule::Strain) << 0.0 << 0.0;
    }

    void tearLoad()
    {
        QFETCH(int, rule);
        QFETCH(double, limit);
        QFETCH(double, expected);
        Look look;
        look.linkTear = {{TearRule(rule), limit}, {TearRule::Never, 0.0}};
        const QuantityValues values = valuesOf(frame(), ColorBy::TearLoad, look);
        QCOMPARE(values.link[0], expected);
        QCOMPARE(values.link[1], 0.0);
    }

    // Of links their own; a panel that carries has its own as well, and another one the mean of
    // what its corners have: (2 + 2.5 + 3) / 3.
    void factors()
    {
        Look look;
        look.linkPainted = {{2.0, 0.5}, {3.0, 1.0}};
        look.panelPainted = {{4.0, 0.25}};
        look.panelWarp = {{}};
        const QuantityValues threads = valuesOf(frame(), ColorBy::Stiffness, look);
        QCOMPARE(threads.link, (std::vector<double>{2.0, 3.0}));
        QCOMPARE(threads.panel, std::vector<double>{2.5});
        QVERIFY(threads.isKnown);
        look.panelWarp[0].isThere = true;
        QCOMPARE(valuesOf(frame(), ColorBy::Strength, look).panel, std::vector<double>{0.25});
        look.linkPainted = {{}, {}};
        look.panelPainted = {{}};
        QVERIFY(!valuesOf(frame(), ColorBy::Strength, look).isKnown); // nothing is painted
    }

    // Panels that do not carry have no grain and are grey; the peak is of those that have one.
    void grain()
    {
        Look look;
        look.panelWarp = {{}};
        QVERIFY(!valuesOf(frame(), ColorBy::Grain, look).isKnown);
        QVERIFY(std::isnan(valuesOf(frame(), ColorBy::Grain, look).panel[0]));
        look.panelWarp = {{true, {1.0, 0.0}, 30.0}};
        const QuantityValues values = valuesOf(frame(), ColorBy::Grain, look);
        QCOMPARE(values.panel, std::vector<double>{30.0});
        QCOMPARE(peakOf(frame(), values).id, 31U);
        // along ab, around the middle, and longer where the panel is larger
        const std::array<Vec3, 3> corners{Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(3, 3, 0)};
        const auto [from, to] = grainStroke(look.panelWarp[0], corners);
        QVERIFY(((from + to) / 2.0 - Vec3(2, 1, 0)).norm() < 1e-12);
        QVERIFY((to - from).normalized().isApprox(Vec3::UnitX()));
        QVERIFY(std::abs((to - from).norm() - 0.6 * 3.0) < 1e-12);
    }

    // 30 N in a thread that stands for 0.02 m of fabric are 1500 N/m; a line has no width.
    void stress()
    {
        Look look;
        look.linkWidth = {0.02, 0.0};
        const Frame now = frame();
        const QuantityValues values = valuesOf(now, ColorBy::Stress, look);
        QCOMPARE(values.link, (std::vector<double>{1500.0, 0.0}));
        QCOMPARE(peakOf(now, values).id, 21U);
        QVERIFY(values.isKnown);
        look.linkWidth = {0.0, 0.0};
        QVERIFY(!valuesOf(now, ColorBy::Stress, look).isKnown);
    }

    // A panel that carries the pull of its fabric has its own strain and tension, in the colours of
    // links; one that does not has the largest of its corners.
    void elasticPanels()
    {
        Frame now = frame();
        auto layout = std::make_shared<Layout>(*now.layout);
        layout->panelId = {31, 32};
        layout->panelCorners = {{0, 1, 2}, {0, 2, 1}};
        now.layout = layout;
        now.panelPull = {{true, ClothState::Wrinkled, 0.7, 2500.0}, {}};
        now.gone = {0, 0};
        const Look look{.linkWidth = {0.02, 0.0}}; // m: 1500 N/m and none
        const QuantityValues stress = valuesOf(now, ColorBy::Stress, look);
        QCOMPARE(stress.link, (std::vector<double>{1500.0, 0.0}));
        QCOMPARE(stress.panel, (std::vector<double>{2500.0, 2500.0}));
        QVERIFY(stress.isKnown);
        QCOMPARE(peakOf(now, stress).id, 31U);
        QCOMPARE(peakOf(now, stress).value, 2500.0);
        const QuantityValues strain = valuesOf(now, ColorBy::Strain, look);
        QCOMPARE(strain.panel[0], 0.7);
        const QuantityValues wrinkles = valuesOf(now, ColorBy::Wrinkles, look);
        QCOMPARE(wrinkles.panel[0], 1.0);
        QVERIFY(std::isnan(wrinkles.panel[1]));
        QVERIFY(wrinkles.isKnown && wrinkles.link.empty() && wrinkles.particle.empty());

        now.panelPull = {};
        QVERIFY(valuesOf(now, ColorBy::Strain, look).panel.empty()); // by the corners, as ever
        QVERIFY(!valuesOf(now, ColorBy::Wrinkles, look).isKnown);
        QVERIFY(valuesOf(now, ColorBy::Stress, look).isKnown); // by the thread
        QVERIFY(!valuesOf(now, ColorBy::Stress, Look()).isKnown);
    }

    // What has no strength reads 0; where nothing has one, the legend says so.
    void margin()
    {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        Frame now = frame();
        now.linkMargin = {none, 0.4};
        now.panelMargin = {none};
        const QuantityValues values = valuesOf(now, ColorBy::Margin, Look());
        QCOMPARE(values.link, (std::vector<double>{0.0, 0.4}));
        QVERIFY(values.isKnown);
        QCOMPARE(peakOf(now, values).id, 22U);
        now.linkMargin = {none, none};
        QVERIFY(!valuesOf(now, ColorBy::Margin, Look()).isKnown);
        now.linkMargin = {};
        now.panelMargin = {};
        QVERIFY(!valuesOf(now, ColorBy::Margin, Look()).isKnown);
    }

    // The legend of margins has a mark where things break, in place of the number there, and none
    // where its range ends before.
    void legendOfMargins()
    {
        Legend legend;
        legend.setScale(ColorBy::Margin, {0.0, 2.0}, ColorMap::sequential());
        QCOMPARE(legend.title(), QString("Margin"));
        QVERIFY(legend.labels().contains("1, breaks"));
        QVERIFY(!legend.labels().contains("1.0") && !legend.labels().contains("1"));
        legend.setScale(ColorBy::Margin, {0.0, 0.5}, ColorMap::sequential());
        QVERIFY(!legend.labels().contains("1, breaks"));
        legend.setScale(ColorBy::Stress, {0.0, 2.0}, ColorMap::sequential());
        QVERIFY(!legend.labels().contains("1, breaks"));
    }

    // An end of the colours says when values lie beyond it, in whichever unit it is shown; one that
    // is just reached is none.
    void legendSaysThatValuesLieBeyond()
    {
        Legend legend;
        legend.setScale(ColorBy::Stress, {-8000.0, 8000.0}, ColorMap::diverging()); // in kN/m
        legend.setPeak(Peak{31, 8000.0}, {-8000.0, 8000.0});
        QVERIFY(!legend.goesAbove() && !legend.goesBelow());
        legend.setPeak(Peak{31, 8100.0}, {-7000.0, 8100.0});
        QVERIFY(legend.goesAbove() && !legend.goesBelow());
        legend.setPeak(Peak{31, 100.0}, {-8100.0, 100.0});
        QVERIFY(!legend.goesAbove() && legend.goesBelow());
        legend.setPeak(std::nullopt, {0.0, 9000.0});
        QVERIFY(!legend.goesAbove());
    }

    // What the colours are measured against: links and panels, else particles; what is no number
    // does not count.
    void extents()
    {
        const Frame now = frame();
        const auto extentBy = [&](ColorBy colorBy) {
            return extentOf(valuesOf(now, colorBy, Look()));
        };
        QCOMPARE(extentBy(ColorBy::Tension), (ValueRange{10.0, 30.0}));
        QCOMPARE(extentBy(ColorBy::Speed), (ValueRange{0.0, 2.0}));
        QCOMPARE(extentBy(ColorBy::Wrinkles), (ValueRange{0.0, 0.0})); // none has any
        QCOMPARE(extentBy(ColorBy::Material), (ValueRange{0.0, 0.0}));
    }

    // Of 100 panels that carry a pull one pulls a hundred times as hard: it lies beyond the colours
    // unless they go up to the peak. The legend tells which.
    void oneWorstPanelLeavesTheOthersTheirColours()
    {
        const Scene scene = oneOfEverything();
        BareView view(scene, QSize(300, 300));
        auto layout = std::make_shared<Layout>(*frame().layout);
        layout->panelId.resize(100, 31);
        layout->panelCorners.resize(100, {0, 1, 2});
        auto now = std::make_shared<Frame>(frame());
        now->layout = layout;
        now->panelPull.assign(100, {true, ClothState::Taut, 0.0, 10.0});
        now->panelPull[50].tension = 1000.0;
        now->gone.resize(100, 0);
        now->panelLoad.resize(100, Vec3::Zero());
        view.viewport.setColorBy(ColorBy::Stress);
        view.viewport.show(now);
        view.viewport.image();
        QCOMPARE(view.viewport.range(), (ValueRange{0.0, 10.0}));
        QVERIFY(view.viewport.legend().goesAbove());
        QCOMPARE(view.viewport.legend().peakText(), QString("peak 1000"));
        view.viewport.setRangeToPeak(true);
        view.viewport.image();
        QCOMPARE(view.viewport.range(), (ValueRange{0.0, 1000.0}));
        QVERIFY(!view.viewport.legend().goesAbove());
    }

    // In a picture of another size the colours of the legend are those of the fabric, and so are
    // the three of wrinkles.
    void legendKeepsItsColoursInPictures()
    {
        QWidget view;
        view.resize(400, 400);
        Legend legend(&view);
        constexpr double scale = 0.61;
        const auto colourAt = [&](double share) { // in the middle of the bar, 12 px from the left
            QImage picture(int(400 * scale), int(400 * scale), QImage::Format_RGB32);
            picture.fill(Qt::white);
            QPainter painter(&picture);
            paintOver(painter, picture.size(), {&legend}, view.size());
            painter.end();
            const double top = 12 + QFontMetrics(legend.font()).height() + 8;
            return picture.pixelColor(int(20 * scale), int((top + 200 * (1.0 - share)) * scale));
        };
        const auto isAbout = [](const QColor& seen, const Color& meant) {
            return std::abs(seen.red() - meant[0]) <= 6 && std::abs(seen.green() - meant[1]) <= 6
                   && std::abs(seen.blue() - meant[2]) <= 6; // a pixel is 0.8 % of the bar
        };
        view.show();
        legend.setScale(ColorBy::Stress, {0.0, 1.0}, ColorMap::sequential());
        for (const double share : {0.03, 0.25, 0.5, 0.75, 0.97})
            QVERIFY2(isAbout(colourAt(share), ColorMap::sequential().at(share)),
                     qPrintable(QString("%1: %2").arg(share).arg(colourAt(share).name())));
        legend.setScale(ColorBy::Wrinkles, {0.0, highestState}, ColorMap::sequential());
        for (const int state : {0, 1, 2})
            for (const double inside : {0.1, 0.9})
                QVERIFY(isAbout(colourAt((state + inside) / 3.0),
                                ColorMap::sequential().at(0.5 * state)));
    }

    // The legend of how panels lie has names instead of numbers, and neither peak nor range.
    void legendOfWrinkles()
    {
        Legend legend;
        legend.setScale(ColorBy::Wrinkles, {0.0, highestState}, ColorMap::sequential());
        legend.setPeak(Peak{31, 2.0});
        QCOMPARE(legend.title(), QString("Wrinkles"));
        QCOMPARE(legend.labels(), (QStringList{"slack", "wrinkled", "taut"}));
        QCOMPARE(legend.peakText(), QString());
        RangeEditor editor(legend, nullptr);
        editor.open();
        QVERIFY(editor.isHidden());
        legend.setScale(ColorBy::Stress, {0.0, 200.0}, ColorMap::sequential());
        QCOMPARE(legend.title(), QString("Fabric stress, N/m"));
        QCOMPARE(legend.labels().back(), QString("200"));
    }

    // What flies free is turned and shifted as a whole, and its ghost with it; deformed, the ghost
    // keeps its shape. What is pinned stays where it was drawn.
    void ghostOfTheDesign()
    {
        const auto design = std::make_shared<const Frame>(frame());
        Frame now = *design;
        Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
        motion.rotate(Eigen::AngleAxisd(2.0, Vec3(1, 2, 3).normalized()));
        motion.pretranslate(Vec3(10, -20, 5));
        for (Vec3& place : now.position)
            place = motion * place;
        auto ghost = designGhost(design, now);
        for (std::size_t i = 0; i < 3; ++i)
            QVERIFY((ghost->position[i] - now.position[i]).norm() < 1e-9);

        now.position[2] *= 1.5;
        ghost = designGhost(design, now);
        QVERIFY(std::abs((ghost->position[1] - ghost->position[0]).norm() - 3.0) < 1e-9);
        const auto middle = [](const Frame& f) {
            return Vec3((f.position[0] + f.position[1] + f.position[2]) / 3.0);
        };
        QVERIFY((middle(*ghost) - middle(now)).norm() < 1e-9);

        auto held = std::make_shared<Frame>(frame());
        auto layout = std::make_shared<Layout>(*held->layout);
        layout->pinned = {1, 0, 0};
        held->layout = layout;
        QCOMPARE(designGhost(held, now)->position, held->position);
    }

    // Trails are as long as five seconds of the run, and belong to the particles that are followed.
    void trails()
    {
        Trails trails;
        trails.follow({12});
        Frame now = frame();
        for (int i = 0; i <= 1000; ++i) {
            now.time = 0.01 * i;
            now.position[1].x() = now.time;
            trails.add(now);
        }
        QVERIFY(trails.points().size() > 100);
        QVERIFY(trails.points().back().time - trails.points().front().time <= Trails::length);
        for (const Trails::Point& point : trails.points())
            QCOMPARE(point.place[0].x(), point.time);
        trails.follow({11, 12}); // what was followed keeps its trail
        QCOMPARE(trails.points().front().place[1].x(), trails.points().front().time);
        QVERIFY(!trails.points().front().place[0].allFinite());
        now.time = 1.0; // looking back
        trails.add(now);
        QCOMPARE(trails.points().size(), std::size_t(1));
    }

    // Trails of particles that are selected, else of those that have probes.
    void whoseTrails()
    {
        const Scene scene = oneOfEverything(); // its probe looks at particle 3
        using Ids = std::vector<std::uint32_t>;
        QCOMPARE(trailed(scene, {}), Ids{3});
        QCOMPARE(trailed(scene, {Id{2}, Id{5}, Id{4}}), (Ids{2, 4}));
        QCOMPARE(trailed(scene, {Id{5}}), Ids{3});
    }

    void typedRange_data()
    {
        QTest::addColumn<QString>("low");
        QTest::addColumn<QString>("high");
        QTest::addColumn<bool>("taken");
        QTest::addColumn<double>("lowest");  // 1
        QTest::addColumn<double>("highest"); // 1
        QTest::newRow("plain") << "-1"
                               << "4" << true << -0.01 << 0.04;
        QTest::newRow("with its unit") << "0 %"
                                       << "2.5 %" << true << 0.0 << 0.025;
        QTest::newRow("turned round") << "4"
                                      << "1" << false << 0.0 << 0.0;
        QTest::newRow("another unit") << "0"
                                      << "5 N" << false << 0.0 << 0.0;
        QTest::newRow("nothing") << ""
                                 << "1" << false << 0.0 << 0.0;
    }

    // Beside colours for strain, in per cent.
    void typedRange()
    {
        QFETCH(QString, low);
        QFETCH(QString, high);
        QFETCH(bool, taken);
        QWidget view;
        Legend legend(&view);
        legend.setScale(ColorBy::Strain, {0.0, 0.1}, ColorMap::sequential());
        RangeEditor editor(legend, &view);
        std::optional<ValueRange> chosen;
        connect(&editor, &RangeEditor::chosen, this,
                [&](const std::optional<ValueRange>& range) { chosen = range; });
        view.show();
        legend.show();
        editor.open();
        QCOMPARE(editor.high().text(), QString("10 %"));
        editor.low().setText(low);
        editor.high().setText(high);
        QTest::keyClick(&editor.high(), Qt::Key_Return);
        QCOMPARE(chosen.has_value(), taken);
        QCOMPARE(editor.complaint().isEmpty(), taken);
        QCOMPARE(editor.isVisible(), !taken);
        if (!taken)
            return;
        QTEST(chosen->low, "lowest");
        QTEST(chosen->high, "highest");
    }

    void peak()
    {
        const Frame now = frame();
        const auto peakBy = [&](ColorBy colorBy) {
            return peakOf(now, valuesOf(now, colorBy, {}));
        };
        QCOMPARE(peakBy(ColorBy::Tension).id, 21U);
        QCOMPARE(peakBy(ColorBy::Tension).value, 30.0);
        QCOMPARE(peakBy(ColorBy::Speed).id, 13U);
        QCOMPARE(peakBy(ColorBy::PanelLoad).id, 31U);
        QCOMPARE(peakBy(ColorBy::PanelLoad).value, 6.0 / 4.5); // of a triangle of 4.5 m^2
        QCOMPARE(peakBy(ColorBy::Material).id, 0U);
    }

    void arrows()
    {
        Frame now = frame();
        const auto velocity = vectorsOf(now, Vectors::Velocity);
        QCOMPARE(velocity.size(), std::size_t(3));
        QCOMPARE(velocity[2].value, Vec3(0, 0, -2));
        const auto load = vectorsOf(now, Vectors::PanelLoad);
        QCOMPARE(load.size(), std::size_t(1));
        QCOMPARE(load[0].place, Vec3(2, 1, 0));
        const auto tension = vectorsOf(now, Vectors::Tension); // pulls inwards at both ends
        QCOMPARE(tension.size(), std::size_t(4));
        QCOMPARE(tension[0].value, Vec3(30, 0, 0));
        QCOMPARE(tension[1].value, Vec3(-30, 0, 0));
        now.torn[0] = 1;
        QCOMPARE(vectorsOf(now, Vectors::Tension).size(), std::size_t(2));
        QVERIFY(vectorsOf(now, Vectors::None).empty());
    }

    // Of many vectors only every n-th is drawn.
    void notTooMany()
    {
        Frame now = frame();
        now.position.assign(100'000, Vec3::Zero());
        now.velocity.assign(100'000, Vec3::UnitX());
        const std::size_t count = vectorsOf(now, Vectors::Velocity).size();
        QVERIFY(count > 1000 && count <= 3000);
    }
};

const RegisteredTest registered("test_see", runWithWidgets<TestSee>);

} // namespace ripstop::test_see
#include "test_see.moc"
