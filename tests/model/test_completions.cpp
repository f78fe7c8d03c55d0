// Completion of commands by shells, tried in bash, which every machine of Ripstop's has: it is
// given the words of a line, the last of them unfinished, and told what it may become.
#include "model/cli_call.h"
#include "registered_test.h"

#include "builders/builder.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

namespace ripstop::test_completions {

class TestCompletions : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const Outcome said = call({"completions", "bash"});
        QCOMPARE(said.exitCode, 0);
        QFile script(m_folder.filePath("script"));
        QVERIFY(script.open(QIODevice::WriteOnly));
        script.write(said.out);
        QFile scene(m_folder.filePath("a kite.ripstop.json"));
        QVERIFY(scene.open(QIODevice::WriteOnly));
    }

    void bash_data()
    {
        QTest::addColumn<QStringList>("line");
        QTest::addColumn<QStringList>("completed");
        const auto row = [](const char* name, const QStringList& line, const QStringList& words) {
            QTest::newRow(name) << line << words;
        };
        row("a command", {"certi"}, {"certify"});
        row("a command of a command", {"study", "sta"}, {"status"});
        row("its option", {"study", "run", "--jo"}, {"--jobs"});
        row("an option", {"run", "--sec"}, {"--seconds"});
        row("no option of another command", {"info", "--sec"}, {});
        row("a number", {"run", "--seconds", ""}, {});
        row("a word that it may be", {"bench", "--race", "proj"}, {"projection"});
        row("a file with a space", {"run", "a"}, {"a kite.ripstop.json"});
        row("a file of an option", {"build", "rope", "-o", "a"}, {"a kite.ripstop.json"});
        row("a shell", {"completions", ""}, {"bash", "zsh", "fish"});
        row("nothing", {"there is no such"}, {});
        QStringList builders;
        for (const Builder& builder : allBuilders())
            builders << QString::fromUtf8(builder.name.data(), qsizetype(builder.name.size()));
        row("a builder", {"builders", ""}, builders);
    }
    void bash()
    {
        QFETCH(QStringList, line);
        QFETCH(QStringList, completed);
        QProcess shell;
        shell.setWorkingDirectory(m_folder.path());
        shell.start("bash", QStringList{"-c",
                                        "source ./script; COMP_WORDS=(ripstop-cli \"$@\"); "
                                        "COMP_CWORD=$#; _ripstop_cli; "
                                        "printf '%s\\n' \"${COMPREPLY[@]}\"",
                                        "bash"}
                                + line);
        QVERIFY(shell.waitForFinished());
        QCOMPARE(shell.readAllStandardError(), QByteArray());
        const QString said = QString::fromUtf8(shell.readAllStandardOutput());
        QCOMPARE(said.split('\n', Qt::SkipEmptyParts), completed);
    }

    // What the shells' scripts name is what the program has.
    void everyOptionIsNamed_data()
    {
        QTest::addColumn<QString>("shell");
        for (const char* shell : {"bash", "zsh", "fish"})
            QTest::newRow(shell) << QString(shell);
    }
    void everyOptionIsNamed()
    {
        QFETCH(QString, shell);
        const QByteArray script = call({"completions", shell}).out;
        for (const QByteArray& line : call({"--help-all"}).out.split('\n'))
            if (const QByteArray word = line.trimmed().split(' ').front(); word.startsWith("--"))
                QVERIFY2(script.contains(word.split(',').front().mid(2)), word.constData());
    }

private:
    QTemporaryDir m_folder;
};

const RegisteredTest registered("test_completions", runPlain<TestCompletions>);

} // namespace ripstop::test_completions
#include "test_completions.moc"
