// The dialog that maps a number of what is selected by a formula (dialogs/map_dialog.h).
//
// Stages: what it says while one types, one step of undo, and what is refused.
#include "dialogs/map_dialog.h"
#include "document/document.h"
#include "document/selection.h"
#include "scene/edit.h"
#include "views/run_with_widgets.h"
#include "views/small_scenes.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QtTest>

namespace ripstop::test_map_dialog {

namespace {

struct Desk
{
    Document document;
    Selection selection{document};

    Desk() { document.replace(oneOfEverything()); }

    double restLength(Id id) const
    {
        const auto ref = *find(document.scene(), id);
        return std::get<double>(propertyOf<&Link::restLength>().get(ref));
    }
};

} // namespace

class TestMapDialog : public QObject
{
    Q_OBJECT

private slots:
    // Links 5, 6 and 7 have their middles at x = 0.5, 0.5 and 0.
    void aMapIsOneStep()
    {
        Desk desk;
        desk.selection.set({Id{1}}); // the part stands for its elements
        MapDialog dialog(desk.document, desk.selection, nullptr);
        dialog.setNumber(propertyOf<&Link::restLength>());
        dialog.setFormula("1 + 2 * x");
        QCOMPARE(dialog.verdict(), QString("3 links: 1\u00a0m to 2\u00a0m"));
        dialog.accept();
        QCOMPARE(desk.restLength(Id{5}), 2.0);
        QCOMPARE(desk.restLength(Id{7}), 1.0);
        QCOMPARE(desk.document.history().count(), 1);
        desk.document.history().undo();
        QCOMPARE(desk.restLength(Id{5}), 1.0);
    }

    // The tear limit comes first, whose value a material that never tears does not give.
    void whatIsWrongIsSaid()
    {
        Desk desk;
        desk.selection.set({Id{5}});
        MapDialog dialog(desk.document, desk.selection, nullptr);
        const auto* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        QVERIFY(ok->isEnabled()); // what there is at first can be mapped
        dialog.setNumber(propertyOf<&Link::tearLimit>());
        QVERIFY(dialog.verdict().contains("never tears"));
        QVERIFY(!ok->isEnabled());
        dialog.setFormula("100 + x * q");
        QVERIFY2(dialog.verdict().contains("q"), qPrintable(dialog.verdict()));
        QVERIFY(!ok->isEnabled());
        QVERIFY2(!dialog.verdict().contains("probe"), qPrintable(dialog.verdict()));
        for (const char* endless : {"1 / 0", "1 / (y - y)", "sqrt(-1)"}) {
            dialog.setFormula(endless);
            QVERIFY2(dialog.verdict().contains("no finite number"), qPrintable(dialog.verdict()));
            QVERIFY(!ok->isEnabled());
        }
        dialog.setFormula("100 + y");
        QVERIFY(ok->isEnabled());
    }

    void nothingIsMappedWithoutASelection()
    {
        Desk desk;
        MapDialog dialog(desk.document, desk.selection, nullptr);
        QVERIFY(dialog.verdict().contains("Select"));
        dialog.accept();
        QCOMPARE(desk.document.history().count(), 0);
    }
};

const RegisteredTest registered("test_map_dialog", runWithWidgets<TestMapDialog>);

} // namespace ripstop::test_map_dialog
#include "test_map_dialog.moc"
