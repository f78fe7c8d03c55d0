// What a designer does with the Insert menu: insert with a preview, change parameters, detach.
//
// Stages: the builder dialog for new designs and every builder in it; insertion with a preview;
// refusals and sliders; then parameters of a part, work by hand that would be lost, and detaching.
#include "app/insert_shop.h"
#include "author/rebuild.h"
#include "dialogs/builder_dialog.h"
#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "editor/main_window.h"
#include "scene/path.h"
#include "viewport/viewport.h"
#include "views/run_with_widgets.h"

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>
#include <QWheelEvent>
#include <QtTest>

namespace ripstop::test_insert {

namespace {

Scene built(const char* name) { return *build(*findBuilder(name), {}); }

using Shop = InsertShop;

} // namespace

class TestInsert : public QObject
{
    Q_OBJECT

private slots:
    // Real cloth, spars and lines bring their own mass; the fields of ideal ones are folded away,
    // and keep what they say.
    void whatDoesNothingIsFolded()
    {
        BuilderDialog dialog(QStringLiteral("delta_kite"));
        const auto isShown = [&](const char* key) {
            return dialog.findChild<QWidget*>(key)->isVisibleTo(&dialog);
        };
        auto* cloth = dialog.findChild<QWidget*>("cloth")->findChild<QComboBox*>();
        auto* fold = dialog.findChild<QToolButton*>("idleParameters");
        QVERIFY(isShown("span") && isShown("cloth") && isShown("keel_length"));
        QVERIFY(!isShown("fabric") && !isShown("frame_mass") && !isShown("line_density"));
        QVERIFY(!isShown("keel"));
        QVERIFY(fold->text().startsWith("6 more"));
        auto* spars = dialog.findChild<QWidget*>("spars")->findChild<QComboBox*>();
        const int tubes = spars->currentIndex();
        cloth->setCurrentIndex(0);
        QVERIFY(isShown("frame_mass")); // spars have become ideal as well
        spars->setCurrentIndex(tubes);
        QVERIFY(isShown("fabric") && isShown("keel") && !isShown("keel_length"));
        QCOMPARE(numberOf(dialog, "fabric")->text(), QStringLiteral("0.045"));
        fold->click();
        QVERIFY(isShown("frame_mass") && isShown("keel_length"));
        fold->click();
        QVERIFY(!isShown("frame_mass"));
    }

    // Enter takes the number that was typed and leaves all others, and the dialog, as they are;
    // also before there was time to build anything of it.
    void enterKeepsWhatWasTyped()
    {
        BuilderDialog dialog(QStringLiteral("delta_kite"));
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        QApplication::setActiveWindow(&dialog);
        auto* cloth = dialog.findChild<QWidget*>("cloth")->findChild<QComboBox*>();
        cloth->setCurrentIndex(0);
        QLineEdit* span = numberOf(dialog, "span");
        span->setFocus();
        typeInto(span, "3");
        QTest::keyClick(span, Qt::Key_Return);
        QCOMPARE(span->text(), QStringLiteral("3"));
        QCOMPARE(cloth->currentIndex(), 0);
        QVERIFY(dialog.isVisible());
        QTRY_VERIFY(okOf(dialog)->isEnabled());
        QTest::keyClick(span, Qt::Key_Return);
        QCOMPARE(span->text(), QStringLiteral("3"));
        QVERIFY(dialog.isVisible());
        QVERIFY(qobject_cast<QPushButton*>(okOf(dialog))->isDefault());
    }

    // What was typed for a design is there again when one comes back to it; a span or a wind is
    // that of the next design, too, where it may have it.
    void eachDesignKeepsWhatWasTyped()
    {
        BuilderDialog dialog(QStringLiteral("delta_kite"));
        auto* builders = dialog.findChild<QComboBox*>("builder");
        const auto see = [&](const char* design, const char* key) { // the text of its number
            builders->setCurrentIndex(builders->findData(QString(design)));
            return numberOf(dialog, key)->text();
        };
        typeInto(numberOf(dialog, "span"), "3");
        typeInto(numberOf(dialog, "wind"), "9");
        QCOMPARE(see("hang_glider", "span"), QString("3"));
        typeInto(numberOf(dialog, "span"), "10.5");
        QCOMPARE(see("delta_kite", "span"), QString("3"));
        QCOMPARE(see("bridle", "wind"), QString("9"));
        dialog.findChild<QPlainTextEdit*>()->setPlainText("1\t0.4");
        QCOMPARE(see("hang_glider", "span"), QString("10.5"));
        QCOMPARE(see("bridle", "wind"), QString("9"));
        QCOMPARE(dialog.findChild<QPlainTextEdit*>()->toPlainText(), QString("1\t0.4"));
    }

    // Choices and sliders that pass under the wheel stay as they are; one that has the focus turns.
    void scrollingChangesNothing()
    {
        Shop shop(built("cloth"));
        BuilderDialog dialog(QStringLiteral("delta_kite"));
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        QApplication::setActiveWindow(&dialog);
        const auto turn = [&](QWidget* at) {
            const QPointF middle(at->rect().center());
            QWheelEvent event(middle, at->mapToGlobal(middle), {}, QPoint(0, -120), Qt::NoButton,
                              Qt::NoModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(at, &event);
        };
        auto* spars = dialog.findChild<QWidget*>("spars")->findChild<QComboBox*>();
        auto* slider = dialog.findChild<QWidget*>("span")->findChild<QSlider*>();
        numberOf(dialog, "chord")->setFocus();
        const int made = spars->currentIndex(), stands = slider->value();
        turn(spars);
        turn(slider);
        QCOMPARE(spars->currentIndex(), made);
        QCOMPARE(slider->value(), stands);
        QVERIFY(spars->focusPolicy() != Qt::WheelFocus);
        spars->setFocus();
        turn(spars);
        QCOMPARE(spars->currentIndex(), made + 1);
    }

    // Whatever was looked at before: the camera stands before a room as high as a person, and the
    // first thing that comes, here far away, takes nothing out of the picture.
    void aNewSceneShowsWhatIsInIt()
    {
        Shop shop(Scene{});
        QVERIFY(shop.window.files().open(SCENES_DIR "/parachute.ripstop.json"));
        Camera far;
        far.focus = Vec3(500.0, 80.0, 0.0);
        far.distance = 900.0;
        shop.viewport.look(far);
        shop.window.files().startNew();
        const QRectF view = shop.viewport.rect();
        const QPointF floor = shop.at(Vec3::Zero()), head = shop.at(Vec3(0.0, 1.75, 0.0));
        QVERIFY(view.contains(floor) && view.contains(head));
        QVERIFY(floor.y() - head.y() > 0.25 * view.height());
        QVERIFY(floor.y() - head.y() < 0.8 * view.height());

        const Camera near = shop.viewport.camera();
        const QImage before = shop.viewport.image(Viewport::Overlays::Without);
        Scene scene = shop.document.scene();
        Part part;
        part.particles.push_back({.id = takeId(scene), .position = Vec3(0.0, 0.0, 500.0)});
        scene.items.push_back({takeId(scene), part});
        shop.document.replace(scene);
        QTRY_VERIFY(shop.player.frame() != nullptr);
        shop.viewport.look(near); // it is behind the eye
        QCOMPARE(shop.viewport.image(Viewport::Overlays::Without), before);
    }

    // What is built is seen beside the dialog, and fills the view once that is gone.
    void whatIsInsertedIsSeenBesideTheDialog()
    {
        Shop shop(Scene{});
        shop.window.resize(1600, 900);
        shop.window.files().startNew();
        QTest::qWait(20);
        const auto bounds = [&shop] {
            QRectF box;
            forEachPart(shop.document.scene(), [&](Id, const Part& part) {
                for (const Panel& panel : part.panels) {
                    const QPointF place = shop.at(findRow(part.particles, panel.a)->position);
                    box = box.isNull() ? QRectF(place, QSizeF(1, 1))
                                       : box.united(QRectF(place, QSizeF(1, 1)));
                }
            });
            return box;
        };
        shop.during<BuilderDialog>("insert delta_kite", [&](BuilderDialog& dialog) {
            QTRY_VERIFY(okOf(dialog)->isEnabled());
            const QPoint corner = shop.viewport.mapFromGlobal(dialog.frameGeometry().topLeft());
            QVERIFY(corner.x() < shop.viewport.width()); // it covers a part of the view
            QVERIFY2(bounds().right() < corner.x(), "it is under the dialog");
            QVERIFY(bounds().left() > 0.0);
            QVERIFY(std::max(bounds().width() / corner.x(),
                             bounds().height() / shop.viewport.height())
                    > 0.5); // close
            okOf(dialog)->click();
        });
        const QRectF view = shop.viewport.rect();
        QVERIFY(view.contains(bounds()));
        QVERIFY(std::max(bounds().width() / view.width(), bounds().height() / view.height()) > 0.5);
    }

    void whatADesignIsStandsBeforeItsMesh()
    {
        BuilderDialog dialog("delta_kite");
        dialog.show();
        const auto placeOf = [&dialog](const char* key) {
            return dialog.findChild<QWidget*>(key)->y();
        };
        for (const char* shape : {"span", "chord", "line_length", "wind"})
            QVERIFY2(placeOf(shape) < placeOf("segments"), shape);
        QVERIFY(placeOf("chord") < placeOf("cloth"));
        QVERIFY(placeOf("cloth") < placeOf("line_length"));
    }

    void theBuilderDialogBuildsWhatItSays()
    {
        BuilderDialog dialog("delta_kite");
        dialog.show();
        QTRY_VERIFY(okOf(dialog)->isEnabled());
        forEachPart(dialog.scene(),
                    [](Id, const Part& part) { QCOMPARE(part.carrier, FabricKind::Panels); });
        dialog.findChild<QPushButton*>("ideal")->click();
        QTRY_VERIFY(dialog.findChild<QLabel*>("counts")->text().contains("152 particles"));
        std::size_t particles = 0;
        forEachPart(dialog.scene(),
                    [&](Id, const Part& part) { particles += part.particles.size(); });
        QCOMPARE(particles, std::size_t(152)); // validation 1.5
    }

    // Ideal cloth, chosen in its box alone, brings what goes with it, as cloth=ideal does in a
    // terminal: spars and line, the dihedral and the depth of the keel that the paper has. What a
    // person has set stays, both ways.
    void idealClothAloneBringsTheDesignOfThePapers()
    {
        BuilderDialog dialog(QStringLiteral("delta_kite"));
        const auto boxOf = [&](const char* key) {
            return dialog.findChild<QWidget*>(key)->findChild<QComboBox*>();
        };
        QCOMPARE(numberOf(dialog, "dihedral")->text(), QString("7"));
        boxOf("cloth")->setCurrentIndex(0);
        QCOMPARE(boxOf("spars")->currentIndex(), 0);
        QCOMPARE(boxOf("cord")->currentIndex(), 0);
        QCOMPARE(numberOf(dialog, "dihedral")->text(), QString("8"));
        QCOMPARE(numberOf(dialog, "keel_depth")->text(), QString("0.4"));
        QTRY_VERIFY(okOf(dialog)->isEnabled());
        QVERIFY(dialog.findChild<QLabel*>("counts")->text().contains("152 particles"));

        typeInto(numberOf(dialog, "keel_depth"), "0.45");
        boxOf("cloth")->setCurrentIndex(2);
        QCOMPARE(numberOf(dialog, "dihedral")->text(), QString("7"));
        QCOMPARE(numberOf(dialog, "keel_depth")->text(), QString("0.45"));
        QVERIFY(boxOf("spars")->currentIndex() > 0);
        QCOMPARE(boxOf("cloth")->currentIndex(), 2);
        boxOf("cloth")->setCurrentIndex(0);
        QCOMPARE(numberOf(dialog, "keel_depth")->text(), QString("0.45"));
    }

    // A part that is built again keeps its numbers: nobody knows which of them were typed.
    void aPartKeepsItsNumbersBesideIdealCloth()
    {
        const Builder& kite = *findBuilder("delta_kite");
        Shop shop(*build(kite, newDesign(kite, {})));
        shop.selection.set({shop.part(0)});
        shop.during<BuilderDialog>("parameters", [&](BuilderDialog& dialog) {
            QTRY_VERIFY(okOf(dialog)->isEnabled());
            dialog.findChild<QWidget*>("cloth")->findChild<QComboBox*>()->setCurrentIndex(0);
            QCOMPARE(numberOf(dialog, "dihedral")->text(), QString("7"));
        });
    }

    // A new design is of real materials; one of a file that does not say what it is made of, not.
    void showsWhatAnOlderFileMeans()
    {
        BuilderDialog fresh("parachute");
        QVERIFY(fresh.findChild<QWidget*>("cloth")->findChild<QComboBox*>()->currentIndex() > 0);

        Scene old = built("parachute");
        for (Entry& entry : old.items)
            if (Part* part = std::get_if<Part>(&entry.item))
                std::erase_if(part->parameters, [](const auto& one) {
                    return one.first == "cloth" || one.first == "cord" || one.first == "pressure";
                });
        Shop shop(std::move(old));
        shop.selection.set({shop.part(0)});
        shop.during<BuilderDialog>("parameters", [&](BuilderDialog& dialog) {
            QTRY_VERIFY(okOf(dialog)->isEnabled());
            QCOMPARE(dialog.findChild<QWidget*>("cloth")->findChild<QComboBox*>()->currentIndex(),
                     0);
            QCOMPARE(numberOf(dialog, "pressure")->text(), QString("0"));
        });
    }

    // Each builder opens, and its defaults can be built.
    void everyBuilderHasAForm()
    {
        BuilderDialog dialog("delta_kite");
        dialog.show();
        auto* builders = dialog.findChild<QComboBox*>("builder");
        QCOMPARE(builders->count(), int(allBuilders().size()));
        for (int i = 0; i < builders->count(); ++i) {
            builders->setCurrentIndex(i);
            QTRY_VERIFY2(okOf(dialog)->isEnabled(), qPrintable(builders->currentText()));
        }
    }

    // The preview is in the design while the dialog is open; cancelled, nothing was; accepted, it
    // is one step.
    void insertsWithAPreview()
    {
        Shop shop(built("rope"));
        shop.document.push(*assignment(shop.document.scene(), "settings.airDensity=1"));
        shop.document.history().undo();
        const Scene before = shop.document.scene();
        const std::size_t rope = shop.count();
        const int steps = shop.document.history().count();
        shop.during<BuilderDialog>("insert frame", [&](BuilderDialog& dialog) {
            QTRY_COMPARE(shop.count(), rope + 12);
            typeInto(numberOf(dialog, "columns"), "5");
            QTRY_COMPARE(shop.count(), rope + 18);
            dialog.findChild<QCheckBox*>("show")->click();
            QTRY_COMPARE(shop.count(), rope);
        });
        QCOMPARE(shop.document.history().count(), steps);
        QVERIFY(shop.document.history().canRedo()); // what was undone before can still be redone
        Scene now = shop.document.scene();
        now.nextId = before.nextId;
        QVERIFY(now == before);

        shop.during<BuilderDialog>("insert frame", [&](BuilderDialog& dialog) {
            typeInto(numberOf(dialog, "width"), "240 cm");
            QTRY_VERIFY(okOf(dialog)->isEnabled());
            okOf(dialog)->click();
        });
        QCOMPARE(shop.count(), rope + 12);
        QCOMPARE(findItem<Part>(shop.document.scene(), shop.part(1))->parameters.at("width"), 2.4);
        QCOMPARE(shop.selection.ids(), std::vector{shop.part(1)});
        QCOMPARE(shop.document.history().count(), 1);
        shop.document.history().undo();
        QCOMPARE(shop.count(), rope);
    }

    // What is no part stands in the menu as well, where people look for a wind.
    void addsWhatIsNoPart()
    {
        Shop shop(built("cloth"));
        for (const auto& [id, kind] : {std::pair{"addWind", Kind::Wind},
                                       {"addControl", Kind::Control},
                                       {"addProbe", Kind::Probe},
                                       {"addPlot", Kind::Plot},
                                       {"addMaterial", Kind::Material}}) {
            const Scene before = shop.document.scene();
            shop.window.actions()[id]->trigger();
            QCOMPARE(shop.document.scene().items.size(), before.items.size() + 1);
            const Entry& made = shop.document.scene().items.back();
            QVERIFY(kindOf(*find(shop.document.scene(), made.id)) == kind);
            QCOMPARE(shop.selection.ids(), std::vector{made.id});
            shop.document.history().undo();
            QVERIFY(shop.document.scene().items == before.items);
        }
    }

    void refusesWithASentence()
    {
        Shop shop(built("rope"));
        shop.during<BuilderDialog>("insert bridle", [&](BuilderDialog& dialog) {
            QTRY_VERIFY(okOf(dialog)->isEnabled());
            typeInto(numberOf(dialog, "rows"), "900");
            QTRY_VERIFY(!okOf(dialog)->isEnabled());
            QTRY_VERIFY(dialog.findChild<QLabel*>("counts")->text().contains("Rows"));
            typeInto(numberOf(dialog, "rows"), "2");
            auto* table = dialog.findChild<QPlainTextEdit*>("lengths");
            table->setPlainText("1,5\t0,9\n1,5\tlong\n"); // as a spreadsheet copies it
            QTRY_VERIFY(dialog.findChild<QLabel*>("counts")->text().contains("\"long\""));
            QVERIFY(!okOf(dialog)->isEnabled());
            table->setPlainText("1,5\t1,2\n1,5\t1,2\n");
            QTRY_VERIFY(okOf(dialog)->isEnabled());
            okOf(dialog)->click();
        });
        QCOMPARE(findItem<Part>(shop.document.scene(), shop.part(1))->links.size(), std::size_t(6));
    }

    void slidersAndNumbersAreOne()
    {
        BuilderDialog dialog("rectangular_kite");
        dialog.show();
        auto* field = dialog.findChild<QWidget*>("width");
        auto* slider = field->findChild<QSlider*>();
        typeInto(numberOf(dialog, "width"), "10");
        QCOMPARE(slider->value(), slider->maximum());
        slider->setValue(slider->minimum());
        QCOMPARE(numberOf(dialog, "width")->text(), QString("0.2"));

        // a refused number leaves the slider where it was, not at the first digit of it
        for (const char* refused : {"500", "1x", "-1"}) {
            typeInto(numberOf(dialog, "width"), refused);
            QVERIFY2(!okOf(dialog)->isEnabled(), refused);
            QCOMPARE(slider->value(), slider->minimum());
        }
    }

    // Change, undo, change again; what was tuned stays.
    void parametersAreChanged()
    {
        Shop shop(built("frame"));
        const Scene before = shop.document.scene();
        shop.selection.set({shop.part(0)});
        shop.during<BuilderDialog>("parameters", [&](BuilderDialog& dialog) {
            QVERIFY(!dialog.findChild<QComboBox*>("builder")->isEnabled());
            QCOMPARE(numberOf(dialog, "columns")->text(), QString("3"));
            typeInto(numberOf(dialog, "columns"), "7");
            QTRY_COMPARE(shop.count(), std::size_t(24));
            typeInto(numberOf(dialog, "columns"), "4");
            QTRY_COMPARE(shop.count(), std::size_t(15));
            QTRY_VERIFY(okOf(dialog)->isEnabled());
            okOf(dialog)->click();
        });
        QCOMPARE(shop.count(), std::size_t(15));
        QCOMPARE(shop.selection.ids(), std::vector{shop.part(0)});
        shop.document.history().undo();
        Scene now = shop.document.scene();
        now.nextId = before.nextId;
        QVERIFY(now == before);
        shop.document.history().redo();
        QCOMPARE(shop.count(), std::size_t(15));
    }

    // What is lost stands apart, in the colour of what is wrong; what was painted stays.
    void workByHandIsTold()
    {
        Scene scene = built("frame");
        for (Entry& entry : scene.items)
            if (Part* part = std::get_if<Part>(&entry.item)) {
                part->particles[5].position.x() += 0.3;
                part->links[2].strengthFactor = 0.5;
            }
        Shop shop(std::move(scene));
        shop.selection.set({shop.part(0)});
        shop.during<BuilderDialog>("parameters", [&](BuilderDialog& dialog) {
            auto* lost = dialog.findChild<QLabel*>("lost");
            QTRY_VERIFY(lost->isVisible());
            QVERIFY(lost->text().contains("1 particle moved"));
            QVERIFY(lost->text().contains("detach"));
            QVERIFY(!lost->text().contains("painted"));
            const QString counts = dialog.findChild<QLabel*>("counts")->text();
            QVERIFY2(counts.contains("painted stay at their places: on 1 of"), qPrintable(counts));
            okOf(dialog)->click();
        });
        const Part& part = *findItem<Part>(shop.document.scene(), shop.part(0));
        QCOMPARE(part.links[2].strengthFactor, 0.5);
    }

    void detachingSaysWhatIsLost()
    {
        Shop shop(built("frame"));
        shop.selection.set({shop.part(0)});
        shop.during<QMessageBox>("detach", [&](QMessageBox& box) {
            QVERIFY(box.text().contains("columns"));
            box.button(QMessageBox::Ok)->click();
        });
        QVERIFY(!builderOf(*findItem<Part>(shop.document.scene(), shop.part(0))));
        shop.document.history().undo();
        QVERIFY(builderOf(*findItem<Part>(shop.document.scene(), shop.part(0))));
    }

    // Pictures to look at, where a folder for them is named.
    void pictures()
    {
        const QString folder = qEnvironmentVariable("RIPSTOP_PICTURES");
        for (const char* id :
             {"insert diamond_kite", "insert bridle", "insert hills", "parameters"}) {
            Shop shop(built("frame"));
            shop.selection.set({shop.part(0)});
            shop.during<BuilderDialog>(id, [&](BuilderDialog& dialog) {
                QTRY_VERIFY(okOf(dialog)->isEnabled());
                QVERIFY(dialog.height() <= 720); // fits a small screen
                if (!folder.isEmpty())
                    dialog.grab().save(folder + "/" + id + ".png");
            });
        }
    }
};

const RegisteredTest registered("test_insert", runWithWidgets<TestInsert>);

} // namespace ripstop::test_insert
#include "test_insert.moc"
