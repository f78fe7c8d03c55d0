// Sliders that set the length of a vector: gravity in the tuning panel, the wind there and in the
// inspector.
//
// Stages: there and back again in one drag and in two, over another slider too; then what has never
// pointed anywhere.
#include "views/run_with_widgets.h"
#include "views/tuning_desk.h"

#include <QSlider>
#include <QtTest>

namespace ripstop::test_tuning_vectors {

using Desk = TuningDesk;

namespace {

const Property& gravity = *findProperty(Kind::Settings, "gravity");
const Property& velocity = *findProperty(Kind::Wind, "velocity");

} // namespace

class TestTuningVectors : public QObject
{
    Q_OBJECT

private slots:
    // A vector that a slider takes to 0 points where it did when it comes back: in the same drag,
    // and when the slider is taken up again, also another one over the same vector.
    void theWayBackFromZero_data()
    {
        QTest::addColumn<bool>("isLetGo");
        QTest::newRow("in one drag") << false;
        QTest::newRow("let go at 0") << true;
    }
    void theWayBackFromZero()
    {
        QFETCH(bool, isLetGo);
        Desk desk;
        desk.set(settingsId, "gravity", Vec3(0.0, -9.80665, 0.0));
        auto* bar = desk.add(gravity, {settingsId})->findChild<QSlider*>();
        bar->setSliderDown(true);
        bar->setSliderPosition(bar->minimum());
        QCOMPARE(desk.value(settingsId, gravity), Value(Vec3(0.0, 0.0, 0.0)));
        if (isLetGo) {
            bar->setSliderDown(false);
            desk.add(*findProperty(Kind::Control, "limit"), {Id{14}}); // all rows are made anew
            for (TuningRow* row : desk.panel.findChildren<TuningRow*>())
                if (row->slider().property == &gravity && row->isVisible())
                    bar = row->findChild<QSlider*>();
            bar->setSliderDown(true);
        }
        bar->setSliderPosition((bar->minimum() + bar->maximum()) / 2);
        const auto now = std::get<Vec3>(desk.value(settingsId, gravity));
        QVERIFY(now.y() < 0.0);
        QCOMPARE(now, Vec3(0.0, now.y(), 0.0));
        bar->setSliderDown(false);
    }

    // 3 to 4, as it blew: by keys in the panel to 0, then with the slider in the inspector.
    void theWindComesBackFromWhereItBlew()
    {
        Desk desk;
        const Id wind = desk.firstWind();
        desk.set(wind, "velocity", Vec3(3.0, 0.0, 4.0));
        auto* bar = desk.add(velocity, {wind})->findChild<QSlider*>();
        QTest::keyClick(bar, Qt::Key_Home);
        QCOMPARE(desk.value(wind, velocity), Value(Vec3(0.0, 0.0, 0.0)));
        desk.selection.set({wind});
        QWidget* form = desk.inspector.field("velocity");
        QSlider* other = nullptr;
        while (form && !other) {
            form = form->parentWidget();
            other = form->findChild<QSlider*>();
        }
        QVERIFY(other);
        other->setValue(other->maximum() / 5); // of 25 m/s
        const auto now = std::get<Vec3>(desk.value(wind, velocity));
        QVERIFY((now - Vec3(3.0, 0.0, 4.0)).norm() < 1e-12);
    }

    // What was 0 from the beginning: down for what falls, x for the others.
    void whatWasAlwaysZeroHasAUsualDirection()
    {
        Desk desk;
        Scene scene = oneOfEverything();
        scene.settings.gravity = Vec3::Zero();
        const Id wind = desk.firstWind();
        for (Entry& entry : scene.items)
            if (entry.id == wind)
                std::get<Wind>(entry.item).velocity = Vec3::Zero();
        desk.document.replace(scene);
        desk.add(gravity, {settingsId})->findChild<QSlider*>()->setValue(200);
        desk.add(velocity, {wind})->findChild<QSlider*>()->setValue(200);
        const auto down = std::get<Vec3>(desk.value(settingsId, gravity));
        QVERIFY(down.y() < 0.0);
        QCOMPARE(down, Vec3(0.0, down.y(), 0.0));
        const auto along = std::get<Vec3>(desk.value(wind, velocity));
        QVERIFY(along.x() > 0.0);
        QCOMPARE(along, Vec3(along.x(), 0.0, 0.0));
    }
};

const RegisteredTest registered("test_tuning_vectors", runWithWidgets<TestTuningVectors>);

} // namespace ripstop::test_tuning_vectors
#include "test_tuning_vectors.moc"
