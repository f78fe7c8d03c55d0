// What the inspector does for materials: steps through the library, presets, values that do nothing
// and are made to count, and the unit of a tear limit.
#include "builders/builder.h"
#include "inspector/preset_chooser.h"
#include "materials/presets.h"
#include "scene/edit.h"
#include "scene/path.h"
#include "views/inspector_form.h"
#include "views/run_with_widgets.h"

#include <QToolButton>

namespace ripstop::test_inspector_materials {

using Form = InspectorForm;

class TestInspectorMaterials : public QObject
{
    Q_OBJECT

private slots:
    // Lighter and stiffer are a press away, and say what they made of it.
    void stepsThroughTheLibrary()
    {
        Form form;
        Material cloth;
        cloth.name = "cloth";
        give(cloth, **findPreset("ripstop_075"));
        form.document.push({Message("Add"), {AddItem{0, {Id{40}, cloth}}}});
        form.selection.set({Id{40}});
        const auto step = [&](const QString& text) {
            for (QToolButton* button : form.inspector.findChildren<QToolButton*>())
                if (button->text() == text)
                    return button;
            return static_cast<QToolButton*>(nullptr);
        };
        QVERIFY(step("Lighter")->toolTip().contains("47 \u2192 42.5 g/m\u00b2"));
        step("Lighter")->click();
        QVERIFY(form.says("cloth is of Dominico 30D now: Areal density 47 \u2192 42.5 g/m\u00b2"));
        QCOMPARE(form.value(Id{40}, "arealDensity"), Value(0.0425));
        form.document.history().undo();
        QCOMPARE(form.value(Id{40}, "arealDensity"), Value(0.047));
        step("Stiffer")->click();
        QCOMPARE(form.value(Id{40}, "membraneStiffness"), Value(46000.0));
        form.selection.set({Id{9}}); // made of nothing
        QVERIFY(!step("Lighter")->isEnabled());
        QVERIFY(step("Lighter")->toolTip().contains("has no"));
    }

    // A cloth whose stiffness does nothing says so, and a link gives its links their widths, those
    // of a triangle that was cut with sides of 0.75, 1 and 1.25 m.
    void whatDoesNothingIsMadeToCount()
    {
        Form form;
        form.document.push(setValue(form.document.scene(), Id{9}, "membraneStiffness", 40000.0));
        form.document.push(setValue(form.document.scene(), Id{5}, "restLength", 0.75));
        form.document.push(setValue(form.document.scene(), Id{6}, "restLength", 1.25));
        form.selection.set({Id{9}});
        QVERIFY(form.says("Membrane stiffness does nothing now"));
        for (QLabel* label : form.inspector.findChildren<QLabel*>())
            if (label->text().contains("Give its links widths"))
                emit label->linkActivated("0");
        QVERIFY(!form.says("does nothing now"));
        QCOMPARE(form.value(Id{5}, "role"), Value(std::string("thread")));
        QCOMPARE(form.value(Id{5}, "width"), Value(0.5)); // of 0.375 m^2 along 0.75 m
        form.document.history().undo();
        QCOMPARE(form.value(Id{5}, "width"), Value(0.0));
    }

    // One edit for all numbers, which one undo takes back; the button names what the material has.
    void presetsOfMaterials()
    {
        Form form;
        const Id material = idOfKind(Kind::Material);
        form.selection.set({material});
        auto* chooser = form.inspector.findChild<PresetChooser*>();
        QVERIFY(chooser && chooser->isVisible());
        auto* button = chooser->findChild<QToolButton*>();
        QVERIFY(button->text().startsWith("Choose"));
        const int before = form.document.history().count();
        const Preset& preset = **findPreset("dyneema_2");
        chooser->apply(preset);
        QCOMPARE(form.document.history().count(), before + 1);
        QCOMPARE(std::get<double>(form.value(material, "diameter")), 2e-3);
        form.document.history().undo();
        QCOMPARE(std::get<double>(form.value(material, "diameter")), 0.0);

        Scene scene = *build(*findBuilder("rope"), {{"segments", 4}});
        const Id cord = *findNamed(scene, Kind::Material, "cord");
        form.document.replace(scene);
        form.selection.set({cord});
        chooser->apply(preset);
        QCOMPARE(button->text(), QString::fromStdString(preset.label));
        form.document.push(setValue(form.document.scene(), cord, "diameter", 0.01));
        QVERIFY(button->text().startsWith("Choose"));
    }

    // A tear limit is in metres, newtons or a part of the length, as its rule is.
    void aTearLimitHasTheUnitOfItsRule()
    {
        Form form;
        const Id material = idOfKind(Kind::Material);
        form.document.push(
            setValue(form.document.scene(), material, "tearRule", std::string("force")));
        form.selection.set({material});
        form.type(form.line("tearLimit"), "2 kN");
        QCOMPARE(form.value(material, "tearLimit"), Value(2000.0));
        form.document.push(
            setValue(form.document.scene(), material, "tearRule", std::string("strain")));
        form.type(form.line("tearLimit"), "15 %");
        QCOMPARE(form.value(material, "tearLimit"), Value(0.15));
    }
};

const RegisteredTest registered("test_inspector_materials", runWithWidgets<TestInspectorMaterials>);

} // namespace ripstop::test_inspector_materials
#include "test_inspector_materials.moc"
