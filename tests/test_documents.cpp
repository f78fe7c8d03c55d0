// The pages that people read: every path, task of ./dev and command of ripstop-cli that they name
// exists, so that a page cannot go on about a tree that has moved; and all say the same version.
#include "registered_test.h"

#include <QtTest>

#include <QDirIterator>
#include <QRegularExpression>

namespace ripstop::test_documents {

// A word of a page that is to be looked up, and where it stands.
struct Named
{
    QString word;
    int line; // from 1
};

static QString textOf(const QString& file)
{
    QFile page(file);
    return page.open(QIODevice::ReadOnly) ? QString::fromUtf8(page.readAll()) : QString();
}

static QString inTree(const QString& path) { return QStringLiteral(SOURCE_DIR "/") + path; }

static QStringList pages()
{
    QStringList found{"README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "scenes/README.md"};
    for (const QString& name : QDir(inTree("docs")).entryList({"*.md"}, QDir::Files, QDir::Name))
        found << "docs/" + name;
    return found;
}

static QList<Named> matchesIn(const QString& text, const QRegularExpression& pattern)
{
    QList<Named> found;
    auto matches = pattern.globalMatch(text);
    while (matches.hasNext()) {
        const auto match = matches.next();
        found.append({match.captured(1), int(text.left(match.capturedStart()).count('\n')) + 1});
    }
    return found;
}

// Targets of links and pictures; those that lead out of the tree are left out.
static QList<Named> linksIn(const QString& text)
{
    static const QRegularExpression link(R"(\]\(([^)\s]+)\))");
    QList<Named> found;
    for (const Named& named : matchesIn(text, link))
        if (!named.word.contains("://") && !named.word.startsWith('#'))
            found.append({named.word.section('#', 0, 0), named.line});
    return found;
}

// Whether a word is the path of a file or folder of the tree, rather than an example that a reader
// makes, or a header of a library.
static bool isOfTree(const QString& word)
{
    static const QRegularExpression path(R"(^[\w*][\w.*/-]*$)");
    static const QRegularExpression source(R"(\.(md|h|cpp|inl|json|txt|ts)$)");
    static const QStringList folders =
        QDir(SOURCE_DIR).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    static const QStringList made{"build", "out"}; // by ./dev
    if (!path.match(word).hasMatch() || word.contains("NAME") || word.contains(".."))
        return false;
    const QString first = word.section('/', 0, 0);
    if (word.contains('/') && folders.contains(first) && !made.contains(first))
        return true;
    // names without a folder: pages and sources are ours, figures and scenes may be the reader's
    return source.match(word).hasMatch() && !made.contains(first)
           && !word.endsWith(".ripstop.json");
}

static QList<Named> inBackticks(const QString& text)
{
    static const QRegularExpression ticks("`([^`\\n]+)`");
    return matchesIn(text, ticks);
}

static QList<Named> indentedLines(const QString& text)
{
    static const QRegularExpression indented("^    (\\S[^\\n]*)$",
                                             QRegularExpression::MultilineOption);
    return matchesIn(text, indented);
}

// Paths in backticks, and with a folder in indented lines; of a command line, each word.
static QList<Named> pathsIn(const QString& text)
{
    QList<Named> found;
    const auto take = [&](const QList<Named>& lines, bool withFolder) {
        for (const Named& line : lines)
            for (const QString& word : line.word.split(' ', Qt::SkipEmptyParts))
                if (isOfTree(word) && (!withFolder || word.contains('/')))
                    found.append({word, line.line});
    };
    take(inBackticks(text), false);
    take(indentedLines(text), true);
    return found;
}

// A path may have * for any part of a name, and then stands for one file at least.
static bool exists(const QString& path)
{
    if (!path.contains('*'))
        return QFileInfo::exists(path);
    const QRegularExpression wanted(
        QRegularExpression::wildcardToRegularExpression(QFileInfo(path).fileName()));
    QDirIterator files(QFileInfo(path).path(), QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext())
        if (wanted.match(QFileInfo(files.next()).fileName()).hasMatch())
            return true;
    return false;
}

// From the root of the tree, or beside the page.
static bool isThere(const QString& page, const QString& path)
{
    return exists(inTree(path)) || exists(QFileInfo(inTree(page)).path() + '/' + path);
}

// Tasks that the script tells apart, "run | test | build".
static QStringList tasksOf(const QString& script)
{
    static const QRegularExpression branch("^([\\w| -]+)\\)\\s+(?:\"task_|help)",
                                           QRegularExpression::MultilineOption);
    QStringList tasks;
    for (const Named& named : matchesIn(script, branch))
        for (const QString& task : named.word.split('|'))
            tasks << task.trimmed();
    return tasks;
}

// What the program says that it can do: the words that begin the lines below "Subcommands:".
static QStringList commandsOf(const QString& help)
{
    static const QRegularExpression name(R"(^  ([a-z]+) )", QRegularExpression::MultilineOption);
    QStringList commands;
    for (const Named& named :
         matchesIn(help.section("Subcommands:", 1).section("\n\n", 0, 0), name))
        commands << named.word;
    return commands;
}

class TestDocuments : public QObject
{
    Q_OBJECT

private slots:
    // What is named is found, and what is gone is seen to be gone.
    void looksAtWhatPagesSay()
    {
        const QString page("See `model/sim/stepper.h`, `gone.cpp`, `out/flight.png`, `a.b`,\n"
                           "`model/forces/NAME.cpp`, [a page](gone.md#part), [out](https://a.b)\n"
                           "`cat docs/gone.md` and `*_kernel.inl`.\n\n"
                           "    scripts/gone kite.h\n");
        QStringList paths;
        for (const Named& named : pathsIn(page))
            paths << named.word;
        QCOMPARE(paths, (QStringList{"model/sim/stepper.h", "gone.cpp", "docs/gone.md",
                                     "*_kernel.inl", "scripts/gone"}));
        QCOMPARE(linksIn(page).size(), 1);
        QCOMPARE(linksIn(page)[0].word, QString("gone.md"));
        QCOMPARE(linksIn(page)[0].line, 2);
        for (const QString& path : paths.mid(0, 3))
            QVERIFY2(!isThere("docs/air.md", path), qPrintable(path));
        QVERIFY(isThere("docs/air.md", "contact.md"));
        QVERIFY(isThere("README.md", "*_kernel.inl"));
        QVERIFY(!isThere("README.md", "model/forces/*_colonel.inl"));
        QCOMPARE(tasksOf("case $task in\nrun | test) \"task_$task\" \"$@\" ;;\nhelp) help ;;\n"),
                 (QStringList{"run", "test", "help"}));
        QCOMPARE(
            commandsOf("Options:\n  -h  x\n\nSubcommands:\n  info   Count\n  run   Fly\n\n  no  "),
            (QStringList{"info", "run"}));
    }

    void paths_data() { eachPage(); }
    void paths()
    {
        QFETCH(QString, page);
        const QString text = textOf(inTree(page));
        QVERIFY(!text.isEmpty());
        for (const Named& named : pathsIn(text))
            QVERIFY2(isThere(page, named.word), qPrintable(where(page, named)));
    }

    void links_data() { eachPage(); }
    void links()
    {
        QFETCH(QString, page);
        for (const Named& named : linksIn(textOf(inTree(page))))
            QVERIFY2(exists(QFileInfo(inTree(page)).path() + '/' + named.word),
                     qPrintable(where(page, named)));
    }

    // A page that nobody links is a page that nobody finds.
    void pagesAreLinked()
    {
        QStringList linked;
        for (const Named& named : linksIn(textOf(inTree("README.md"))))
            linked << named.word;
        for (const Named& named : linksIn(textOf(inTree("ARCHITECTURE.md"))))
            linked << named.word;
        for (const QString& page : pages())
            QVERIFY2(page == "README.md" || linked.contains(page), qPrintable(page));
    }

    // The book has every page, in an order that somebody has thought of.
    void pagesAreInTheBook()
    {
        const QString contents = textOf(inTree("resources/manual/mkdocs.yml"));
        for (const QString& page : pages())
            QVERIFY2(contents.contains(": " + page + '\n'), qPrintable(page));
    }

    // The version stands in CMakeLists.txt; programs have it from there. What people cite, and the
    // newest heading of the changelog, have it with its day.
    void allSayTheSameVersion()
    {
        const auto firstIn = [](const char* file, const char* pattern) {
            const QRegularExpression line(pattern, QRegularExpression::MultilineOption);
            const auto found = matchesIn(textOf(inTree(file)), line);
            return found.isEmpty() ? QString() : found.front().word;
        };
        const QString version = firstIn("CMakeLists.txt", R"(^project\(Ripstop VERSION ([\d.]+))");
        QVERIFY(!version.isEmpty());
        QCOMPARE(firstIn("CITATION.cff", R"(^version: (\S+)$)"), version);
        const QString day = firstIn("CITATION.cff", R"(^date-released: (\S+)$)");
        QCOMPARE(firstIn("CHANGELOG.md", "^## (.+)$"), version + ", " + day);
        QProcess program;
        program.start(CLI_PROGRAM, {"--version"});
        QVERIFY(program.waitForFinished());
        QVERIFY(program.readAllStandardOutput().contains(version.toUtf8()));
    }

    void tasks_data() { eachPage(); }
    void tasks()
    {
        QFETCH(QString, page);
        static const QRegularExpression task(R"(\./dev\s+([a-z]+))");
        const QStringList known = tasksOf(textOf(inTree("dev")));
        QVERIFY(known.contains("test") && known.contains("help"));
        for (const Named& named : matchesIn(textOf(inTree(page)), task))
            QVERIFY2(known.contains(named.word), qPrintable(where(page, named)));
    }

    void commands_data() { eachPage(); }
    void commands()
    {
        QFETCH(QString, page);
        static const QRegularExpression command(R"(ripstop-cli\s+([a-z]+)\b)");
        const QStringList known = knownCommands();
        QVERIFY(known.contains("run") && known.contains("verify"));
        const QString text = textOf(inTree(page));
        for (const Named& line : inBackticks(text) + indentedLines(text))
            for (const Named& named : matchesIn(line.word, command))
                QVERIFY2(known.contains(named.word),
                         qPrintable(where(page, {named.word, line.line})));
    }

private:
    static void eachPage()
    {
        QTest::addColumn<QString>("page");
        for (const QString& page : pages())
            QTest::newRow(qPrintable(page)) << page;
    }

    static QString where(const QString& page, const Named& named)
    {
        return QString("%1:%2: there is no \"%3\"").arg(page).arg(named.line).arg(named.word);
    }

    static const QStringList& knownCommands()
    {
        static const QStringList known = [] {
            QProcess program;
            program.start(CLI_PROGRAM, {"--help"});
            program.waitForFinished();
            return commandsOf(QString::fromUtf8(program.readAllStandardOutput()));
        }();
        return known;
    }
};

const RegisteredTest registered("test_documents", runWithCore<TestDocuments>);

} // namespace ripstop::test_documents
#include "test_documents.moc"
