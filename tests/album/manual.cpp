// Stages: Desk is a window of a fixed size with steps of a mouse; each of the functions
// brings one into the state that a picture of the manual shows (links being drawn, a mode that
// swings, a kite that is pulled) and grabs it. takeManualPictures() saves them under the names
// that the manual uses.
#include "album/manual.h"

#include "album/picture.h"
#include "app/window_shop.h"
#include "builders/builder.h"
#include "study/study_panel.h"
#include "study/study_view.h"

#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QTemporaryDir>
#include <QtTest>

namespace ripstop {
namespace {

struct Desk : WindowShop
{
    explicit Desk(Scene scene)
    {
        window.resize(1280, 800);
        window.show();
        QApplication::setActiveWindow(&window); // Xvfb has no window manager to do it
        document.replace(std::move(scene));
        window.showScene();
        (void)QTest::qWaitFor([&] { return player.frame() != nullptr; });
        settle();
    }
    void settle() { QTest::qWait(300); } // docks and view have their sizes, the view its picture

    void click(QPointF place)
    {
        press(place);
        release(place);
    }
    void hover(QPointF place)
    {
        QMouseEvent event(QEvent::MouseMove, place, viewport.mapToGlobal(place), Qt::NoButton,
                          Qt::NoButton, {});
        QApplication::sendEvent(&viewport, &event);
        QTest::qWait(100);
    }
    void zoomOut()
    {
        const QPointF place = share(0.5, 0.5);
        QWheelEvent event(place, viewport.mapToGlobal(place), {}, {0, -120}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&viewport, &event);
        QTest::qWait(30);
    }
    QPointF share(double x, double y) const
    {
        return {x * viewport.width(), y * viewport.height()};
    }
};

QImage drawing()
{
    Desk desk{Scene{}};
    desk.run("drawLinks");
    const QPointF corners[]{desk.share(0.25, 0.42), desk.share(0.45, 0.22), desk.share(0.66, 0.43),
                            desk.share(0.45, 0.56)};
    for (const QPointF& corner : corners) {
        desk.hover(corner);
        desk.click(corner);
    }
    desk.hover(corners[0]);
    desk.click(corners[0]);
    desk.hover(desk.share(0.55, 0.7));
    desk.settle();
    return pictureOf(desk.window);
}

QImage rigidity()
{
    Desk desk(*build(*findBuilder("frame"), {}));
    desk.run("floppy");
    desk.settle();
    return pictureOf(desk.window);
}

QImage byHand()
{
    Desk desk(*build(*findBuilder("delta_kite"), {}));
    desk.player.playUntil(6.0);
    (void)QTest::qWaitFor([&] { return !desk.player.isPlaying() && desk.frame().time > 5.9; },
                          20000);
    desk.viewport.fit({Id{1}}); // the kite, without its line
    desk.run("toolGrab");
    desk.settle();
    desk.player.play();
    QTest::qWait(200);
    const auto& ids = desk.frame().layout->particleId;
    const QPointF from = desk.at(desk.now(Id(ids[ids.size() / 3])));
    const QPointF to = from + QPointF(20.0, 120.0);
    desk.press(from);
    desk.move(from, to);
    (void)QTest::qWaitFor([&] { return desk.frame().held.has_value(); });
    QTest::qWait(600);
    const QImage picture = pictureOf(desk.window);
    desk.release(to);
    return picture;
}

// A shipped study, flown.
struct StudyDesk : Desk
{
    QTemporaryDir folder;
    StudyPanel& panel = window.docks().panel<StudyPanel>();

    explicit StudyDesk(const QString& name)
        : Desk(Scene{})
    {
        const QString study = name + QStringLiteral(".ripstop-study.json");
        for (const QString& file : {QStringLiteral("kite_in_gusts.ripstop.json"), study})
            QFile::copy(QStringLiteral(SCENES_DIR "/") + file, folder.filePath(file));
        window.openStudy(folder.filePath(study));
        (void)QTest::qWaitFor([&] { return rests() && panel.runner().study(); }, 20'000);
        panel.run();
        (void)QTest::qWaitFor(
            [&] {
                return rests() && panel.runner().tally().flown == panel.runner().flights().size();
            },
            300'000);
        auto* dock = window.findChild<QDockWidget*>("study");
        window.resizeDocks({dock}, {420}, Qt::Vertical);
    }

    bool rests() const { return panel.runner().task() == StudyRunner::Task::None; }
    void choose(const QString& words) // in whichever box has it
    {
        for (QComboBox* box : panel.findChildren<QComboBox*>())
            if (const int place = box->findText(words); place >= 0) {
                box->setCurrentIndex(place);
                emit box->activated(place);
            }
    }
    QImage picture()
    {
        settle();
        return pictureOf(window);
    }
};

void takeStudies(const QDir& target)
{
    {
        StudyDesk desk("line_in_gusts");
        desk.panel.view().choose(17);
        desk.picture().save(target.filePath("study-map.png"));
        desk.window.resize(1600, 1000);
        for (int i = 0; i < 5; ++i) // room for ghosts
            desk.zoomOut();
        desk.panel.view().select({6, 13, 20, 34});
        emit desk.panel.view().compareWanted(desk.panel.view().selected());
        (void)QTest::qWaitFor(
            [&] { return desk.rests() && desk.panel.view().curves().isVisible(); }, 60'000);
        desk.choose("ghosts side by side");
        desk.choose("line tension (N)");
        desk.picture().save(target.filePath("study-compare.png"));
    }
    StudyDesk desk("gust_seeds");
    desk.choose("Percentiles");
    desk.choose("strength");
    desk.picture().save(target.filePath("study-percentiles.png"));
    desk.choose("Parallel axes");
    std::vector<std::size_t> held;
    for (std::size_t i = 0; i < desk.panel.runner().flights().size(); ++i)
        if (outcomeOf(desk.panel.runner().flights()[i]) == FlightOutcome::Held)
            held.push_back(i);
    desk.panel.view().select(held);
    desk.picture().save(target.filePath("study-parallel.png"));
    desk.choose("Scatter matrix");
    desk.picture().save(target.filePath("study-scatter.png"));
}

} // namespace

void takeManualPictures(const QString& folder)
{
    const QDir target(folder);
    drawing().save(target.filePath("drawing.png"));
    rigidity().save(target.filePath("rigidity.png"));
    byHand().save(target.filePath("by-hand.png"));
    takeStudies(target);
}

} // namespace ripstop
