// Slits in fabric that tears by energy: the load at which one begins to run is that of fracture
// mechanics and hangs on no mesh, and from then on nothing stops it.
#include "model/systems.h"
#include "registered_test.h"
#include "verify/slit_sheet.h"

#include <QtTest>

namespace ripstop::test_tear_energy {

class TestTearEnergy : public QObject
{
    Q_OBJECT

private slots:
    // Cloth that wrinkles beside the slit lets go of more than Griffith says (verify/slit_sheet.h),
    // and a row that is cut out is a longer slit.
    void beginsAlikeOnEachMesh_data()
    {
        QTest::addColumn<TearMesh>("tearMesh");
        QTest::addColumn<bool>("isBlunt");
        QTest::addColumn<bool>("pushes");
        for (const TearMesh mesh : {TearMesh::Vanish, TearMesh::Split})
            for (const bool isBlunt : {false, true})
                for (const bool pushes : {true, false})
                    QTest::addRow("%s, %s, %s", mesh == TearMesh::Split ? "split" : "vanish",
                                  isBlunt ? "cut out" : "two lips", pushes ? "pushes" : "wrinkles")
                        << mesh << isBlunt << pushes;
    }

    void beginsAlikeOnEachMesh()
    {
        QFETCH(TearMesh, tearMesh);
        QFETCH(bool, isBlunt);
        QFETCH(bool, pushes);
        constexpr double side = SlitSheet::side;
        const double expected = SlitSheet::expected();
        const bool mayBlunt = tearMesh == TearMesh::Vanish && !isBlunt; // by the panel that goes
        double least = 1e9, most = 0.0, leastRun = 1e9, mostRun = 0.0;  // N/m
        for (const int cells : {30, 42, 54}) {
            const SlitTorn torn = drawnApart({cells, tearMesh, isBlunt, pushes});
            QVERIFY(torn.first.time > 0.0);
            QVERIFY2(std::abs(std::abs(torn.first.place.x() - 0.5 * side) - SlitSheet::halfSlit)
                         < 1.5 * side / cells,
                     told(torn.first.place.x(), 0.5 * side - SlitSheet::halfSlit));
            QVERIFY2(torn.most < (mayBlunt ? 1.15 : 1.02) * torn.began,
                     told(torn.most, torn.began));
            QVERIFY2(torn.left < 0.5 * torn.began, told(torn.left, 0.0));
            least = std::min(least, torn.began);
            most = std::max(most, torn.began);
            leastRun = std::min(leastRun, torn.most);
            mostRun = std::max(mostRun, torn.most);
        }
        QVERIFY2(most < 1.1 * least, told(most, least));
        QVERIFY2(mostRun < 1.1 * leastRun, told(mostRun, leastRun));
        if (pushes)
            QVERIFY2(isNear(least, expected, 0.1 * expected)
                         && isNear(most, expected, 0.1 * expected),
                     told(least, expected));
        else
            QVERIFY2(most < expected && least > 0.8 * expected, told(least, expected));
    }
};

const RegisteredTest registered("test_tear_energy", runPlain<TestTearEnergy>);

} // namespace ripstop::test_tear_energy
#include "test_tear_energy.moc"
