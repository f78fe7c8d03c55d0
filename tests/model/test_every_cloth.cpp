// Every cloth of the library on the crafts of real materials: nothing explodes in 5 s, and the
// accuracy that is wanted is held. test_sample_cloths.cpp has the samples;
// `ripstop-cli sweep scenes/*.ripstop.json --cloth all --seconds 5` flies all of them, for hours.
#include "builders/builder.h"
#include "model/cloth_flights.h"
#include "registered_test.h"

#include <QtTest>

namespace ripstop::test_every_cloth {

class TestEveryCloth : public QObject
{
    Q_OBJECT

private slots:
    // Panels, and threads with a width; no line, no spar, no hem.
    void panelsAndThreadsAreCloth()
    {
        const Scene kite = sample("ripstop_kite");
        QStringList names;
        for (const Id id : clothMaterials(kite))
            names << QString::fromStdString(nameOf(*findItem(kite, id)));
        QCOMPARE(names, (QStringList{"sail", "border", "keel cloth"}));
        QVERIFY(!hasCloth("rope"));
        QVERIFY(!hasCloth("bridle"));
        for (const Preset* cloth : clothPresets())
            QVERIFY(densityOf(*cloth) > 0.0);
    }

    void craftsFlyWithEveryCloth_data()
    {
        QTest::addColumn<QByteArray>("builder");
        QTest::addColumn<QByteArray>("cloth");
        for (const char* builder : {"delta_kite", "hang_glider", "parachute"})
            for (const Preset* cloth : clothPresets())
                QTest::addRow("%s of %s", builder, cloth->name.c_str())
                    << QByteArray(builder) << QByteArray::fromStdString(cloth->name);
    }

    void craftsFlyWithEveryCloth()
    {
        QFETCH(QByteArray, builder);
        QFETCH(QByteArray, cloth);
        const Builder& design = *findBuilder(builder.toStdString());
        const Result<Scene> craft = build(design, newDesign(design, {}));
        QVERIFY(bool(craft));
        const Flown run = flown(madeOf(*craft, cloth.toStdString()), 5.0);
        QVERIFY2(run.trouble.empty(), run.trouble.c_str());
        QVERIFY2(run.accuracy.isMet(), run.accuracy.complaint().english().c_str());
    }
};

const RegisteredTest registered("test_every_cloth", runWithCore<TestEveryCloth>);

} // namespace ripstop::test_every_cloth
#include "test_every_cloth.moc"
