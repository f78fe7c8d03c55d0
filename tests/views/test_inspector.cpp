// The inspector (inspector/inspector.h), typed into and clicked over a scene with one element of
// each kind.
//
// Stages: what is refused, units, search, marks of changed values; then every number,
// choice and switch of the table of properties is set and undone, so that a new property is
// covered without a change here; then several elements at once; and at the end the time for a
// large selection.
#include "document/document.h"
#include "document/selection.h"
#include "document/words.h"
#include "icons/fold_button.h"
#include "inspector/inspector.h"
#include "inspector/scrub_label.h"
#include "language/language.h"
#include "scene/edit.h"
#include "scene/path.h"
#include "views/inspector_form.h"
#include "views/run_with_widgets.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QToolButton>
#include <QtTest>

namespace ripstop::test_inspector {

using Form = InspectorForm;

namespace {

// A number in the middle of what the property allows.
double allowedNumber(const Property& property)
{
    const double low = std::isfinite(property.range.low) ? property.range.low : -1.0;
    const double high = std::isfinite(property.range.high) ? property.range.high : low + 3.0;
    return 0.5 * (low + high);
}

} // namespace

class TestInspector : public QObject
{
    Q_OBJECT

private slots:
    // No page is wider than what is seen of it in a narrow dock, also with a bar to scroll it.
    void nothingIsCutOff()
    {
        Form form;
        for (const Id id : oneOfEachKind) {
            form.selection.set({id});
            QCoreApplication::processEvents();
            for (const QScrollArea* area : form.inspector.findChildren<QScrollArea*>())
                if (area->isVisible()) {
                    const int wide = area->widget()->minimumSizeHint().width();
                    QVERIFY2(wide <= area->viewport()->width(),
                             qPrintable(QString("%1: %2 px in %3 px")
                                            .arg(std::uint32_t(id))
                                            .arg(wide)
                                            .arg(area->viewport()->width())));
                }
        }
    }

    // In the longer language, with all that is folded away, and also in a dock that was made
    // narrow: a choice stands below its label where it has no room beside.
    void choicesCanBeReadWhole_data()
    {
        QTest::addColumn<int>("width"); // px
        QTest::newRow("as wide as the dock at first") << 320;
        QTest::newRow("narrow") << 260;
        QTest::newRow("wide") << 600;
    }
    void choicesCanBeReadWhole()
    {
        QFETCH(int, width);
        const Translation translation(Language::French);
        Form form;
        form.inspector.resize(width, 700);
        int below = 0;
        for (const Id id : oneOfEachKind) {
            form.selection.set({id});
            QCoreApplication::processEvents();
            for (FoldButton* fold : form.inspector.findChildren<FoldButton*>())
                if (fold->isVisible() && !fold->isOpen())
                    fold->click();
            QTest::qWait(10); // they are laid out
            for (const Property& property : propertiesOf(kindOf(*find(form.document.scene(), id))))
                if (auto* box = qobject_cast<QComboBox*>(form.inspector.field(property.key));
                    box && box->isVisible()) {
                    int longest = 0;
                    for (int i = 0; i < box->count(); ++i)
                        longest = std::max(longest,
                                           box->fontMetrics().horizontalAdvance(box->itemText(i)));
                    QVERIFY2(box->width() > longest + 24, // px, of the frame and the arrow
                             qPrintable(labelOf(property)));
                    below += box->x() < 20;
                }
        }
        QVERIFY(width == 600 ? below == 0 : below > 0);
    }

    // A label takes the same room when its value is changed and it stands in bold.
    void labelsKeepTheirWidth()
    {
        ScrubLabel label("Membrane stiffness");
        const int before = label.sizeHint().width();
        QFont font = label.font();
        font.setBold(true);
        label.setFont(font);
        QCOMPARE(label.sizeHint().width(), before);
    }

    // Fabric that was imported as panels has no threads. Choosing that threads carry it makes them,
    // in one step of undo.
    void choosingThreadsMakesThem()
    {
        Scene scene;
        Part part;
        part.carrier = FabricKind::Panels;
        part.particles = {{.id = Id{2}, .mass = 0.1},
                          {.id = Id{3}, .position = Vec3(1, 0, 0), .mass = 0.1},
                          {.id = Id{4}, .position = Vec3(0, 1, 0), .mass = 0.1}};
        part.panels = {{.id = Id{5}, .a = Id{2}, .b = Id{3}, .c = Id{4}, .material = Id{1}}};
        scene.items = {{Id{1}, Material{.membraneStiffness = 1000.0}}, {Id{6}, part}};
        scene.nextId = Id{7};
        Form form;
        form.document.replace(scene);
        form.selection.set({Id{6}});
        auto* box = qobject_cast<QComboBox*>(form.inspector.field("carrier"));
        QVERIFY(box);
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Home);
        const Part& made = *findItem<Part>(form.document.scene(), Id{6});
        QVERIFY(made.carrier == FabricKind::Threads);
        QCOMPARE(made.links.size(), 3U);
        QCOMPARE(form.document.history().count(), 1);
        form.document.history().undo();
        QVERIFY(form.document.scene().items == scene.items);
    }

    // What the scene file would refuse is not taken from the keyboard either.
    void malformedTextIsRefused()
    {
        Form form;
        const Id collider = idOfKind(Kind::Collider);
        form.selection.set({collider});
        QLineEdit* path = form.line("path");
        form.type(path, "0: 0 1 0; 2: 3 1");
        QCOMPARE(std::get<std::string>(form.value(collider, "path")), std::string());
        QVERIFY(form.says("The path must be times"));
        form.type(path, "0: 0 1 0; 2: 3 1 0");
        QCOMPARE(std::get<std::string>(form.value(collider, "path")),
                 std::string("0: 0 1 0; 2: 3 1 0"));
    }

    // One field takes what people write: units, sums, and the complaint says which units would do.
    void numbersWithUnits()
    {
        Form form;
        form.selection.set({Id{3}, Id{4}});
        form.type(form.line("mass"), "25 g");
        QCOMPARE(form.value(Id{4}, "mass"), Value(0.025));
        form.type(form.line("mass"), "+100 %");
        QCOMPARE(form.value(Id{4}, "mass"), Value(0.05));
        form.selection.set({idOfKind(Kind::Wind)});
        form.type(form.line("velocity", 0), "36 km/h");
        QCOMPARE(std::get<Vec3>(form.value(idOfKind(Kind::Wind), "velocity")).x(), 10.0);
        form.type(form.line("velocity", 0), "36 kg");
        QVERIFY(form.says("must be in m/s"));
    }

    void rowsAreFoundByTheirWords()
    {
        Form form;
        form.selection.set({idOfKind(Kind::Material)});
        form.inspector.startSearch();
        QTest::keyClicks(QApplication::focusWidget(), "skin");
        QVERIFY(form.inspector.field("skinFriction")->isVisible());
        QVERIFY(!form.inspector.field("stiffness")->isVisible());
        form.selection.set({Id{3}}); // the words stay for the next thing
        QVERIFY(form.says("No property is about"));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(form.inspector.field("mass")->isVisible());
    }

    // What differs from the default stands out, and one press takes it back, for all selected.
    void changedValuesAreMarkedAndReset()
    {
        Form form;
        form.selection.set({Id{3}, Id{4}});
        const auto reset = [&] {
            for (QToolButton* button : form.inspector.findChildren<QToolButton*>())
                if (button->accessibleName() == "Reset mass" && button->isVisible())
                    return button;
            return static_cast<QToolButton*>(nullptr);
        };
        const Value initial = findProperty(Kind::Particle, "mass")->initial;
        QVERIFY(form.value(Id{3}, "mass") == initial && !reset());
        form.document.push(setValue(form.document.scene(), Id{4}, "mass", 0.5));
        QVERIFY(reset());
        reset()->click();
        QCOMPARE(form.value(Id{4}, "mass"), initial);
        QVERIFY(!reset());
        form.document.history().undo();
        QCOMPARE(form.value(Id{4}, "mass"), Value(0.5));
    }

    // What does nothing is left out until one asks for it, and comes back when it counts.
    void rowsWithoutEffectAreLeftOut()
    {
        Form form;
        form.selection.set({Id{5}}); // a rod
        auto* more = form.inspector.findChild<QToolButton*>("idleFields");
        const auto idleButton = [&] {
            for (QToolButton* button : form.inspector.findChildren<QToolButton*>("idleFields"))
                if (button->isVisible())
                    more = button;
            return more;
        };
        QVERIFY(idleButton() && more->isVisible());
        QVERIFY2(more->text().endsWith("more fields do nothing now"), qPrintable(more->text()));
        QVERIFY(!form.inspector.field("stiffness")->isVisible());
        QVERIFY(form.inspector.field("compliance")->isVisible());
        more->click();
        QVERIFY(form.inspector.field("stiffness")->isVisible());
        QCOMPARE(more->text(), QString("Hide what does nothing now"));
        more->click();
        QVERIFY(!form.inspector.field("stiffness")->isVisible());
        form.document.push(setValue(form.document.scene(), Id{5}, "kind", std::string("spring")));
        QVERIFY(form.inspector.field("stiffness")->isVisible());
        QVERIFY(!form.inspector.field("compliance")->isVisible());
    }

    // Of the settings, what the solver is about stands at the end, folded; a search finds it.
    void howItIsComputedIsFolded()
    {
        Form form;
        form.selection.clear();
        auto* fold = form.inspector.findChild<QToolButton*>("solverFields");
        QVERIFY(fold && fold->isVisible());
        QVERIFY(form.inspector.field("gravity")->isVisible());
        QVERIFY(!form.inspector.field("timeStep")->isVisible());
        fold->click();
        QVERIFY(form.inspector.field("timeStep")->isVisible());
        QVERIFY(form.inspector.field("timeStep")->mapToGlobal(QPoint()).y()
                > form.inspector.field("gravity")->mapToGlobal(QPoint()).y());
        fold->click();
        form.inspector.startSearch();
        QTest::keyClicks(QApplication::focusWidget(), "time step");
        QVERIFY(form.inspector.field("timeStep")->isVisible());
    }

    // A row that does nothing says so, and changes its mind with the set-up.
    void rowsWithoutEffectSaySo()
    {
        Form form;
        form.selection.set({Id{5}});
        const auto label = [&](std::string_view key) {
            for (QLabel* candidate : form.inspector.findChildren<QLabel*>())
                if (candidate->buddy() == form.inspector.field(key))
                    return candidate;
            return static_cast<QLabel*>(nullptr);
        };
        QVERIFY(label("stiffness")->toolTip().contains("Does nothing now"));
        QVERIFY(!label("compliance")->toolTip().contains("Does nothing now"));
        form.document.push(setValue(form.document.scene(), Id{5}, "kind", std::string("spring")));
        QVERIFY(!label("stiffness")->toolTip().contains("Does nothing now"));
        QVERIFY(label("compliance")->toolTip().contains("Does nothing now"));
    }

    void everyNumberCanBeTypedAndUndone_data()
    {
        QTest::addColumn<int>("row");
        const auto table = allProperties();
        for (int i = 0; i < int(table.size()); ++i) {
            const Property& property = table[std::size_t(i)];
            if (property.optional || std::holds_alternative<double>(property.initial)
                || std::holds_alternative<int>(property.initial))
                QTest::newRow(qPrintable(
                    QString("%1.%2").arg(kindName(property.kind).data(), property.key.data())))
                    << i;
        }
    }

    void everyNumberCanBeTypedAndUndone()
    {
        QFETCH(int, row);
        const Property& property = allProperties()[std::size_t(row)];
        const bool whole = std::holds_alternative<int>(property.initial);
        const double number = whole ? 7.0 : allowedNumber(property);
        Form form;
        const Id id = oneOfEachKind[std::size_t(property.kind)];
        form.selection.set({id});
        QLineEdit* edit = form.line(property.key);
        QVERIFY(edit);
        const Scene before = form.document.scene();
        form.type(edit, QString::number(number, 'g', 17));
        QCOMPARE(form.value(id, property.key), whole ? Value(7) : Value(number));
        QCOMPARE(form.document.history().count(), 1);
        form.document.history().undo();
        QVERIFY(form.document.scene() == before);
    }

    void everyChoiceAndSwitchCanBeMade()
    {
        Form form;
        for (const Property& property : allProperties()) {
            const Id id = oneOfEachKind[std::size_t(property.kind)];
            form.selection.set({id});
            QWidget* field = form.inspector.field(property.key);
            QVERIFY2(!field == property.traits.contains(Trait::Noted), property.key.data());
            if (!property.choices.empty()) {
                auto* box = qobject_cast<QComboBox*>(field);
                QVERIFY2(box, property.key.data());
                QCOMPARE(box->count(), int(property.choices.size()));
                box->setFocus();
                const int last = box->count() - 1;
                QTest::keyClick(box, Qt::Key_End);
                QCOMPARE(form.value(id, property.key),
                         Value(std::string(property.choices[std::size_t(last)])));
            } else if (std::holds_alternative<bool>(property.initial)) {
                auto* box = qobject_cast<QCheckBox*>(field);
                QVERIFY2(box, property.key.data());
                const bool before = std::get<bool>(form.value(id, property.key));
                box->click();
                QCOMPARE(form.value(id, property.key), Value(!before));
            }
        }
    }

    void differentValuesShowAsSuchAndAreSetTogether()
    {
        Form form;
        form.document.push(setValue(form.document.scene(), Id{3}, "mass", 0.5));
        form.selection.set({Id{2}, Id{3}, Id{4}});
        QLineEdit* mass = form.line("mass");
        QVERIFY(mass->text().isEmpty()); // mixed: the hint stands there
        QVERIFY(!mass->placeholderText().isEmpty());
        form.type(mass, "0.25");
        for (const Id id : {Id{2}, Id{3}, Id{4}})
            QCOMPARE(form.value(id, "mass"), Value(0.25));
        form.document.history().undo();
        QCOMPARE(form.value(Id{3}, "mass"), Value(0.5));
        QCOMPARE(form.value(Id{4}, "mass"), Value(0.01));
    }

    // Links of a line that were made equal: what differs is an error of rounding, and no one reads
    // it. A seventh digit is none of those that fields show; the sixth is.
    void whatIsReadAlikeIsNotMixed()
    {
        Form form;
        const auto set = [&](Id id, double length) {
            form.document.push(setValue(form.document.scene(), id, "restLength", length));
        };
        for (const Id id : {Id{5}, Id{6}})
            set(id, 0.1);
        set(Id{7}, 0.1 + 2e-17);
        set(Id{6}, std::nextafter(0.1, 1.0));
        form.selection.set({Id{5}, Id{6}, Id{7}});
        QCOMPARE(form.line("restLength")->text(), QString("0.1"));
        set(Id{6}, 0.100001);
        QVERIFY(form.line("restLength")->text().isEmpty());

        form.selection.set({Id{3}, Id{4}});
        for (const Id id : {Id{3}, Id{4}})
            form.document.push(
                setValue(form.document.scene(), id, "position", Vec3(1.0, 2.0, 3.0)));
        form.document.push(
            setValue(form.document.scene(), Id{4}, "position", Vec3(1.0 + 1e-15, 2.0, 3.5)));
        QCOMPARE(form.line("position", 0)->text(), QString("1"));
        QVERIFY(form.line("position", 2)->text().isEmpty());
    }

    // L / EA of a line of 0.25 m and 1000 N, and EA / L of it as a spring; of several lengths
    // neither has a number.
    void whatFollowsFromTheMaterialIsThatOfTheLink()
    {
        Form form;
        const auto set = [&](Id id, const char* key, Value value) {
            form.document.push(setValue(form.document.scene(), id, key, std::move(value)));
        };
        set(Id{9}, "axialStiffness", 1000.0);
        for (const Id id : {Id{5}, Id{6}}) {
            set(id, "role", std::string("line"));
            set(id, "restLength", 0.25);
        }
        const auto told = [&](const char* key) {
            return form.line(key)->placeholderText().replace(QChar(0x00a0), QChar(' '));
        };
        form.selection.set({Id{5}, Id{6}});
        QCOMPARE(told("compliance"), QString("from material (0.25 mm/N)"));
        QCOMPARE(told("stiffness"), QString("from material (4000 N/m)"));
        set(Id{6}, "restLength", 0.5);
        QCOMPARE(told("compliance"), QString("from material"));

        // and what it tears at, whatever limit stands idle beside the rule
        set(Id{9}, "tearRule", std::string("strength"));
        set(Id{9}, "lineStrength", 405.0);
        QCOMPARE(told("tearLimit"), QString("from material (405 N)"));
        set(Id{6}, "strengthFactor", 0.5);
        QCOMPARE(told("tearLimit"), QString("from material"));
    }

    void relativeEditsKeepTheRatio()
    {
        Form form;
        form.document.push(setValue(form.document.scene(), Id{3}, "mass", 0.5));
        form.selection.set({Id{3}, Id{4}});
        form.type(form.line("mass"), "*1.1");
        QCOMPARE(std::get<double>(form.value(Id{3}, "mass")), 0.55);
        QCOMPARE(std::get<double>(form.value(Id{4}, "mass")), 0.011);
    }

    void whatIsNotAllowedIsRefused()
    {
        Form form;
        form.selection.set({Id{3}});
        const Scene before = form.document.scene();
        form.type(form.line("mass"), "-1");
        form.type(form.line("mass"), "heavy");
        QTest::keyClick(form.line("mass"), Qt::Key_Escape);
        QVERIFY(form.document.scene() == before);
        QCOMPARE(form.line("mass")->text(), QString("0.01"));
    }

    void nothingSelectedShowsTheSettings()
    {
        Form form;
        form.type(form.line("timeStep"), "0.002");
        QCOMPARE(form.document.scene().settings.timeStep, 0.002);
    }

    // Another design, opened over one that was changed, may have other things by the same ids.
    void anotherDesignHasOtherThingsByTheSameIds()
    {
        for (const Id id : oneOfEachKind) {
            Form form;
            // who has sliders hears of a file that is saved under another name
            QVERIFY(
                !form.inspector.sliders().toggle(propertyOf<&Settings::timeStep>(), {settingsId}));
            form.type(form.line("timeStep"), "0.002"); // unsaved
            if (id != settingsId)
                form.selection.set({id});
            Scene other;
            other.items = {{id == settingsId ? Id{1} : id, Wind{}}};
            const bool wasWind = idOfKind(Kind::Wind) == id;
            if (wasWind)
                other.items.front().item = Material{};
            other.nextId = Id{100};
            form.document.replace(other);
            QVERIFY(form.selection.ids().empty());
            QVERIFY(form.line("timeStep"));
        }
    }

    // What a designer waits for when a whole sail is selected; the bound is generous for slow
    // machines, the point is that it does not grow with the square.
    void aLargeSelectionIsShownSoon()
    {
        Form form;
        Scene scene;
        Part part;
        std::vector<Id> ids;
        for (std::uint32_t i = 0; i < 20000; ++i) {
            part.particles.push_back({.id = Id{i + 2}});
            ids.push_back(Id{i + 2});
        }
        scene.items = {{Id{1}, part}};
        scene.nextId = Id{30000};
        form.document.replace(scene);
        form.selection.set(ids);
        form.type(form.line("mass"), "0.5");
        QCOMPARE(form.value(Id{20001}, "mass"), Value(0.5));
        QCOMPARE(form.document.history().count(), 1);
    }
};

const RegisteredTest registered("test_inspector", runWithWidgets<TestInspector>);

} // namespace ripstop::test_inspector
#include "test_inspector.moc"
