// The timeline in the window: what ran is looked back at, marked, gone on from, saved and opened.
//
// Stages: looking back by keys, mouse and actions; playing on live; going on from an exact state;
// events, bookmarks and loops; files; and no memory for recordings.
#include "document/recordings.h"
#include "files/run_files.h"
#include "io/recording_file.h"
#include "loads/load_panel.h"
#include "overlays/compass.h"
#include "timeline/timeline.h"
#include "timeline/timeline_strip.h"
#include "tools/tool_strip.h"
#include "transport/transport.h"
#include "window_shop.h"

#include <QLabel>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

namespace ripstop::test_timeline {

namespace {

struct TimelineShop : WindowShop
{
    Recordings& runs = window.recordings();
    Timeline& timeline = window.docks().panel<Timeline>();

    bool open(const char* scene)
    {
        const bool opened = !document.open(QStringLiteral(SCENES_DIR "/") + scene);
        window.showScene();
        window.resize(1280, 800);
        window.show();
        window.docks().show("timeline");
        return opened;
    }
    void fly(double time)
    {
        player.playUntil(time);
        QTRY_VERIFY_WITH_TIMEOUT(!player.isPlaying() && runs.current()
                                     && std::abs(player.frame()->time - time) < 1e-6,
                                 20000);
        QTRY_COMPARE(runs.current()->lastStep(), player.frame()->step);
    }
    bool looksAt(double time) const
    {
        return player.isLookingBack() && std::abs(player.frame()->time - time) < 0.01
               && viewport.frame() == player.frame();
    }
};

} // namespace

class TestTimeline : public QObject
{
    Q_OBJECT

private slots:
    // A tear is said while the run goes on, and of what it is.
    void tearsAreSaid()
    {
        TimelineShop shop;
        QVERIFY(shop.open("tear_test.ripstop.json"));
        QStringList said; // what is said goes again after a time
        connect(shop.window.statusBar(), &QStatusBar::messageChanged, this,
                [&](const QString& words) { said << words; });
        shop.fly(3.05);
        QVERIFY(!shop.player.frame()->tears.empty());
        const auto toldTears = [&] { return said.filter("tore"); };
        QTRY_VERIFY(!toldTears().isEmpty());
        QVERIFY2(toldTears()[0].contains("structural, link"), qPrintable(toldTears()[0]));
        shop.document.replace(Scene{}); // another scene, in which nothing tore
        QCOMPARE(shop.window.statusBar()->currentMessage(), QString());
    }

    // A click on what broke shows its moment, with the place in the middle of the view; another
    // run does not know that moment, which is said.
    void aBreakIsGoneTo()
    {
        TimelineShop shop;
        QVERIFY(shop.open("tear_test.ripstop.json"));
        shop.fly(3.05);
        const Tear tear = shop.player.frame()->tears.at(0);
        auto& loads = shop.window.docks().panel<LoadPanel>();
        emit loads.breakChosen(shop.player.run(), tear.time, tear.place);
        QTRY_VERIFY(shop.looksAt(tear.time)); // within 0.01 s
        QVERIFY(shop.player.frame()->time <= tear.time);
        QTRY_COMPARE(shop.viewport.camera().focus, tear.place);
        QVERIFY(shop.player.frame()->tears.empty());
        const auto* mark = shop.viewport.findChild<QWidget*>("breakMark");
        QVERIFY(mark && mark->isVisible());
        shop.selection.set({shop.document.scene().items.front().id});
        QVERIFY(!mark->isVisible());

        // where that instant has a frame, what breaks in it is seen, selected, in the one before
        const std::size_t there = 30;
        const double instant = shop.runs.current()->timeOf(there);
        emit loads.breakChosen(shop.player.run(), instant, tear.place);
        QCOMPARE(shop.runs.frame(), there - 1);

        shop.run("backToLive");
        QString said;
        connect(shop.window.statusBar(), &QStatusBar::messageChanged, this,
                [&](const QString& words) { said = words; });
        emit loads.breakChosen(shop.player.run() + 1, tear.time, tear.place);
        QVERIFY2(said.contains("is not recorded"), qPrintable(said));
        QVERIFY(!shop.player.isLookingBack());
        QCOMPARE(shop.viewport.camera().focus, tear.place);
    }

    void looksBackAndReturns()
    {
        TimelineShop shop;
        QVERIFY(shop.open("delta_kite.ripstop.json"));
        QVERIFY(shop.runs.list().empty());
        shop.fly(1.0);
        const auto live = shop.player.frame();
        shop.runs.seekTime(0.5);
        const auto* back = shop.timeline.findChild<QToolButton*>("backToLive");
        QVERIFY(!back->isEnabled());
        QTRY_VERIFY(shop.looksAt(0.5));
        QVERIFY(back->isEnabled());
        QVERIFY(shop.player.frame()->position != live->position);

        // keys of the strip: a frame, ten, the ends
        TimelineStrip& strip = shop.timeline.strip();
        const std::size_t here = shop.runs.frame();
        QTest::keyClick(&strip, Qt::Key_Right);
        QCOMPARE(shop.runs.frame(), here + 1);
        QTest::keyClick(&strip, Qt::Key_Left, Qt::ShiftModifier);
        QCOMPARE(shop.runs.frame(), here - 9);
        QTest::keyClick(&strip, Qt::Key_Home);
        QTRY_VERIFY(shop.looksAt(0.0));
        QTest::keyClick(&strip, Qt::Key_End);
        QTRY_VERIFY(shop.looksAt(1.0));

        // the mouse does so as well
        QTest::mouseClick(&strip, Qt::LeftButton, {}, {strip.placeOf(0.25), strip.height() / 2});
        QTRY_VERIFY(shop.looksAt(0.25));

        shop.run("backToLive");
        QVERIFY(!shop.player.isLookingBack());
        QCOMPARE(shop.player.frame(), live);
        QCOMPARE(shop.viewport.frame(), live);

        // the strip leaves that key to the window, though it has a key End of its own
        const auto isTaken = [&strip](Qt::KeyboardModifiers modifiers) {
            QKeyEvent asks(QEvent::ShortcutOverride, Qt::Key_End, modifiers);
            asks.ignore();
            QApplication::sendEvent(&strip, &asks);
            return asks.isAccepted();
        };
        QVERIFY(isTaken(Qt::NoModifier));
        QVERIFY(!isTaken(Qt::AltModifier));
        const std::size_t stood = shop.runs.frame();
        QTest::keyClick(&strip, Qt::Key_End, Qt::AltModifier);
        QVERIFY(!shop.player.isLookingBack());
        QCOMPARE(shop.runs.frame(), stood);
    }

    // Playing on leaves the past, and the run goes on where it stood.
    void playingGoesOnLive()
    {
        TimelineShop shop;
        QVERIFY(shop.open("rope.ripstop.json"));
        shop.fly(0.5);
        shop.runs.seekTime(0.1);
        QTRY_VERIFY(shop.looksAt(0.1));
        shop.fly(0.8);
        QVERIFY(!shop.player.isLookingBack());
        QCOMPARE(shop.runs.list().size(), std::size_t(1));
    }

    // A branch of an unchanged design comes to the bits of the run that it left; a changed one to
    // others. Both are kept.
    void continuesFromTheExactState()
    {
        TimelineShop shop;
        QVERIFY(shop.open("delta_kite.ripstop.json"));
        shop.fly(1.0);
        const std::uint64_t end = shop.player.frame()->hash;
        shop.runs.seekTime(0.4);
        QTRY_VERIFY(shop.looksAt(0.4));
        const auto step = shop.player.frame()->step;
        shop.run("continueHere");
        QTRY_VERIFY(!shop.player.isLookingBack() && shop.player.frame()->step == step);
        QCOMPARE(shop.runs.list().size(), std::size_t(1)); // nothing has run yet
        shop.fly(1.0);
        QCOMPARE(shop.player.frame()->hash, end);
        QCOMPARE(shop.runs.list().size(), std::size_t(2));
        QCOMPARE(shop.runs.current()->firstStep(), step);
        QVERIFY(QString::fromStdString(shop.runs.current()->origin()).contains("Run 1"));

        // the first run again, and another branch with more viscous air
        shop.runs.setCurrent(shop.runs.list().front());
        QTRY_VERIFY(shop.looksAt(0.0));
        shop.runs.seekTime(0.4);
        QTRY_VERIFY(shop.looksAt(0.4));
        shop.document.push(
            {Message("Viscosity"),
             {SetValues{findProperty(Kind::Settings, "viscosity"), {settingsId}, {0.5}}}});
        shop.run("continueHere");
        QTRY_VERIFY(!shop.player.isLookingBack() && shop.player.frame()->step == step);
        shop.fly(1.0);
        QVERIFY(shop.player.frame()->hash != end);
        QCOMPARE(shop.runs.list().size(), std::size_t(3));
    }

    // Neither when the branch is made, nor when it is played on: not in time and not in the axis.
    void continuingLeavesThePlayheadWhereItIs()
    {
        TimelineShop shop;
        QVERIFY(shop.open("rope.ripstop.json"));
        shop.fly(1.0);
        shop.runs.seekTime(0.4);
        QTRY_VERIFY(shop.looksAt(0.4));
        const TimelineStrip& strip = shop.timeline.strip();
        const double here = shop.runs.time();
        const int place = strip.placeOf(here);
        QVERIFY(place > 100);
        std::vector<double> times;
        std::vector<int> places;
        const auto look = [&] {
            times.push_back(shop.runs.time());
            places.push_back(strip.placeOf(shop.runs.time()));
        };
        connect(&shop.runs, &Recordings::moved, this, look);
        connect(&shop.runs, &Recordings::listChanged, this, look);
        connect(&shop.runs, &Recordings::stateChanged, this, look);
        shop.run("continueHere");
        QTRY_VERIFY(!shop.player.isLookingBack() && !shop.runs.isComputing());
        QTest::qWait(300); // a timer looks for new frames
        look();
        for (std::size_t i = 0; i < times.size(); ++i) {
            QCOMPARE(times[i], here);
            QCOMPARE(places[i], place);
        }
        shop.player.playUntil(0.5);
        QTRY_VERIFY(!shop.player.isPlaying() && shop.runs.list().size() == 2);
        QTRY_VERIFY(std::abs(shop.runs.time() - 0.5) < 0.01);
        QCOMPARE(strip.placeOf(here), place); // the axis is the same
        for (const double time : times)
            QVERIFY2(time >= here && time < 0.51, qPrintable(QString::number(time)));
        shop.runs.disconnect(this);
    }

    // A branch that was reset before it was played has begun nowhere.
    void aBranchThatWasResetPassesNoOriginOn()
    {
        TimelineShop shop;
        QVERIFY(shop.open("rope.ripstop.json"));
        shop.fly(0.5);
        shop.runs.seekTime(0.3);
        QTRY_VERIFY(shop.looksAt(0.3));
        shop.run("continueHere");
        QTRY_VERIFY(!shop.player.isLookingBack() && !shop.runs.isComputing());
        shop.run("reset");
        shop.player.playUntil(0.2);
        QTRY_COMPARE(shop.runs.list().size(), 2U);
        QTRY_VERIFY(!shop.player.isPlaying());
        QCOMPARE(shop.runs.current()->origin(), std::string());
        QTRY_VERIFY(std::abs(shop.runs.time() - 0.2) < 0.01);

        shop.runs.seekTime(0.1);
        QTRY_VERIFY(shop.looksAt(0.1));
        shop.run("continueHere");
        QTRY_VERIFY(!shop.player.isLookingBack() && !shop.runs.isComputing());
        shop.player.playUntil(0.3);
        QTRY_COMPARE(shop.runs.list().size(), 3U);
        QCOMPARE(shop.runs.current()->origin(), std::string("0.10 s of Run 2"));
    }

    // One Play for the run and for what was recorded: it acts on what is seen, and says so.
    void thereIsOneTransport()
    {
        TimelineShop shop;
        QVERIFY(shop.open("rope.ripstop.json"));
        shop.fly(1.0);
        const auto* transport = shop.window.findChild<Transport*>();
        auto* play = transport->findChild<QToolButton*>("play");
        const auto* time = transport->findChild<QLabel*>("time");
        const auto* mode = transport->findChild<QLabel*>("mode");
        QVERIFY(!shop.timeline.findChild<QToolButton*>("playBack"));
        shop.player.setSpeed(0.25);
        shop.runs.seekTime(0.2);
        QTRY_VERIFY(shop.looksAt(0.2));
        QCOMPARE(mode->text(), QString("Past"));
        play->click();
        QVERIFY(shop.runs.isPlaying() && !shop.player.isPlaying());
        QCOMPARE(play->text(), QString("Pause"));
        QTRY_VERIFY(shop.runs.time() > 0.25);
        play->click();
        QVERIFY(!shop.runs.isPlaying());
        QCOMPARE(play->text(), QString("Play"));
        QVERIFY(shop.runs.time() < 0.9);             // at a quarter of the speed of the clock
        QTRY_VERIFY(shop.looksAt(shop.runs.time())); // frames are fetched on another thread
        const auto now = [&] { return QLocale().toString(shop.runs.time(), 'f', 3) + " s"; };
        QTRY_COMPARE(time->text(), now()); // which is shown a little later

        QStringList times; // the time does not leap to the end of the run and back
        connect(&shop.player, &Player::stateChanged, this, [&] { times << time->text(); });
        const QString here = time->text();
        shop.run("continueHere");
        QTRY_VERIFY(!shop.player.isLookingBack() && !shop.runs.isComputing());
        QTest::qWait(100);
        for (const QString& one : times)
            QCOMPARE(one, here);
        shop.player.disconnect(this);
        play->click();
        QVERIFY(shop.player.isPlaying());
        QCOMPARE(mode->text(), QString("Run"));
    }

    // The buttons of the run are there at any width, and the compass lies beside the tools.
    void smallWindowsKeepTheTransport_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("900 x 600") << QSize(900, 600);
        QTest::newRow("1280 x 800") << QSize(1280, 800);
        QTest::newRow("as small as it gets") << QSize(1, 1);
    }
    void smallWindowsKeepTheTransport()
    {
        QFETCH(QSize, size);
        TimelineShop shop;
        QVERIFY(shop.open("rope.ripstop.json"));
        shop.window.resize(size);
        QTest::qWait(50);
        for (const char* name : {"reset", "step", "play"}) {
            const auto* button = shop.window.findChild<Transport*>()->findChild<QToolButton*>(name);
            QCOMPARE(button->visibleRegion().boundingRect(), button->rect());
        }
        const auto* compass = shop.viewport.findChild<Compass*>();
        const auto* tools = shop.viewport.findChild<ToolStrip*>();
        shop.viewport.image(); // puts all in its place
        QVERIFY(!compass->geometry().intersects(tools->geometry()));
    }

    void findsEventsAndBookmarks()
    {
        TimelineShop shop;
        QVERIFY(shop.open("delta_kite.ripstop.json"));
        shop.fly(0.5);
        shop.document.push(
            {Message("Viscosity"),
             {SetValues{findProperty(Kind::Settings, "viscosity"), {settingsId}, {0.5}}}});
        shop.fly(1.0);
        const auto events = shop.runs.current()->events(); // and bridle lines that went taut before
        const RunEvent& edit = events.back();
        QCOMPARE(edit.kind, RunEvent::Kind::Edit);
        QVERIFY(std::abs(edit.time - 0.5) < 0.02);

        shop.runs.seekTime(0.4);
        QVERIFY(shop.runs.toEvent(Recordings::Way::Forward));
        QTRY_VERIFY(shop.looksAt(edit.time));
        QVERIFY(!shop.runs.toEvent(Recordings::Way::Forward));
        const TimelineStrip& strip = shop.timeline.strip();
        // A timer has the strip look for new events, and a window that draws slowly is behind.
        QTRY_VERIFY(strip.tipAt(strip.placeOf(edit.time)).contains("edited"));

        shop.runs.seekTime(0.8);
        shop.runs.addBookmark("here");
        shop.runs.seekTime(0.1);
        QVERIFY(shop.runs.toBookmark(Recordings::Way::Forward));
        QTRY_VERIFY(shop.looksAt(0.8));
        QVERIFY(strip.tipAt(strip.placeOf(shop.runs.time())).contains("here"));
        shop.runs.removeBookmark(0);
        QVERIFY(shop.runs.current()->bookmarks().empty());
    }

    void playsBackInALoop()
    {
        TimelineShop shop;
        QVERIFY(shop.open("rope.ripstop.json"));
        shop.fly(1.0);
        shop.runs.setLoop(Recordings::Range{0.3, 0.5});
        shop.player.setSpeed(10.0);
        shop.runs.play();
        double low = 1e9, high = -1e9;
        for (int i = 0; i < 30; ++i) {
            QTest::qWait(16);
            low = std::min(low, shop.runs.time());
            high = std::max(high, shop.runs.time());
        }
        QVERIFY(shop.runs.isPlaying());
        QVERIFY2(low > 0.27 && high < 0.53, qPrintable(QString("%1 %2").arg(low).arg(high)));
        QVERIFY(high > low);
        shop.runs.setLoop({});
        QTRY_VERIFY(!shop.runs.isPlaying()); // it comes to the end
        QTRY_VERIFY(shop.looksAt(1.0));
    }

    void opensWhatWasSaved()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath("rope.ripstop-run");
        std::uint64_t hash = 0;
        {
            TimelineShop shop;
            QVERIFY(shop.open("rope.ripstop.json"));
            shop.fly(0.5);
            shop.runs.rename(shop.runs.current(), "a swing");
            QVERIFY(!saveRecording(*shop.runs.current(), file.toStdString()));
            hash = shop.player.frame()->hash;
        }
        TimelineShop shop; // with nothing open: the design comes with it
        shop.window.openRun(file);
        QCOMPARE(shop.runs.list().size(), std::size_t(1));
        QCOMPARE(shop.runs.current()->name(), std::string("a swing"));
        QVERIFY(!shop.document.scene().items.empty());
        QTRY_VERIFY(shop.looksAt(0.0));
        shop.runs.seekTime(0.5);
        QTRY_VERIFY(shop.looksAt(0.5));
        QCOMPARE(shop.player.frame()->hash, hash);

        // the opened run goes on from a moment
        shop.runs.seekTime(0.25);
        shop.run("continueHere");
        QTRY_VERIFY(!shop.player.isLookingBack() && shop.player.frame()
                    && std::abs(shop.player.frame()->time - 0.25) < 0.01);
        shop.fly(0.5);
        QCOMPARE(shop.player.frame()->hash, hash);
    }

    void recordsNothingWithoutMemory()
    {
        TimelineShop shop;
        QVERIFY(shop.open("rope.ripstop.json"));
        shop.runs.setMemory(0);
        shop.player.playUntil(0.2);
        QTRY_VERIFY(!shop.player.isPlaying() && shop.player.frame()->time > 0.19);
        QVERIFY(shop.runs.list().empty());
        shop.runs.move(-1); // and nothing breaks
        shop.runs.continueHere();
        shop.runs.play();
        QVERIFY(!shop.player.isLookingBack());
    }
};

const RegisteredTest registered("test_timeline", runWithView<TestTimeline>);

} // namespace ripstop::test_timeline
#include "test_timeline.moc"
