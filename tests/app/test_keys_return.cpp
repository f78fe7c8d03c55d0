// Keys belong to the scene again once typing ends, wherever it was: Space plays, Ctrl+Z takes back
// and a letter is the shortcut that it is in the menu.
//
// Stages: every field of every panel, for each kind of thing that can be selected; the dialogs that
// stay open; then Escape, values that are refused, texts of several lines, and the tour.
#include "app/window_shop.h"
#include "document/words.h"
#include "editor/tour.h"
#include "inspector/value_edit.h"
#include "outline/outline.h"
#include "scene/path.h"
#include "tools/pointing.h"
#include "transport/control_keys.h"

#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QTabWidget>
#include <QTextEdit>
#include <QTreeView>
#include <QtTest>

namespace ripstop::test_keys_return {

namespace {

struct OpenWindow : WindowShop
{
    OpenWindow()
    {
        window.resize(1000, 640); // a view in software takes its time
        window.show();
        window.files().open(SCENES_DIR "/tear_test.ripstop.json");
        QApplication::setActiveWindow(&window); // Xvfb has no window manager to do it
        if (!QTest::qWaitFor([this] { return player.frame() != nullptr; }))
            qFatal("no frame comes");
    }

    // Once a dialog is gone no window is active where there is no window manager, and the server
    // says so late.
    void activateIfNoneIs()
    {
        if (!QApplication::activeWindow())
            QApplication::setActiveWindow(&window);
    }

    // As from the keyboard: to the window, where shortcuts are asked first.
    void type(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        activateIfNoneIs();
        QTest::keyClick(QApplication::activeWindow()->windowHandle(), key, modifiers);
    }

    void edit(const char* change)
    {
        const auto edit = assignment(document.scene(), change);
        if (!edit)
            qFatal("%s", edit.message().english().c_str());
        document.push(*edit);
    }
};

bool isLine(const QWidget& field)
{
    return qobject_cast<const QPlainTextEdit*>(&field) || qobject_cast<const QTextEdit*>(&field);
}

QString textOf(const QWidget& field)
{
    if (const auto* line = qobject_cast<const QLineEdit*>(&field))
        return line->text();
    if (const auto* box = qobject_cast<const QAbstractSpinBox*>(&field))
        return box->text();
    if (const auto* lines = qobject_cast<const QPlainTextEdit*>(&field))
        return lines->toPlainText();
    return {};
}

// What can be typed into there now.
QList<QPointer<QWidget>> fieldsIn(const QWidget& place)
{
    QList<QPointer<QWidget>> fields;
    for (auto* widget : place.findChildren<QWidget*>()) {
        const bool isOfABox = qobject_cast<QAbstractSpinBox*>(widget->parentWidget())
                              || qobject_cast<QComboBox*>(widget->parentWidget());
        const auto* lines = qobject_cast<QTextEdit*>(widget);
        if (takesText(widget) && !isOfABox && !(lines && lines->isReadOnly()) && widget->isEnabled()
            && widget->isVisible() && widget->focusPolicy() != Qt::NoFocus)
            fields << widget;
    }
    return fields;
}

QString nameOf(const QWidget& field)
{
    const QString name = field.accessibleName();
    return QString::fromLatin1(field.metaObject()->className()) + ' '
           + (name.isEmpty() ? field.objectName() : name);
}

// One id of each kind of thing that the scene has.
std::vector<Id> oneOfEachKind(const Scene& scene)
{
    std::map<std::size_t, Id> found;
    for (const Entry& entry : scene.items)
        found.try_emplace(entry.item.index(), entry.id);
    std::vector<Id> ids{settingsId};
    for (const auto& [kind, id] : found)
        ids.push_back(id);
    const auto& part = *findItem<Part>(scene, found.at(Item(Part{}).index()));
    ids.insert(ids.end(),
               {part.particles.front().id, part.links.front().id, part.panels.front().id});
    return ids;
}

// Ends typing in a field and looks where the next keys go. Returns what went wrong.
QString complaintAfter(OpenWindow& shop, QWidget& widget, Qt::Key end)
{
    const QPointer<QWidget> field(&widget);
    const QString name = nameOf(widget);
    shop.edit("settings.gravity=0,-9.5,0"); // something to take back
    const int before = shop.document.history().index();
    QApplication::setActiveWindow(widget.window());
    widget.setFocus();
    if (!widget.hasFocus())
        return name + " takes no focus";
    const bool needsControl = isLine(widget) && end != Qt::Key_Escape;
    shop.type(end, needsControl ? Qt::ControlModifier : Qt::NoModifier);
    const auto isBack = [&] {
        shop.activateIfNoneIs();
        return shop.viewport.hasFocus();
    };
    if (!QTest::qWaitFor(isBack)) // the machine may be busy
        return name + " keeps the focus";
    if (end == Qt::Key_Escape)
        return {}; // where the focus is says the rest, as after Enter
    const QString text = field ? textOf(*field) : QString();
    const bool played = shop.player.isPlaying();
    shop.type(Qt::Key_Space);
    if (shop.player.isPlaying() == played)
        return name + ": Space does not play";
    shop.type(Qt::Key_Space);
    shop.type(Qt::Key_H);
    if (!shop.viewport.pointing().hasTool())
        return name + ": H is not the tool";
    shop.run("toolPointer");
    shop.player.reset();
    if ((field && textOf(*field) != text) || QApplication::activePopupWidget())
        return name + " was typed into: " + textOf(*field);
    shop.type(Qt::Key_Z, Qt::ControlModifier);
    if (shop.document.history().index() != before - 1)
        return name + ": Ctrl+Z does not take back";
    return {};
}

} // namespace

class TestKeysReturn : public QObject
{
    Q_OBJECT

private slots:
    void everyFieldOfEveryPanel_data() { keysThatEnd(); }
    void everyFieldOfEveryPanel()
    {
        QFETCH(Qt::Key, end);
        OpenWindow shop;
        int looked = 0;
        for (const auto& [row, dock] : shop.window.docks().all()) {
            shop.window.docks().show(row.id);
            const bool isInspector = QLatin1String(row.id) == "inspector";
            for (const Id id : isInspector ? oneOfEachKind(shop.document.scene())
                                           : std::vector{shop.document.scene().items.front().id}) {
                shop.selection.set({id});
                QTest::qWait(1);
                for (const QPointer<QWidget>& field : fieldsIn(*dock)) {
                    if (!field || !field->isVisible())
                        continue;
                    shop.selection.set({id});
                    const QString complaint = complaintAfter(shop, *field, end);
                    QVERIFY2(complaint.isEmpty(),
                             qPrintable(QLatin1String(row.id) + ' ' + complaint));
                    ++looked;
                }
            }
        }
        QVERIFY2(looked > 60, qPrintable(QString::number(looked)));
    }

    // Dialogs that are open beside the window, whatever Enter does in them.
    void everyFieldOfDialogsThatStay_data() { keysThatEnd(); }
    void everyFieldOfDialogsThatStay()
    {
        QFETCH(Qt::Key, end);
        OpenWindow shop;
        int looked = 0;
        for (const char* id :
             {"verification", "polar", "certify", "settle", "byProperty", "floppy"}) {
            shop.selection.set({shop.document.scene().items.front().id});
            for (int i = 0;; ++i) {
                shop.run(id);
                QDialog* dialog = nullptr;
                for (auto* one : shop.window.findChildren<QDialog*>())
                    if (one->isVisible())
                        dialog = one;
                QVERIFY2(dialog, id);
                QVERIFY2(!dialog->isModal(), id);
                const auto fields = fieldsIn(*dialog);
                if (i >= fields.size()) {
                    dialog->close();
                    break;
                }
                const QString complaint = complaintAfter(shop, *fields[i], end);
                QVERIFY2(complaint.isEmpty(), qPrintable(id + (' ' + complaint)));
                ++looked;
            }
        }
        QVERIFY2(looked >= 4, qPrintable(QString::number(looked)));
    }

    // Fields that stand over the view: of tools, and of the ends of the colours.
    void fieldsOverTheView()
    {
        OpenWindow shop;
        shop.selection.set({shop.document.scene().items.front().id});
        for (const char* id : {"toolFan", "toolGrab", "toolPointer"}) {
            shop.run(id);
            for (const QPointer<QWidget>& field : fieldsIn(shop.viewport)) {
                const QString complaint = complaintAfter(shop, *field, Qt::Key_Return);
                QVERIFY2(complaint.isEmpty(), qPrintable(id + (' ' + complaint)));
            }
        }
    }

    void escapeTakesBackWhatWasTyped()
    {
        OpenWindow shop;
        ValueEdit& edit = number(shop);
        const QString before = edit.text();
        const std::vector<Id> selected = shop.selection.ids();
        const int steps = shop.document.history().index();
        edit.setFocus();
        QVERIFY(edit.hasFocus());
        edit.selectAll();
        QTest::keyClicks(&edit, "7");
        QCOMPARE(edit.text(), QString("7"));
        shop.type(Qt::Key_Escape);
        QCOMPARE(edit.text(), before);
        QCOMPARE(shop.document.history().index(), steps);
        QVERIFY(shop.viewport.hasFocus());
        QVERIFY(shop.selection.ids() == selected); // Escape was the field's
        shop.type(Qt::Key_Escape);
        QVERIFY(shop.selection.ids().empty()); // and now it is the scene's
    }

    // In the outline as in the view: the tool is left first, and then the selection.
    void escapeInTheOutlineLeavesTheTool()
    {
        OpenWindow shop;
        shop.run("selectAll");
        shop.run("toolBox");
        const std::vector<Id> selected = shop.selection.ids();
        QVERIFY(!selected.empty());
        auto* tree = shop.window.docks().panel<Outline>().findChild<QTreeView*>();
        QVERIFY(tree);
        tree->setFocus();
        QVERIFY(tree->hasFocus());
        shop.type(Qt::Key_Escape);
        QVERIFY(!shop.viewport.pointing().hasTool());
        QVERIFY(shop.window.actions()["toolPointer"]->isChecked());
        QVERIFY(shop.selection.ids() == selected);
        QVERIFY(tree->hasFocus());
        shop.type(Qt::Key_Escape);
        QVERIFY(shop.selection.ids().empty());
    }

    // It can be mended where it stands.
    void whatIsRefusedKeepsTheFocus()
    {
        OpenWindow shop;
        ValueEdit& edit = number(shop);
        edit.setFocus();
        edit.selectAll();
        QTest::keyClicks(&edit, "many");
        shop.type(Qt::Key_Return);
        QVERIFY(edit.hasFocus());
        QCOMPARE(edit.text(), QString("many"));
        edit.selectAll();
        QTest::keyClicks(&edit, "0.5");
        shop.type(Qt::Key_Return);
        QVERIFY(shop.viewport.hasFocus());
    }

    void enterBeginsALineInATextOfLines()
    {
        OpenWindow shop;
        shop.window.docks().show("inspector");
        shop.selection.set({settingsId});
        QTest::qWait(1);
        for (auto* notes : shop.window.findChildren<QPlainTextEdit*>()) {
            if (!notes->isVisible() || notes->isReadOnly())
                continue;
            notes->setFocus();
            const QString before = notes->toPlainText();
            shop.type(Qt::Key_Return);
            QVERIFY(notes->hasFocus());
            QCOMPARE(notes->toPlainText().size(), before.size() + 1);
            shop.type(Qt::Key_Return, Qt::ControlModifier);
            QVERIFY(shop.viewport.hasFocus());
        }
    }

    void aClickInTheViewGivesTheKeysBack()
    {
        OpenWindow shop;
        number(shop).setFocus();
        QTest::mouseClick(&shop.viewport, Qt::LeftButton, {},
                          QPoint(shop.viewport.width() / 2, shop.viewport.height() - 20));
        QVERIFY(shop.viewport.hasFocus());
    }

    void theTourEndsInTheView()
    {
        OpenWindow shop;
        shop.window.docks().show("outline");
        shop.run("tour");
        auto* tour = shop.window.findChild<Tour*>();
        QVERIFY(tour);
        QTest::keyClick(tour, Qt::Key_Escape);
        QTRY_VERIFY(!shop.window.findChild<Tour*>());
        QVERIFY(shop.viewport.hasFocus());
        shop.type(Qt::Key_Space);
        QVERIFY(shop.player.isPlaying());
    }

private:
    static void keysThatEnd()
    {
        QTest::addColumn<Qt::Key>("end");
        QTest::newRow("Enter") << Qt::Key_Return;
        QTest::newRow("Escape") << Qt::Key_Escape;
    }

    // A field of numbers in the inspector.
    static ValueEdit& number(OpenWindow& shop)
    {
        shop.window.docks().show("inspector");
        for (const Entry& entry : shop.document.scene().items)
            if (std::holds_alternative<Material>(entry.item)) {
                shop.selection.set({entry.id});
                break;
            }
        QTest::qWait(1);
        for (auto* edit : shop.window.findChildren<ValueEdit*>())
            if (edit->isVisible() && edit->isEnabled() && edit->text().toDouble() > 0.0)
                return *edit;
        qFatal("no number is shown");
    }
};

const RegisteredTest registered("test_keys_return", runWithView<TestKeysReturn>);

} // namespace ripstop::test_keys_return
#include "test_keys_return.moc"
