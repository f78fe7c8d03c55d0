// The dialogs of builders while a run is shown: they leave it as it is.
//
// Stages: inserting, then changing the parameters of a part; each dismissed first and accepted
// then.
#include "app/insert_shop.h"
#include "builders/builder.h"
#include "dialogs/builder_dialog.h"
#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "viewport/viewport.h"
#include "views/run_with_widgets.h"

#include <QCheckBox>
#include <QtTest>

namespace ripstop::test_insert_in_run {

namespace {

// A design that has flown for 0.2 s, and what was shown then.
struct Shop : InsertShop
{
    std::uint64_t runShown = 0;
    double moment = 0.0; // s
    std::vector<Vec3> places;
    Scene design;

    explicit Shop(const char* builder)
        : InsertShop(*build(*findBuilder(builder), {}))
    {
        player.playUntil(0.2);
        if (!QTest::qWaitFor([&] { return !player.isPlaying() && frame().time > 0.19; }))
            qFatal("it did not fly");
        runShown = player.run();
        moment = frame().time;
        places = frame().position;
        design = document.scene();
    }

    // After a pause in which a compile that is due would be done.
    void verifyNothingChanged()
    {
        QTest::qWait(50);
        QCOMPARE(player.run(), runShown);
        QCOMPARE(frame().time, moment);
        QVERIFY(frame().position == places);
        QVERIFY(document.scene() == design);
    }
};

} // namespace

class TestInsertInRun : public QObject
{
    Q_OBJECT

private slots:
    // The dialog that opens during a run, and is dismissed, leaves the run, its moment and the
    // camera as they were; what is inserted comes into the run, whose time goes on.
    void aRunGoesOnBehindTheDialog()
    {
        Shop shop("rope");
        Camera camera = shop.viewport.camera();
        camera.distance *= 1.5;
        shop.viewport.look(camera);
        shop.during<BuilderDialog>("insert frame", [&](BuilderDialog& dialog) {
            QTRY_VERIFY(okOf(dialog)->isEnabled());
            auto* show = dialog.findChild<QCheckBox*>("show");
            QVERIFY(!show->isEnabled() && !show->isChecked());
            QVERIFY(show->toolTip().contains("goes on"));
            QVERIFY(shop.document.scene() == shop.design);
        });
        shop.verifyNothingChanged();
        QCOMPARE(shop.viewport.camera().distance, camera.distance);
        QCOMPARE(shop.viewport.camera().focus, camera.focus);

        const std::size_t rope = shop.count();
        shop.during<BuilderDialog>("insert frame", [&](BuilderDialog& dialog) {
            QTRY_VERIFY(okOf(dialog)->isEnabled());
            okOf(dialog)->click();
        });
        QCOMPARE(shop.count(), rope + 12);
        const Vec3 focus = shop.viewport.camera().focus; // on what has come
        QTRY_COMPARE(shop.frame().position.size(), rope + 12);
        QCOMPARE(shop.viewport.camera().focus, focus); // though the middle of all has jumped
        QCOMPARE(shop.player.run(), shop.runShown);
        QCOMPARE(shop.frame().time, shop.moment);
    }

    // As the dialog Insert does: looking at the parameters changes nothing. The part is built again
    // in the design, as another mesh shares only some particles with the run.
    void aRunGoesOnBehindTheParameters()
    {
        Shop shop("frame");
        shop.selection.set({shop.part(0)});
        shop.during<BuilderDialog>("parameters", [&](BuilderDialog& dialog) {
            auto* show = dialog.findChild<QCheckBox*>("show");
            QVERIFY(!show->isEnabled() && !show->isChecked());
            typeInto(numberOf(dialog, "columns"), "7");
            QTRY_VERIFY(okOf(dialog)->isEnabled());
            QVERIFY(shop.document.scene() == shop.design);
        });
        shop.verifyNothingChanged();

        shop.during<BuilderDialog>("parameters", [&](BuilderDialog& dialog) {
            typeInto(numberOf(dialog, "columns"), "7");
            QTRY_VERIFY(okOf(dialog)->isEnabled());
            okOf(dialog)->click();
        });
        QCOMPARE(shop.count(), std::size_t(24));
        QTRY_COMPARE(shop.frame().position.size(), std::size_t(24));
        QCOMPARE(shop.frame().time, 0.0);
        QVERIFY(shop.player.run() != shop.runShown);
    }
};

const RegisteredTest registered("test_insert_in_run", runWithWidgets<TestInsertInRun>);

} // namespace ripstop::test_insert_in_run
#include "test_insert_in_run.moc"
