// The samples with the lightest and the heaviest cloth of the library: nothing explodes in 0.5 s,
// or in 0.2 s of those whose folds touch each other, and the accuracy that is wanted is held, or
// the run says that it is not. test_every_cloth.cpp has all cloths.
#include "model/cloth_flights.h"
#include "registered_test.h"

#include <QtTest>

#include <string>

namespace ripstop::test_sample_cloths {

class TestSampleCloths : public QObject
{
    Q_OBJECT

private slots:
    void samplesFlyWithLightAndHeavyCloth_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("cloth");
        const auto [light, heavy] =
            std::ranges::minmax(clothPresets(), {}, [](const Preset* p) { return densityOf(*p); });
        for (const QString& name : sampleNames())
            if (hasCloth(name))
                for (const Preset* cloth : {light, heavy})
                    QTest::addRow("%s of %s", qPrintable(name), cloth->name.c_str())
                        << name << QByteArray::fromStdString(cloth->name);
    }

    // The settings of the papers hold no accuracy, and touch is hard to foresee; a run of either
    // may miss what is wanted, and says so.
    void samplesFlyWithLightAndHeavyCloth()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, cloth);
        const Scene scene = madeOf(sample(name), cloth.toStdString());
        // folds that touch each other take minutes with stiff, light cloth
        const double seconds = partOf(scene).selfContact > 0.0 ? 0.2 : 0.5;
        const Flown run = flown(scene, seconds);
        QVERIFY2(run.trouble.empty(), run.trouble.c_str());
        const std::string said = run.accuracy.complaint().english();
        if (run.accuracy.isMet())
            return;
        QVERIFY(said.find("missed the wanted accuracy") != std::string::npos);
        const bool isAutomatic = scene.settings.solver == Solver::Auto;
        QVERIFY2(run.touched || !isAutomatic, said.c_str());
    }
};

const RegisteredTest registered("test_sample_cloths", runWithCore<TestSampleCloths>);

} // namespace ripstop::test_sample_cloths
#include "test_sample_cloths.moc"
