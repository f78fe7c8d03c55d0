// Settling and adopting a pose, by their dialogs.
//
// Stages: a sheet settles and its pose is adopted; settling is stopped; a pose with rest lengths
// bound anew; and a design that has no pose to adopt.
#include "app/sheet_shop.h"

#include "dialogs/pose_dialog.h"
#include "dialogs/settle_dialog.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>

namespace ripstop::test_settle {

class TestSettle : public QObject
{
    Q_OBJECT

private slots:
    // A sheet that starts aslant settles below its pins; then its pose is adopted, with its lengths
    // kept: the new design hangs as still. Undo has the old design again.
    void settlesAndAdopts()
    {
        Scene scene = Sheet().scene;
        Part& sheet = std::get<Part>(scene.items.front().item);
        for (Link& link : sheet.links) {
            link.kind = LinkKind::Spring;
            link.resists = Resists::Both;
        }
        auto& cloth = std::get<Material>(scene.items.back().item);
        cloth.stiffness = 2000.0; // N/m
        cloth.damping = 0.5;      // N s/m
        for (Particle& particle : sheet.particles) {
            const double below = 3.0 - particle.position.y();
            particle.position = {particle.position.x(), 3.0 - 0.6 * below, 0.8 * below};
        }
        Shop shop(scene);
        const Scene before = shop.document.scene();
        SettleDialog settle(
            shop.player, [] {}, &shop.window);
        settle.setAttribute(Qt::WA_DeleteOnClose, false);
        settle.show();
        QTRY_VERIFY(shop.player.frame());
        QTest::mouseClick(settle.findChild<QPushButton*>("start"), Qt::LeftButton);
        QVERIFY(shop.player.isSettling());
        QTRY_VERIFY_WITH_TIMEOUT(!shop.player.isSettling(), 30000);
        const QString said = settle.findChild<QLabel*>("state")->text();
        QVERIFY2(said.startsWith("Still after"), qPrintable(said));
        const double lowest = shop.now(Sheet::at(8, 4)).y();
        QVERIFY2(std::abs(lowest - 1.0) < 0.05, qPrintable(QString::number(lowest)));
        QVERIFY(std::abs(shop.now(Sheet::at(8, 4)).z()) < 0.02);

        const Vec3 hung = shop.now(Sheet::at(8, 4));
        {
            PoseDialog pose(shop.document, shop.player, &shop.window);
            pose.accept();
            QTRY_COMPARE(pose.result(), int(QDialog::Accepted));
        }
        QCOMPARE(shop.document.history().count(), 1);
        const auto* row = std::get<const Particle*>(*find(shop.document.scene(), Sheet::at(8, 4)));
        QCOMPARE(row->position, hung);
        QCOMPARE(row->velocity, Vec3(Vec3::Zero()));
        QTRY_VERIFY(shop.frame().step == 0 && shop.now(Sheet::at(8, 4)) == hung);
        shop.player.playUntil(1.0);
        QTRY_VERIFY(!shop.player.isPlaying());
        QVERIFY((shop.now(Sheet::at(8, 4)) - hung).norm() < 0.02);
        shop.document.history().undo();
        QVERIFY(shop.document.scene() == before);
    }

    void settlingStops()
    {
        Shop shop(Sheet().scene);
        QTRY_VERIFY(shop.player.frame());
        SettleDialog settle(
            shop.player, [] {}, &shop.window);
        settle.setAttribute(Qt::WA_DeleteOnClose, false);
        settle.show();
        settle.start();
        QVERIFY(shop.player.isSettling());
        settle.stop();
        QVERIFY(!shop.player.isSettling() && !shop.player.isPlaying());
        QVERIFY(settle.findChild<QLabel*>("state")->text().startsWith("Stopped"));
        settle.start();
        settle.close(); // stops as well
        QVERIFY(!shop.player.isSettling());
    }

    // Rebound, no link has a strain in the new design.
    void adoptsRebound()
    {
        Shop shop(Sheet().scene);
        QTRY_VERIFY(shop.player.frame());
        shop.player.playUntil(0.4);
        QTRY_VERIFY(!shop.player.isPlaying());
        QTRY_VERIFY(shop.frame().step > 0);
        PoseDialog pose(shop.document, shop.player, &shop.window);
        pose.findChild<QComboBox*>("lengths")->setCurrentIndex(1);
        pose.findChild<QComboBox*>("motion")->setCurrentIndex(1);
        pose.accept();
        QTRY_COMPARE(pose.result(), int(QDialog::Accepted));
        const Part& part = *findItem<Part>(shop.document.scene(), Id{1});
        double fastest = 0.0;
        for (const Particle& particle : part.particles)
            fastest = std::max(fastest, particle.velocity.norm());
        QVERIFY(fastest > 0.0);
        for (const Link& link : part.links)
            QCOMPARE(link.restLength,
                     (Sheet::position(part, link.to) - Sheet::position(part, link.from)).norm());
    }

    // A design that has not run has no pose to adopt: that is said, and nothing opens.
    void nothingToAdopt()
    {
        Shop shop(Sheet().scene);
        QTRY_VERIFY(shop.player.frame());
        shop.run("adoptPose");
        QVERIFY(!QApplication::activeModalWidget());
        QCOMPARE(shop.document.history().count(), 0);
    }
};

const RegisteredTest registered("test_settle", runWithView<TestSettle>);

} // namespace ripstop::test_settle
#include "test_settle.moc"
