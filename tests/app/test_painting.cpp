// The brush in the whole window: the view shows what it paints while it is chosen, strokes with the
// mouse are steps of the history, keys and wheel change its radius.
#include "app/sheet_shop.h"

#include "actions/actions.h"
#include "icons/complaint.h"
#include "overlays/legend.h"
#include "shaping/brush.h"
#include "start/parameter_field.h"
#include "tools/pointing.h"

#include <QComboBox>
#include <QLineEdit>

namespace ripstop::test_painting {

namespace {

// A sheet of panels that carry its pull.
Scene elasticSheet()
{
    Scene scene = Sheet().scene;
    for (Entry& entry : scene.items) {
        if (Part* part = std::get_if<Part>(&entry.item)) {
            part->carrier = FabricKind::Panels;
            part->links.clear();
        }
        if (Material* material = std::get_if<Material>(&entry.item))
            material->membraneStiffness = 1e4;
    }
    return scene;
}

const Part& partOf(const Scene& scene)
{
    for (const Entry& entry : scene.items)
        if (const Part* part = std::get_if<Part>(&entry.item))
            return *part;
    std::abort();
}

// Panels that are not as strong as their material.
std::size_t paintedIn(const Shop& shop)
{
    return std::size_t(
        std::ranges::count_if(partOf(shop.document.scene()).panels,
                              [](const Panel& panel) { return panel.strengthFactor != 1.0; }));
}

// Counts presses of mouse buttons on what it filters.
struct Presses : QObject
{
    int count = 0;
    bool eventFilter(QObject*, QEvent* event) override
    {
        count += event->type() == QEvent::MouseButtonPress;
        return false;
    }
};

} // namespace

class TestPainting : public QObject
{
    Q_OBJECT

private slots:
    void aStrokeIsOneStep()
    {
        Shop shop(elasticSheet());
        shop.run("toolBrush");
        shop.viewport.brush().radius = 0.3;
        shop.viewport.brush().falloff = Falloff::Hard;
        shop.drag(shop.at({-0.5, 2.0, 0.0}), shop.at({0.5, 2.0, 0.0}));
        const std::size_t painted = paintedIn(shop);
        QVERIFY(painted > 0 && painted < partOf(shop.document.scene()).panels.size());
        QCOMPARE(shop.document.history().count(), 1);
        shop.document.history().undo();
        QCOMPARE(paintedIn(shop), std::size_t(0));
    }

    // Colours and strokes are those of what is painted, and those from before come back.
    void theViewShowsWhatIsPainted()
    {
        Shop shop(elasticSheet());
        shop.run("bySpeed");
        shop.run("toolBrush");
        QCOMPARE(shop.viewport.colorBy(), ColorBy::Strength);
        QVERIFY(shop.window.actions()["byStrength"]->isChecked());
        auto* what = shop.viewport.findChild<QWidget*>("brushBar")->findChild<QComboBox*>();
        what->setCurrentIndex(int(Painted::Grain));
        emit what->activated(int(Painted::Grain));
        QCOMPARE(shop.viewport.colorBy(), ColorBy::Grain);
        QVERIFY(shop.window.actions()["grain"]->isChecked());
        QTest::keyClick(&shop.viewport, Qt::Key_Escape);
        QVERIFY(shop.window.actions()["toolPointer"]->isChecked());
        QCOMPARE(shop.viewport.colorBy(), ColorBy::Speed);
        QVERIFY(!shop.window.actions()["grain"]->isChecked());
    }

    // What is clicked beside the fields of its bar stays there.
    void clicksOnTheBarAreNotForTheView()
    {
        Shop shop(elasticSheet());
        shop.run("toolBrush");
        auto* bar = shop.viewport.findChild<QWidget*>("brushBar");
        QTRY_VERIFY(bar->isVisible());
        Presses presses;
        shop.viewport.installEventFilter(&presses);
        QTest::mouseClick(bar, Qt::LeftButton, {}, QPoint(1, 1));
        QCOMPARE(presses.count, 0);
        QTest::mouseClick(&shop.viewport, Qt::LeftButton, {}, QPoint(1, 1));
        QCOMPARE(presses.count, 1);
    }

    // A number that cannot be taken says what can, in the bar and in its tip, until it is mended or
    // another number is painted.
    void theBarSaysWhatANumberMustBe()
    {
        Shop shop(elasticSheet());
        shop.run("toolBrush");
        auto* bar = shop.viewport.findChild<QWidget*>("brushBar");
        QTRY_VERIFY(bar->isVisible());
        const auto* complaint = bar->findChild<Complaint*>();
        QVERIFY(!complaint->isVisible());
        const auto fields = bar->findChildren<ParameterField*>();
        const auto strength = *std::ranges::find_if(fields, &ParameterField::isVisible);
        auto* number = strength->findChild<QLineEdit*>();
        const auto type = [&](const char* text) {
            number->selectAll();
            QTest::keyClicks(number, text);
        };
        const double before = shop.viewport.brush().values[0];
        for (const char* text : {"-2", "soft"}) {
            type(text);
            QVERIFY(complaint->isVisible());
            QCOMPARE(complaint->text(), QString("Strength must be a number from 0.001 to 1000."));
            QVERIFY(strength->toolTip().contains(complaint->text()));
            QVERIFY(shop.viewport.rect().contains(bar->geometry()));
            QCOMPARE(shop.viewport.brush().values[0], before);
        }
        auto* what = bar->findChild<QComboBox*>();
        what->setCurrentIndex(int(Painted::Grain));
        emit what->activated(int(Painted::Grain));
        QVERIFY(!complaint->isVisible());
        what->setCurrentIndex(int(Painted::Strength));
        emit what->activated(int(Painted::Strength));
        QVERIFY(complaint->isVisible());
        type("0.7");
        QVERIFY(!complaint->isVisible());
        QVERIFY(!strength->toolTip().contains("must"));
        QCOMPARE(shop.viewport.brush().values[0], 0.7);
    }

    void escapeGivesUpTheStrokeAndThenTheTool()
    {
        Shop shop(elasticSheet());
        shop.run("toolBrush");
        shop.viewport.brush().radius = 0.3;
        const QPointF from = shop.at({-0.5, 2.0, 0.0}), to = shop.at({0.5, 2.0, 0.0});
        shop.press(from);
        shop.move(from, to);
        QVERIFY(paintedIn(shop) > 0);
        QTest::keyClick(&shop.viewport, Qt::Key_Escape);
        QCOMPARE(paintedIn(shop), std::size_t(0));
        shop.release(to);
        QVERIFY(shop.window.actions()["toolBrush"]->isChecked());
        QTest::keyClick(&shop.viewport, Qt::Key_Escape);
        QVERIFY(shop.window.actions()["toolPointer"]->isChecked());
    }

    // A new scene begins with a radius that fits it, and the field of the bar follows.
    void theRadiusIsChangedByKeysWheelAndField()
    {
        Shop shop(elasticSheet());
        Brush& brush = shop.viewport.brush();
        QCOMPARE(brush.radius, fittingRadius(shop.document.scene()));
        shop.run("toolBrush");
        const double before = brush.radius;
        shop.run("brushWider");
        QVERIFY(brush.radius > before);
        shop.run("brushNarrower");
        QVERIFY(std::abs(brush.radius - before) < 0.01 * before);
        shop.wheel(shop.at({0.0, 2.0, 0.0}), 1, Qt::ControlModifier);
        QVERIFY(brush.radius > before);
    }

    // A run goes back to its start, where the design is painted.
    void paintsTheDesign()
    {
        Shop shop(elasticSheet());
        QTRY_VERIFY(shop.player.frame());
        shop.player.play();
        QTRY_VERIFY(shop.frame().step > 5);
        shop.run("toolBrush");
        QTRY_COMPARE(shop.frame().step, 0);
        QVERIFY(!shop.player.isPlaying());
    }
};

const RegisteredTest registered("test_painting", runWithView<TestPainting>);

} // namespace ripstop::test_painting
#include "test_painting.moc"
