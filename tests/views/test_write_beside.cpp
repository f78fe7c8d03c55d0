// Pictures and other files that Qt writes by name come into their places whole or not at all
// (document/write_beside.h).
#include "document/write_beside.h"
#include "model/files.h"
#include "registered_test.h"

#include <QDir>
#include <QTemporaryDir>

namespace ripstop::test_write_beside {

class TestWriteBeside : public QObject
{
    Q_OBJECT

private slots:
    void takesThePlaceWhenItIsWhole()
    {
        const QTemporaryDir folder;
        const QString target = folder.filePath("réseau.png");
        write(target, "old");
        const bool done = writeBeside(target, [&](const QString& file) {
            write(file, "new");
            return contentOf(target) == "old" && file != target;
        });
        QVERIFY(done);
        QCOMPARE(contentOf(target), QByteArray("new"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
    }

    void aFailureLeavesTheOldOne()
    {
        const QTemporaryDir folder;
        const QString target = folder.filePath("view.png");
        write(target, "old");
        const bool done = writeBeside(target, [](const QString& file) {
            write(file, "hal");
            return false;
        });
        QVERIFY(!done);
        QCOMPARE(contentOf(target), QByteArray("old"));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
        QVERIFY(!writeBeside("/nowhere/view.png", [](const QString&) { return false; }));
    }
};

const RegisteredTest registered("test_write_beside", runWithCore<TestWriteBeside>);

} // namespace ripstop::test_write_beside
#include "test_write_beside.moc"
