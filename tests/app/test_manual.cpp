// F1: every row of the table leads to a page and a heading that exist, every dock, dialog and kind
// has one, and what is under the mouse or has the keys decides which page is opened.
#include "app/window_shop.h"
#include "docks/dock_table.h"
#include "manual/manual.h"
#include "registered_test.h"
#include "scene/property.h"

#include <QDialog>
#include <QDirIterator>
#include <QLabel>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include <set>

namespace ripstop::test_manual {

namespace {

QString contentOf(const QString& file)
{
    QFile page(file);
    return page.open(QIODevice::ReadOnly) ? QString::fromUtf8(page.readAll()) : QString();
}

// As links name headings: small letters, no punctuation, hyphens for blanks.
QStringList anchorsOf(const QString& page)
{
    static const QRegularExpression heading("^#+ (.*)$", QRegularExpression::MultilineOption);
    static const QRegularExpression other("[^\\w\\s-]",
                                          QRegularExpression::UseUnicodePropertiesOption);
    static const QRegularExpression blanks("[-\\s]+");
    QStringList anchors{""};
    auto matches = heading.globalMatch(page);
    while (matches.hasNext())
        anchors << matches.next().captured(1).toLower().remove(other).trimmed().replace(blanks,
                                                                                        "-");
    return anchors;
}

bool isKnown(const QString& name)
{
    return std::ranges::any_of(manualTable(), [&](const ManualRow& row) { return name == row.of; });
}

void touchFile(const QString& path)
{
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
}

} // namespace

class TestManual : public QObject
{
    Q_OBJECT

private slots:
    void everyTargetExists()
    {
        std::set<QString> names;
        for (const ManualRow& row : manualTable()) {
            QVERIFY2(names.insert(row.of).second, row.of);
            const QString page = contentOf(QString(SOURCE_DIR "/%1.md").arg(row.page));
            QVERIFY2(!page.isEmpty(), row.page);
            QVERIFY2(anchorsOf(page).contains(row.anchor),
                     qPrintable(QString("%1#%2").arg(row.page, row.anchor)));
        }
    }

    // A dock, dialog or kind that somebody adds asks for its row here.
    void everythingHasARow()
    {
        for (const DockRow& dock : dockTable())
            QVERIFY2(isKnown(dock.id), qPrintable(QString(dock.id)));
        for (int kind = 0; kind < kindCount; ++kind) {
            const QString name =
                "property " + QString::fromStdString(std::string(kindName(Kind(kind))));
            QVERIFY2(isKnown(name), qPrintable(name));
        }
        static const QRegularExpression dialog("class (\\w+) final : public QDialog");
        for (const char* folder : {"/app", "/views"}) {
            QDirIterator headers(QString(SOURCE_DIR) + folder, {"*.h"}, QDir::Files,
                                 QDirIterator::Subdirectories);
            while (headers.hasNext()) {
                const auto match = dialog.match(contentOf(headers.next()));
                QVERIFY2(!match.hasMatch() || isKnown(match.captured(1)),
                         qPrintable(match.captured(1)));
            }
        }
    }

    // Rows of properties are of fields that exist.
    void propertiesExist()
    {
        for (const ManualRow& row : manualTable()) {
            const QString name = row.of;
            if (!name.startsWith("property ") || !name.contains('.'))
                continue;
            const auto kind = kindFromName(name.mid(9).section('.', 0, 0).toStdString());
            QVERIFY2(kind && findProperty(*kind, name.section('.', 1).toStdString()), row.of);
        }
    }

    void whatIsLookedAtDecides()
    {
        WindowShop shop;
        QCOMPARE(manualPageFor(&shop.viewport).page, QString("docs/selecting"));
        const auto docks = shop.window.findChildren<QDockWidget*>();
        for (const QDockWidget* dock : docks)
            if (dock->objectName() == "study")
                QCOMPARE(manualPageFor(dock->widget()).anchor, QString("in-the-window"));
        QLabel porosity, skin;
        porosity.setObjectName("property material.porosity");
        skin.setObjectName("property material.color");
        QCOMPARE(manualPageFor(&porosity).anchor, QString("porosity"));
        QCOMPARE(manualPageFor(&skin).page, QString("resources/help/properties"));
        QCOMPARE(manualPageFor(&skin).anchor, QString("material"));
        QCOMPARE(manualPageFor(nullptr).page, QString("docs/editor"));
    }

    // In the inspector, each property has the name of its row.
    void inspectorNamesProperties()
    {
        WindowShop shop;
        Scene scene;
        scene.items = {{Id{1}, Material{}}};
        scene.nextId = Id{2};
        shop.document.replace(scene, "cloth");
        shop.window.showScene();
        shop.window.show();
        shop.selection.set({Id{1}});
        QTRY_VERIFY(shop.window.findChild<QLabel*>("property material.porosity"));
    }

    // The book of an installed program, then that of the build, then the page, then a sentence.
    void bookPageOrSentence()
    {
        const QTemporaryDir folder;
        const QString programs = folder.filePath("build/release/bin");
        QVERIFY(QDir().mkpath(programs));
        QList<QUrl> opened;
        QStringList said;
        Manual manual(
            programs,
            [&](const QUrl& url) {
                opened << url;
                return true;
            },
            nullptr);
        connect(&manual, &Manual::said, this, [&](const QString& what) { said << what; });
        const ManualPage page{"docs/tuning", "sliders"};

        manual.show(page);
        QCOMPARE(opened.size(), 0);
        QVERIFY(said.value(0).contains("docs/tuning.md"));

        touchFile(folder.filePath("docs/tuning.md"));
        manual.show(page);
        QVERIFY(opened.value(0).path().endsWith("/docs/tuning.md"));

        touchFile(folder.filePath("build/release/manual/docs/tuning.html"));
        QVERIFY(manual.addressOf(page).toString().endsWith("/manual/docs/tuning.html#sliders"));
        manual.show(page); // by a page that leads on, as desktops drop what is after the #
        QVERIFY(contentOf(opened.value(1).toLocalFile()).contains("/docs/tuning.html#sliders\""));

        touchFile(folder.filePath("build/release/share/doc/ripstop/manual/docs/tuning.html"));
        QVERIFY(
            manual.addressOf(page).path().endsWith("share/doc/ripstop/manual/docs/tuning.html"));
    }

    // In a dialog, F1 is no key of the menus.
    void inDialogs()
    {
        QList<QUrl> opened;
        const QTemporaryDir folder;
        touchFile(folder.filePath("a/docs/editor.md"));
        QVERIFY(QDir().mkpath(folder.filePath("a/build/release/bin")));
        Manual manual(
            folder.filePath("a/build/release/bin"),
            [&](const QUrl& url) {
                opened << url;
                return true;
            },
            nullptr);
        QDialog dialog;
        dialog.show();
        QTest::keyClick(&dialog, Qt::Key_F1);
        QCOMPARE(opened.size(), 1);
    }
};

const RegisteredTest registered("test_manual", runWithView<TestManual>);

} // namespace ripstop::test_manual
#include "test_manual.moc"
