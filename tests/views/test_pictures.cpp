// Pictures of the view that are taken away: what is of the window only is not in them, and taking
// one changes nothing in the view.
//
// Stages: the selection, the trails that follow it, then pins.
#include "views/front_view.h"
#include "views/run_with_widgets.h"

#include "camera/camera_projection.h"
#include "simulation/frame.h"

#include <QtTest>

#include <array>
#include <cmath>
#include <memory>

namespace ripstop::test_pictures {

using View = FrontView;

class TestPictures : public QObject
{
    Q_OBJECT

private slots:
    // What is selected is marked in the window, and not in pictures that are taken away.
    void picturesHaveNoMarksOfTheSelection()
    {
        View view(redPanel());
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        const auto middle = [&] {
            return view.viewport.image(Viewport::Shot{{400, 300}, Viewport::Overlays::Without})
                .pixelColor(200, 160);
        };
        const QColor bare = middle();
        view.selection.set({Id{5}});
        QCOMPARE(middle(), bare);
        QVERIFY(view.middle() != bare);
    }

    // Trails are of what is selected, and no mark of it: a picture has them, and afterwards they
    // are as long as before.
    void picturesLeaveTrailsAsTheyAre()
    {
        View view(redPanel());
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        const auto shot = [&] {
            return view.viewport.image(Viewport::Shot{{400, 300}, Viewport::Overlays::Without});
        };
        view.selection.set({Id{2}});
        view.viewport.setTrailsShown(true);
        auto moved = std::make_shared<Frame>(*view.player.frame());
        for (int i = 0; i < 10; ++i) { // as if it slid away
            moved = std::make_shared<Frame>(*moved);
            moved->time += 0.1;
            moved->position[0].x() -= 0.03;
            view.viewport.show(moved);
            (void)view.viewport.image(Viewport::Overlays::Without);
        }
        const QImage trailed = shot();
        QCOMPARE(shot(), trailed);
        view.viewport.setTrailsShown(false);
        QVERIFY(shot() != trailed);
    }

    // Without the marks of pins a picture is another one at the three pinned corners, and the view
    // has them again afterwards.
    void picturesMayGoWithoutPins()
    {
        View view(redPanel());
        QVERIFY(QTest::qWaitForWindowExposed(&view.viewport));
        QTRY_VERIFY(view.player.frame());
        const auto shot = [&](Viewport::Pins pins) {
            return view.viewport.image(
                Viewport::Shot{{400, 300}, Viewport::Overlays::Without, Backdrop::White, pins});
        };
        const QImage with = shot(Viewport::Pins::With), without = shot(Viewport::Pins::Without);
        const CameraProjection project(view.viewport.camera(), 400.0, 300.0);
        std::array<int, 3> changed{}; // pixels, beside each corner
        for (int y = 0; y < 300; ++y)
            for (int x = 0; x < 400; ++x) {
                if (with.pixel(x, y) == without.pixel(x, y))
                    continue;
                int corner = 0;
                for (const auto& particle : view.player.frame()->position) {
                    const QPointF away = *project.pixel(particle) - QPointF(x, y);
                    if (std::hypot(away.x(), away.y()) < 12.0)
                        ++changed[std::size_t(corner)];
                    ++corner;
                }
            }
        for (const int pixels : changed)
            QVERIFY2(pixels > 20, qPrintable(QString::number(pixels)));
        QCOMPARE(shot(Viewport::Pins::With), with);
    }
};

const RegisteredTest registered("test_pictures", runWithView<TestPictures>);

} // namespace ripstop::test_pictures
#include "test_pictures.moc"
