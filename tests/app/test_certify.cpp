// The dialog that certifies runs: empty, with what it found, where nothing can be judged, and its
// place in the menu.
#include "app/sheet_shop.h"
#include "views/run_with_widgets.h"

#include "dialogs/certify_dialog.h"

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

namespace ripstop::test_certify {

class TestCertify : public QObject
{
    Q_OBJECT

private slots:
    void judgesProbes()
    {
        Scene scene = Sheet().scene;
        const Id probe = takeId(scene);
        scene.items.push_back({probe, Probe{"corner", Quantity::PositionY, Sheet::at(8, 4)}});
        scene.items.push_back({takeId(scene), Probe{"stretch", Quantity::MaxStrain}});
        Shop shop(scene);
        CertifyDialog dialog(shop.document, &shop.window);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        auto* table = dialog.findChild<QTableWidget*>("probes");
        QCOMPARE(table->rowCount(), 0);
        QTest::mouseClick(dialog.findChild<QPushButton*>("start"), Qt::LeftButton);
        QCOMPARE(table->rowCount(), 2); // the click returns when it is done
        QCOMPARE(table->item(0, 0)->text(), QString("corner"));
        QVERIFY(table->item(0, 3)->text().toInt() >= 0);
        QVERIFY(table->item(1, 1)->text().endsWith('%')); // a strain, as everywhere
        QVERIFY(table->item(1, 2)->text().endsWith('%'));
        const QString said = dialog.findChild<QLabel*>("state")->text();
        QVERIFY2(said.startsWith("After 2 s"), qPrintable(said));
    }

    void saysWhyItCannot()
    {
        Shop shop(Sheet().scene);
        CertifyDialog dialog(shop.document, &shop.window);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        QTest::mouseClick(dialog.findChild<QPushButton*>("start"), Qt::LeftButton);
        QCOMPARE(dialog.findChild<QTableWidget*>("probes")->rowCount(), 0);
        const QString said = dialog.findChild<QLabel*>("state")->text();
        QVERIFY2(said.contains("no probe"), qPrintable(said));
    }
};

const RegisteredTest registered("test_certify", runWithWidgets<TestCertify>);

} // namespace ripstop::test_certify
#include "test_certify.moc"
