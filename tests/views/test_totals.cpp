// The words at the head of the inspector (inspector/totals.h).
#include "builders/builder.h"
#include "inspector/totals.h"
#include "views/run_with_widgets.h"

#include <QtTest>

namespace ripstop::test_totals {

class TestTotals : public QObject
{
    Q_OBJECT

private slots:
    // What was chosen, in the words of the form it was chosen in, and not what is as in any kite.
    void saysWhatAPartWasBuiltOf()
    {
        const auto said = [](const Parameters& given) {
            const Builder& kite = *findBuilder("delta_kite");
            const Scene scene = *build(kite, newDesign(kite, given));
            Id part = noId;
            forEachPart(scene, [&](Id id, const Part&) { part = id; });
            return totals(scene, Kind::Part, {part})
                .split('\n')
                .last()
                .replace(QChar(0x00a0), QChar(' '));
        };
        QCOMPARE(said({}), QString("Built by delta kite as it comes. Change it with Insert > "
                                   "Change parameters."));
        QCOMPARE(said({{"span", 2.0}, {"segments", 12}}),
                 QString("Built by delta kite: segments 12, span 2 m. Change it with Insert > "
                         "Change parameters."));
    }

    // However it is folded: of a canopy of 5 m, pi D0^2 / 4 = 19.63 m^2, by a polygon.
    void saysHowMuchClothIsInFolds()
    {
        const Builder& parachute = *findBuilder("parachute");
        const Scene scene = *build(parachute, newDesign(parachute, {{"mouth", 0.05}}));
        std::vector<Id> part, panels;
        forEachPart(scene, [&](Id id, const Part& row) {
            part = {id};
            for (const Panel& panel : row.panels)
                panels.push_back(panel.id);
        });
        QCOMPARE(panels.size(), std::size_t(264));
        for (const QString& said :
             {totals(scene, Kind::Part, part), totals(scene, Kind::Panel, panels)})
            QVERIFY2(said.contains(QString("19.63\u00a0m\u00b2")), qPrintable(said));
    }
};

const RegisteredTest registered("test_totals", runWithWidgets<TestTotals>);

} // namespace ripstop::test_totals
#include "test_totals.moc"
