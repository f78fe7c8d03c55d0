// Guides, smoothing and targets as a user meets them: the dialog, the view, the inspector.
//
// Stages: the dialog for guides with its preview, taken back and accepted; the guide in the view
// by its pixels; targets; and the preview of smoothing.
#include "app/window_shop.h"

#include "builders/builder.h"
#include "dialogs/operation_dialog.h"
#include "inspector/target_rows.h"
#include "views/small_scenes.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QtTest>

namespace ripstop::test_guiding {

namespace {

const Particle& particle(const Document& document, Id id)
{
    return *std::get<const Particle*>(*find(document.scene(), id));
}

struct Shop : WindowShop
{
    explicit Shop(Scene scene = oneOfEverything())
    {
        document.replace(std::move(scene));
        window.resize(1000, 700);
        window.show();
        window.showScene();
    }
};

QLabel* labelNamed(QWidget& in, const char* name)
{
    auto* rows = in.findChild<TargetRows*>();
    return rows ? rows->findChild<QLabel*>(name) : nullptr;
}

} // namespace

class TestGuiding : public QObject
{
    Q_OBJECT

private slots:
    void theDialogGuidesAndTakesBack()
    {
        Shop shop;
        shop.selection.set({Id{3}, Id{4}}); // (1, 1, 0) and (0, 0, 0)
        QVERIFY(shop.window.actions()["guide"]->isEnabled());
        OperationDialog dialog(*findOperation("guide"), shop.document, shop.selection,
                               &shop.window);
        QVERIFY(particle(shop.document, Id{3}).guide == Guide::Line); // the preview
        const auto choices = dialog.findChildren<QComboBox*>();
        QCOMPARE(choices.size(), 2);
        choices[1]->setCurrentIndex(3); // through what is selected
        QTRY_VERIFY(particle(shop.document, Id{3}).guideAxis.cross(Vec3(1, 1, 0)).norm() < 1e-12);
        choices[0]->setCurrentIndex(1); // in a plane: two particles are not enough
        QTRY_VERIFY(dialog.findChild<QLabel*>("outcome")->text().contains("three particles"));
        dialog.reject();
        QVERIFY(particle(shop.document, Id{3}).guide == Guide::None);
        QCOMPARE(shop.document.history().count(), 0);
    }

    void acceptedItIsOneStep()
    {
        Shop shop;
        shop.selection.set({Id{2}}); // which is pinned
        OperationDialog dialog(*findOperation("guide"), shop.document, shop.selection,
                               &shop.window);
        dialog.accept();
        QVERIFY(!particle(shop.document, Id{2}).pinned);
        QVERIFY(particle(shop.document, Id{2}).guide == Guide::Line);
        QCOMPARE(shop.document.history().count(), 1);
        shop.document.history().undo();
        QVERIFY(particle(shop.document, Id{2}).pinned);
    }

    // A ring on a rail shows more red than the same particle without.
    void theViewShowsTheGuide()
    {
        Shop shop;
        const auto redPixels = [&] {
            QApplication::processEvents();
            const QImage picture = shop.viewport.image(Viewport::Overlays::Without);
            int red = 0;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x) {
                    const QColor color = picture.pixelColor(x, y);
                    red += color.red() > color.green() + 60 && color.red() > color.blue() + 60;
                }
            return red;
        };
        QTRY_VERIFY(shop.player.frame());
        const int before = redPixels();
        shop.document.push(setValue(shop.document.scene(), Id{4}, "guide", std::string("line")));
        QTRY_VERIFY(!shop.player.frame()->layout->guided.empty());
        QTRY_VERIFY(redPixels() > before + 10);
    }

    void targetsAreShownAndMet()
    {
        Shop shop;
        shop.selection.set({Id{1}}); // 3 x 0.01 kg
        QVERIFY(!labelNamed(shop.window, "massTarget"));
        shop.document.push(setValue(shop.document.scene(), Id{1}, "massTarget", 0.04));
        QLabel* label = labelNamed(shop.window, "massTarget");
        QVERIFY(label && label->text().contains("30\u00a0g"));
        QVERIFY2(label->text().contains("missing"), qPrintable(label->text()));
        auto* spread = shop.window.findChild<QToolButton*>("spreadDifference");
        QVERIFY(spread);
        spread->click();
        QApplication::processEvents();
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        label = labelNamed(shop.window, "massTarget");
        QVERIFY(label && label->text().contains("on target"));
        QVERIFY(std::abs(particle(shop.document, Id{3}).mass - 0.04 / 3.0) < 1e-12);
        QCOMPARE(shop.document.history().count(), 2);
        shop.selection.set({Id{3}});
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(!labelNamed(shop.window, "massTarget"));
    }

    void smoothingIsPreviewed()
    {
        Shop shop(*build(*findBuilder("cloth"), {{"columns", 6}, {"rows", 6}, {"sphere", 0}}));
        Id sheet{}, middle{};
        forEachPart(shop.document.scene(), [&](Id id, const Part& part) {
            sheet = id;
            middle = part.particles[24].id;
        });
        const Vec3 flat = particle(shop.document, middle).position;
        shop.document.push(
            setValue(shop.document.scene(), middle, "position", Vec3(flat + Vec3(0, 0.2, 0))));
        shop.selection.set({sheet});
        {
            OperationDialog dialog(*findOperation("smooth"), shop.document, shop.selection,
                                   &shop.window);
            QVERIFY(particle(shop.document, middle).position.y() < flat.y() + 0.15);
            dialog.reject();
        }
        QVERIFY(particle(shop.document, middle).position == Vec3(flat + Vec3(0, 0.2, 0)));
    }
};

const RegisteredTest registered("test_guiding", runWithView<TestGuiding>);

} // namespace ripstop::test_guiding
#include "test_guiding.moc"
