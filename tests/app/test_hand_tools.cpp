// What a person does to a run by hand, with the mouse in the whole window: grab, pin, cut, blow,
// carry, and all of it again by its track.
//
// Stages: grabbing with wheel, Ctrl and Escape; pins; cuts at both depths; the fan; carried
// colliders; then the track of all of it, the bar of settings, and where the bars of all tools lie.
#include "app/sheet_shop.h"

#include "compile/compile.h"
#include "editor/view_bar.h"
#include "io/control_track.h"
#include "simulation/simulation.h"
#include "simulation/torn_system.h"
#include "tools/hand_settings.h"
#include "tools/pointing.h"
#include "tools/tool_strip.h"

#include <QLabel>

namespace ripstop::test_hand_tools {

class TestHandTools : public QObject
{
    Q_OBJECT

private slots:
    // What is grabbed comes to the cursor; the force is told while it is held. Nothing of it is an
    // edit.
    void grabs()
    {
        Shop shop(Sheet().scene);
        QTRY_VERIFY(shop.player.frame());
        shop.run("toolGrab");
        shop.player.play();
        QTRY_VERIFY(shop.frame().step > 5);
        const Vec3 before = shop.now(Sheet::at(8, 8));
        const QPointF from = shop.at(before), to = shop.at(before + Vec3(-0.5, 0.5, 0.0));
        shop.press(from);
        QVERIFY(!shop.frame().held); // a hand that has not moved does not pull
        shop.move(from, to);
        QTRY_VERIFY(shop.frame().held);
        QVERIFY(shop.frame().held->force > 0.0);
        const Vec3 hand = shop.frame().held->to;
        QVERIFY((hand - (before + Vec3(-0.5, 0.5, 0.0))).norm() < 0.05);
        QTRY_VERIFY((shop.now(Sheet::at(8, 8)) - hand).norm() < 0.2);
        shop.release(to);
        QTRY_VERIFY(!shop.frame().held);
        QVERIFY(shop.frame().hands.size() >= 2); // pulls, and that it let go
        QCOMPARE(shop.document.history().count(), 0);
    }

    // The wheel moves the hand away from the eye, Ctrl and a drag needs no tool, Escape lets go.
    void wheelCtrlAndEscape()
    {
        Shop shop(Sheet().scene);
        QTRY_VERIFY(shop.player.frame());
        shop.player.play();
        QTRY_VERIFY(shop.frame().step > 5);
        const double azimuth = shop.viewport.camera().azimuth;
        const QPointF from = shop.at(shop.now(Sheet::at(8, 4)));
        const QPointF to = from + QPointF(60.0, 0.0);
        shop.press(from, Qt::ControlModifier);
        shop.move(from, to, Qt::ControlModifier);
        QTRY_VERIFY(shop.frame().held);
        QCOMPARE(shop.viewport.camera().azimuth, azimuth);
        const double z = shop.frame().held->to.z();
        shop.wheel(to, 3);
        QTRY_VERIFY(shop.frame().held->to.z() < z - 0.05);
        QTest::keyClick(&shop.viewport, Qt::Key_Escape);
        QTRY_VERIFY(!shop.frame().held);
        shop.release(to, Qt::ControlModifier);
        QVERIFY(shop.selection.ids().empty());
    }

    // P pins what is held: it stays there when the hand lets go, until its pins are pulled out.
    void pins()
    {
        Shop shop(Sheet().scene);
        QTRY_VERIFY(shop.player.frame());
        shop.run("toolGrab");
        shop.player.play();
        QTRY_VERIFY(shop.frame().step > 5);
        const Vec3 before = shop.now(Sheet::at(8, 8));
        const QPointF from = shop.at(before), to = shop.at(before + Vec3(-0.5, 0.5, 0.0));
        shop.press(from);
        shop.move(from, to);
        QTRY_VERIFY((shop.now(Sheet::at(8, 8)) - before).norm() > 0.3);
        QTest::keyClick(&shop.viewport, Qt::Key_P);
        QTRY_COMPARE(shop.frame().handPins,
                     std::vector<std::uint32_t>{std::uint32_t(Sheet::at(8, 8))});
        QVERIFY(!std::get<const Particle*>(*find(shop.document.scene(), Sheet::at(8, 8)))->pinned);
        shop.release(to);
        const Vec3 held = shop.now(Sheet::at(8, 8));
        const auto step = shop.frame().step;
        QTRY_VERIFY(shop.frame().step > step + 60);
        QCOMPARE(shop.now(Sheet::at(8, 8)), held);
        shop.run("unpinHands");
        QTRY_VERIFY(shop.frame().handPins.empty());
        QTRY_VERIFY((shop.now(Sheet::at(8, 8)) - held).norm() > 0.05);
    }

    // A stroke right across parts the sheet: its lower half falls away. A reset has it whole.
    void cuts()
    {
        Shop shop(Sheet().scene);
        QTRY_VERIFY(shop.player.frame());
        shop.run("toolCut");
        shop.player.play();
        QTRY_VERIFY(shop.frame().step > 5);
        shop.drag(shop.at({-1.3, 1.9, 0.0}), shop.at({1.3, 1.9, 0.0}));
        QTRY_VERIFY(shop.frame().layout->torn);
        QCOMPARE(std::count(shop.frame().gone.begin(), shop.frame().gone.end(), 1), 0);
        QTRY_VERIFY(shop.now(Sheet::at(8, 4)).y() < 0.0);
        QVERIFY(shop.now(Sheet::at(1, 4)).y() > 2.0);
        QCOMPARE(shop.document.history().count(), 0);
        shop.run("reset");
        QTRY_VERIFY(!shop.frame().layout->torn && shop.frame().step == 0);
        QCOMPARE(shop.now(Sheet::at(8, 4)), Sheet::placeOf(8, 4));
    }

    // Of two sheets behind each other the knife cuts the front one, or both.
    void cutsAsDeepAsAsked_data()
    {
        QTest::addColumn<bool>("through");
        QTest::newRow("the first fabric") << false;
        QTest::newRow("all the way through") << true;
    }
    void cutsAsDeepAsAsked()
    {
        QFETCH(bool, through);
        Scene scene = Sheet().scene;
        Part back = *findItem<Part>(scene, Id{1});
        const std::uint32_t shift = std::uint32_t(scene.nextId);
        const auto moved = [&](Id id) { return Id(std::uint32_t(id) + shift); };
        for (Particle& particle : back.particles) {
            particle.id = moved(particle.id);
            particle.position.z() -= 2.0;
        }
        for (Link& link : back.links) {
            link.id = moved(link.id);
            link.from = moved(link.from);
            link.to = moved(link.to);
        }
        for (Panel& panel : back.panels)
            panel = {moved(panel.id), moved(panel.a), moved(panel.b), moved(panel.c),
                     panel.material};
        scene.items.push_back({moved(Id{1}), back});
        scene.nextId = Id(2 * shift);
        Shop shop(scene);
        QTRY_VERIFY(shop.player.frame());
        shop.window.actions()["through"]->setChecked(through);
        shop.run("toolCut");
        shop.drag(shop.at({-1.3, 1.9, 0.0}), shop.at({1.3, 1.9, 0.0})); // in a pause
        QTRY_VERIFY(shop.frame().layout->torn);
        const auto& splits = shop.frame().layout->torn->splits;
        const auto ofBack = [&](const Split& split) { return split.from >= shift; };
        QVERIFY(!std::ranges::all_of(splits, ofBack));
        QCOMPARE(std::ranges::any_of(splits, ofBack), through);
    }

    // The fan blows from the eye at what is under it, for as long as the button is down.
    void blows()
    {
        Shop shop(Sheet().scene);
        QTRY_VERIFY(shop.player.frame());
        shop.run("toolFan");
        shop.player.play();
        QTRY_VERIFY(shop.frame().step > 5);
        const QPointF middle = shop.at({0.0, 1.5, 0.0});
        shop.press(middle);
        QTRY_VERIFY(shop.now(Sheet::at(6, 4)).z() < -0.02); // away from the eye
        const double speed = shop.viewport.hands().fanSpeed;
        shop.wheel(middle, 2);
        QVERIFY(shop.viewport.hands().fanSpeed > 1.2 * speed);
        QCOMPARE(shop.field("Speed")->text().toDouble(),
                 std::round(shop.viewport.hands().fanSpeed * 1e3) / 1e3);
        QVERIFY(shop.player.hands().hands.fan);
        shop.release(middle);
        QVERIFY(!shop.player.hands().hands.fan);
    }

    // A collider goes where it is carried and stays there; its place in the design does not change.
    void carries()
    {
        Scene scene = Sheet().scene;
        Collider ball;
        ball.shape = ColliderShape::Sphere;
        ball.radius = 0.3;
        ball.position = {0.0, 0.4, 1.0};
        const Id id = takeId(scene);
        scene.items.push_back({id, ball});
        Shop shop(scene);
        QTRY_VERIFY(shop.player.frame());
        shop.run("toolGrab");
        shop.player.play();
        QTRY_VERIFY(shop.frame().step > 5);
        QTRY_COMPARE(shop.viewport.pick(shop.at(ball.position)), id);
        shop.drag(shop.at(ball.position), shop.at(ball.position + Vec3(0.5, 0.0, 0.0)));
        const Vec3 wanted = ball.position + Vec3(0.5, 0.0, 0.0);
        QTRY_VERIFY((shop.frame().colliderPosition[0] - wanted).norm() < 0.03);
        QCOMPARE(findItem<Collider>(shop.document.scene(), id)->position, ball.position);
        QCOMPARE(shop.document.history().count(), 0);
    }

    // What was done in the window is done again, to the bit, by its track.
    void replays()
    {
        const Scene scene = Sheet().scene;
        Shop shop(scene);
        QTRY_VERIFY(shop.player.frame());
        shop.run("toolGrab");
        shop.player.play();
        QTRY_VERIFY(shop.frame().step > 5);
        const QPointF from = shop.at(shop.now(Sheet::at(8, 8)));
        shop.press(from);
        shop.move(from, from + QPointF(-50.0, -50.0));
        QTRY_VERIFY(shop.frame().held);
        QTest::keyClick(&shop.viewport, Qt::Key_P);
        QTRY_VERIFY(!shop.frame().handPins.empty());
        shop.release(from + QPointF(-50.0, -50.0));
        shop.run("toolCut");
        shop.drag(shop.at({-1.3, 1.9, 0.0}), shop.at({0.3, 1.9, 0.0}));
        QTRY_VERIFY(shop.frame().layout->torn);
        shop.run("toolFan");
        shop.press(shop.at({0.0, 2.5, 0.0}));
        const auto blown = shop.frame().step;
        QTRY_VERIFY(shop.frame().step > blown + 30);
        shop.release(shop.at({0.0, 2.5, 0.0}));
        const auto step = shop.frame().step;
        QTRY_VERIFY(shop.frame().step > step + 30);
        shop.player.pause();
        QTest::qWait(100); // the last frame
        const Frame end = shop.frame();

        Simulation again(*compile(scene));
        ControlPlayer hands(trackOf(end));
        while (again.state().step < end.step) {
            hands.giveTo(again);
            QVERIFY(again.step());
        }
        QCOMPARE(again.state().position.size(), end.position.size());
        for (std::size_t i = 0; i < end.position.size(); ++i)
            QVERIFY(Vec3(again.state().position[i]) == Vec3(end.position[i]));
    }

    // The bar has the settings of the tool in use. An empty field leaves the number to the program:
    // five times the weight of 72 particles of 10 g, reached after a fifth of the diagonal of 2.83
    // m.
    void barOfSettings()
    {
        Shop shop(Sheet().scene);
        QTRY_VERIFY(shop.player.frame());
        const HandSettings& hands = shop.viewport.hands();
        QVERIFY(!shop.field("Stiffness")->isVisible());
        shop.run("toolGrab");
        QVERIFY(shop.field("Stiffness")->isVisible() && !shop.field("Speed")->isVisible());
        const double weight = 5.0 * 72 * 0.01 * 9.80665;
        QVERIFY(std::abs(hands.mostIn(shop.document.scene()) - weight) < 0.05 * weight);
        QVERIFY(shop.field("Stiffness")->text().isEmpty());
        QVERIFY(shop.field("Stiffness")->placeholderText().contains("62"));
        shop.type("Stiffness", "250");
        QCOMPARE(hands.stiffness, std::optional(250.0));
        QCOMPARE(shop.window.focusWidget(), &shop.viewport);
        shop.type("Stiffness", "nonsense"); // stays, with a word on it, until it is mended
        QCOMPARE(hands.stiffness, std::optional(250.0));
        QCOMPARE(shop.field("Stiffness")->text(), QString("nonsense"));
        QVERIFY(shop.complaint().startsWith("The number "));
        QTest::keyClick(shop.field("Stiffness"), Qt::Key_Escape);
        QCOMPARE(shop.field("Stiffness")->text(), QString("250"));
        QVERIFY(shop.complaint().isEmpty());
        shop.field("Stiffness")->selectAll();
        QTest::keyClick(shop.field("Stiffness"), Qt::Key_Delete);
        QTest::keyClick(shop.field("Stiffness"), Qt::Key_Return);
        QVERIFY(!hands.stiffness);
        shop.run("toolFan");
        QVERIFY(!shop.field("Stiffness")->isVisible() && shop.field("Speed")->isVisible());
        shop.type("Speed", "36 km/h");
        QVERIFY(std::abs(hands.fanSpeed - 10.0) < 1e-9);
        shop.type("Speed", "1000"); // no fan
        QVERIFY(std::abs(hands.fanSpeed - 10.0) < 1e-9);
        QVERIFY(shop.complaint().contains(" m/s"));
        QTest::keyClick(&shop.viewport, Qt::Key_Escape);
        QVERIFY(!shop.field("Speed")->isVisible());
        QVERIFY(shop.window.actions()["toolPointer"]->isChecked());
    }

    // The bar of a tool lies in the view, and leaves the strip to whoever wants another tool. A
    // view in which its words do not fit into a line has them in several.
    void barsLeaveTheStripOfTools_data()
    {
        QTest::addColumn<QString>("tool");
        QTest::addColumn<QSize>("size");
        const std::pair<const char*, QString> tools[]{{"draw links", "drawLinks"},
                                                      {"draw particles", "drawParticles"},
                                                      {"brush", "toolBrush"},
                                                      {"grab", "toolGrab"}};
        for (const auto& [name, tool] : tools)
            for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)})
                QTest::addRow("%s, %d pixels wide", name, size.width()) << tool << size;
    }
    void barsLeaveTheStripOfTools()
    {
        QFETCH(QString, tool);
        QFETCH(QSize, size);
        Shop shop(Sheet().scene);
        shop.run(qPrintable(tool));
        shop.window.resize(size);
        const auto* strip = shop.viewport.findChild<ToolStrip*>();
        const auto bars = shop.viewport.findChildren<ViewBar*>();
        QTRY_COMPARE(std::ranges::count_if(bars, &ViewBar::isVisible), 1);
        const ViewBar& bar = **std::ranges::find_if(bars, &ViewBar::isVisible);
        QTRY_VERIFY(shop.viewport.rect().contains(bar.geometry()));
        QVERIFY(!bar.geometry().intersects(strip->geometry()));
        for (const auto* words : bar.findChildren<QLabel*>())
            if (words->isVisible())
                QVERIFY(words->width() >= words->minimumSizeHint().width());
    }
};

const RegisteredTest registered("test_hand_tools", runWithView<TestHandTools>);

} // namespace ripstop::test_hand_tools
#include "test_hand_tools.moc"
