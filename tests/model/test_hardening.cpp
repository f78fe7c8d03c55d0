// The programs read files of strangers, and are linked so that a mistake in that is hard to use:
// position independent, with tables that are read-only once they run, and watched stacks and
// functions of the C library (CMakeLists.txt). readelf says whether a program is.
#include "model/files.h"
#include "registered_test.h"

#include <QFileInfo>
#include <QProcess>
#include <QtTest>

namespace ripstop::test_hardening {

class TestHardening : public QObject
{
    Q_OBJECT

private slots:
    void programsAreHardened_data()
    {
        QTest::addColumn<QString>("program");
        QTest::newRow("command line") << CLI_PROGRAM;
        QTest::newRow("reader of meshes") << MESH_READER_PROGRAM;
        if (QFileInfo::exists(EDITOR_PROGRAM))
            QTest::newRow("editor") << EDITOR_PROGRAM;
    }

    void programsAreHardened()
    {
        QFETCH(QString, program);
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("Sanitizers watch more than this, and do not go with it.");
#endif
        QProcess readelf;
        readelf.start("readelf",
                      {"--wide", "--program-headers", "--dynamic", "--dyn-syms", program});
        QVERIFY2(readelf.waitForStarted(), "readelf, which comes with each compiler, is missing");
        QVERIFY(readelf.waitForFinished(60000));
        const QByteArray said = readelf.readAllStandardOutput();
        QVERIFY2(said.contains("Elf file type is DYN"), "it is not position independent");
        QVERIFY2(said.contains("GNU_RELRO"), "its tables can be written");
        QVERIFY2(said.contains("BIND_NOW"), "functions are looked up late");
        QVERIFY2(said.contains("__stack_chk_fail"), "its stack is not watched");
        QVERIFY2(said.contains("_chk@"), "functions of the C library are not checked (FORTIFY)");
        const qsizetype stack = said.indexOf("GNU_STACK");
        QVERIFY(stack > 0);
        const QByteArray line = said.mid(stack, said.indexOf('\n', stack) - stack);
        QVERIFY2(!line.contains("RWE"), "its stack may be run");
    }
};

const RegisteredTest registered("test_hardening", runWithCore<TestHardening>);

} // namespace ripstop::test_hardening
#include "test_hardening.moc"
