// The legend and the colours of what nothing in a scene has.
//
// Stages: each quantity in a frame that has nothing of it, with what the legend says then; and the
// colour of what is drawn.
#include "layers/picture.h"
#include "look/collider_geometry.h"
#include "look/figure.h"
#include "look/people.h"
#include "look/quantity_values.h"
#include "overlays/legend.h"
#include "views/run_with_widgets.h"

#include <QtTest>

#include <limits>

namespace ripstop::test_nothing_to_measure {

class TestNothingToMeasure : public QObject
{
    Q_OBJECT

private slots:
    void nothingToMeasure_data()
    {
        QTest::addColumn<int>("colorBy");
        for (std::size_t i = std::size_t(ColorBy::Material) + 1; i < colorByCount; ++i)
            QTest::newRow(colorByNames[i].data()) << int(i);
    }

    // A frame without links and panels, and without strengths and what is painted, has none of the
    // quantities but speed, and an empty one not even that. The legend then has no scale and no
    // range to be typed; it says what is missing, and its tip what to do.
    void nothingToMeasure()
    {
        QFETCH(int, colorBy);
        const auto quantity = ColorBy(colorBy);
        Frame bare;
        auto layout = std::make_shared<Layout>();
        layout->particleId = {11};
        bare.layout = layout;
        bare.position = {Vec3::Zero()};
        bare.velocity = {Vec3::Zero()};
        QCOMPARE(valuesOf(bare, quantity, Look()).isKnown, quantity == ColorBy::Speed);
        bare.layout = std::make_shared<Layout>();
        bare.position = {};
        bare.velocity = {};
        QVERIFY(!valuesOf(bare, quantity, Look()).isKnown);

        Legend legend;
        legend.setScale(quantity, {0.0, 1.0}, ColorMap::sequential());
        legend.setPeak(Peak{31, 1.0}, {0.0, 1.0});
        QVERIFY(!legend.labels().isEmpty());
        const QSize full = legend.size();
        const QString hint = legend.toolTip();
        legend.setPeak(std::nullopt);
        QVERIFY(legend.labels().isEmpty() && !legend.hasRange());
        QVERIFY(!legend.peakText().isEmpty());
        QVERIFY(legend.toolTip().endsWith('.') && legend.toolTip() != hint);
        QVERIFY(legend.height() < full.height() / 2);
        const int text = QFontMetrics(legend.font()).horizontalAdvance(legend.peakText());
        QVERIFY(text < legend.width());
        legend.setPeak(Peak{31, 1.0}, {0.0, 1.0});
        QCOMPARE(legend.size(), full);
        QCOMPARE(legend.toolTip(), hint);
    }

    // Nothing is painted as if it had been measured.
    void nothingToMeasureIsGrey()
    {
        auto layout = std::make_shared<Layout>();
        layout->particleId = {11, 12};
        layout->links = {{21, LinkKind::Spring, 0, 1, 2.0}};
        Frame now;
        now.layout = layout;
        now.position = {{0, 0, 0}, {3, 0, 0}};
        now.strain = {0.5};
        now.torn = {0};
        const Scene scene;
        const Look look;
        const Theme theme = Theme::light();
        const std::vector<Id> ids;
        const std::vector<ColliderBody> bodies;
        const std::vector<Person> people;
        const std::vector<std::vector<Limb>> limbs;
        const ColorMap& colors = ColorMap::sequential();
        const Color grey = colors.at(std::numeric_limits<double>::quiet_NaN());
        for (const ColorBy colorBy : {ColorBy::Margin, ColorBy::Strain}) {
            const QuantityValues values = valuesOf(now, colorBy, look);
            QCOMPARE(values.isKnown, colorBy == ColorBy::Strain);
            const Picture picture{scene,  now,   look,    theme,  nullptr, ids,        bodies,
                                  people, limbs, colorBy, values, colors,  {0.0, 1.0}, {}};
            for (const double value : values.particle)
                QCOMPARE(picture.colorOf(value) == grey, colorBy == ColorBy::Margin);
        }
    }
};

const RegisteredTest registered("test_nothing_to_measure", runWithWidgets<TestNothingToMeasure>);

} // namespace ripstop::test_nothing_to_measure
#include "test_nothing_to_measure.moc"
