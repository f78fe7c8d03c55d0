// The dialog that compares designs: it begins with what was changed since the file was saved,
// follows edits, takes another file, and selects what a row tells of.
#include "app/sheet_shop.h"

#include "dialogs/design_difference_dialog.h"
#include "io/scene_file.h"
#include "scene/path.h"

#include <QListWidget>
#include <QTemporaryDir>

namespace ripstop::test_design_difference {

class TestDesignDifference : public QObject
{
    Q_OBJECT

private slots:
    void showsWhatWasChanged()
    {
        const QTemporaryDir folder;
        const QString saved = folder.filePath("saved.ripstop.json");
        Shop shop(Sheet().scene);
        QVERIFY(!shop.document.save(saved));
        DesignDifferenceDialog dialog(shop.document, shop.selection, shop.window.viewport(),
                                      &shop.window);
        dialog.show();
        QCOMPARE(dialog.verdict(), QString("The two say the same."));

        const Id particle = Sheet::at(3, 2);
        const std::string path = "#" + std::to_string(std::uint32_t(particle)) + ".mass=2";
        shop.document.push(*assignment(shop.document.scene(), path));
        QTRY_COMPARE(dialog.verdict(), QString("They differ in 1 thing."));
        auto* list = dialog.findChild<QListWidget*>();
        QVERIFY2(list->item(0)->text().contains("Mass"), qPrintable(list->item(0)->text()));
        list->setCurrentRow(0);
        QCOMPARE(shop.selection.ids(), std::vector<Id>{particle});

        shop.document.history().undo();
        QTRY_COMPARE(dialog.verdict(), QString("The two say the same."));
        QVERIFY(!dialog.compareWith(folder.filePath("missing.ripstop.json")));
        QCOMPARE(dialog.verdict(), QString("There is nothing to compare with."));
    }
};

const RegisteredTest registered("test_design_difference", runWithView<TestDesignDifference>);

} // namespace ripstop::test_design_difference
#include "test_design_difference.moc"
