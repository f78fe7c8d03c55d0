// Colours by tear limit, the peak, and arrows on elements.
#include "viewport/quantity_values.h"
#include "viewport/vector_layer.h"
#include "viewport/vectors.h"

#include <QtTest>

using namespace ripstop;

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

    // Of many there is every n-th.
    void notTooMany()
    {
        Frame now = frame();
        now.position.assign(100'000, Vec3::Zero());
        now.velocity.assign(100'000, Vec3::UnitX());
        const std::size_t count = vectorsOf(now, Vectors::Velocity).size();
        QVERIFY(count > 1000 && count <= 3000);
    }
};

QTEST_MAIN(TestSee)
#include "test_see.moc"
