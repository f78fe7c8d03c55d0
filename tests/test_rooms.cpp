// The plan of the house: who may include whom, and what stays out of which room. The rooms
// themselves are said in rooms.txt.
//
// Stages: folders against rooms.txt; includes of every file against what its room may include;
// types and nouns, of which each has one place; then the lengths of files, and habits that are not
// wanted, found by patterns.
#include "registered_test.h"

#include <QtTest>

#include <QDirIterator>
#include <QRegularExpression>

#include <algorithm>
#include <array>

namespace ripstop::test_rooms {

// A line of rooms.txt.
struct Room
{
    QString path;
    QStringList rooms;
    QStringList libraries;
    QStringList hidden; // libraries, in sources only

    QString name() const { return path.section('/', 1); }
};

// What some rooms never see, directly or through others.
struct Walls
{
    QStringList on;     // paths of rooms, with * for any
    QStringList behind; // names of rooms
};

struct Plan
{
    QList<Room> rooms;
    Walls walls;
};

// Lines that a file may have at most, where that is less than usual.
struct Limit
{
    const char* file;
    int lines;
};

constexpr int usualLimit = 500;
constexpr std::array<Limit, 1> limits{{
    {"app/editor/main_window.cpp", 300}, // it would be the first to become a list of all there is
}};

struct Include
{
    QString header;
    bool isOurs; // in quotes
};

static QString relative(const QString& file) { return file.mid(int(strlen(SOURCE_DIR)) + 1); }

static QStringList sourcesUnder(const QString& folder)
{
    QStringList files;
    QDirIterator found(QStringLiteral(SOURCE_DIR "/") + folder, {"*.h", "*.cpp", "*.inl"},
                       QDir::Files, QDirIterator::Subdirectories);
    while (found.hasNext())
        files << found.next();
    files.sort();
    return files;
}

static QStringList foldersUnder(const QString& folder)
{
    QStringList paths;
    const QDir root(QStringLiteral(SOURCE_DIR "/") + folder);
    for (const QString& name : root.entryList(QDir::Dirs | QDir::NoDotAndDotDot))
        paths << folder + '/' + name;
    return paths;
}

static QString textOf(const QString& file)
{
    QFile source(file);
    return source.open(QIODevice::ReadOnly) ? QString::fromUtf8(source.readAll()) : QString();
}

static QStringList words(const QString& text)
{
    return text.simplified().split(' ', Qt::SkipEmptyParts);
}

static Plan readPlan()
{
    Plan plan;
    for (const QString& line : textOf(SOURCE_DIR "/tests/rooms.txt").split('\n')) {
        if (line.startsWith('#') || line.trimmed().isEmpty())
            continue;
        const QStringList columns = line.split(':');
        if (columns.first().trimmed() == "walls")
            plan.walls = {words(columns.value(1)), words(columns.value(2))};
        else
            plan.rooms.append({columns.first().trimmed(), words(columns.value(1)),
                               words(columns.value(2)), words(columns.value(3))});
    }
    return plan;
}

static const Plan& plan()
{
    static const Plan read = readPlan();
    return read;
}

static QList<Include> includesOf(const QString& file)
{
    static const QRegularExpression include("^\\s*#\\s*include\\s+([<\"])([^>\"]+)[>\"]",
                                            QRegularExpression::MultilineOption);
    QList<Include> found;
    auto matches = include.globalMatch(textOf(file));
    while (matches.hasNext()) {
        const auto match = matches.next();
        found.append({match.captured(2), match.captured(1) == "\""});
    }
    return found;
}

// Where a header of ours stands; empty for one that is made by the build.
static QString fileOf(const QString& header)
{
    for (const char* top : {"model/", "views/", "app/"}) {
        const QString file = QStringLiteral(SOURCE_DIR "/") + top + header;
        if (QFile::exists(file))
            return file;
    }
    return {};
}

// The headers of ours that a header brings along, itself included, each with the one before it on
// the way there.
using Reached = QMap<QString, QString>;

static const Reached& reachedFrom(const QString& header)
{
    static QHash<QString, Reached> known;
    const auto found = known.constFind(header);
    if (found != known.constEnd())
        return *found;
    Reached reached;
    QStringList open{header};
    reached[header] = QString();
    while (!open.isEmpty()) {
        const QString next = open.takeFirst();
        for (const Include& include : includesOf(fileOf(next)))
            if (include.isOurs && !reached.contains(include.header)
                && !fileOf(include.header).isEmpty()) {
                reached[include.header] = next;
                open << include.header;
            }
    }
    return *known.insert(header, reached);
}

static QString wayTo(const QString& header, const Reached& reached)
{
    QStringList way;
    for (QString at = header; !at.isEmpty(); at = reached[at])
        way.prepend(at);
    return way.join(" -> ");
}

static QString nounOf(const QString& header) { return header.section('.', 0, 0); }

// The nouns of a room, each with those of the same room that it includes.
static QMap<QString, QStringList> nounsOf(const QString& room)
{
    QMap<QString, QStringList> nouns;
    const QString name = room.section('/', 1);
    for (const QString& file : sourcesUnder(room)) {
        const QString noun = nounOf(relative(file).section('/', 1));
        QStringList& others = nouns[noun];
        for (const Include& include : includesOf(file))
            if (const QString other = nounOf(include.header);
                include.header.startsWith(name + '/') && other != noun && !others.contains(other))
                others << other;
    }
    return nouns;
}

// The way from a noun by others back to it; it is empty when there is none.
static QString wayBack(const QString& noun, const QMap<QString, QStringList>& nouns)
{
    Reached reached;
    QStringList open{noun};
    while (!open.isEmpty()) {
        const QString next = open.takeFirst();
        for (const QString& other : nouns[next]) {
            if (other == noun)
                return noun + " -> " + wayTo(next, reached) + " -> " + noun;
            if (!reached.contains(other)) {
                reached[other] = next == noun ? QString() : next;
                open << other;
            }
        }
    }
    return {};
}

// A source without comments, texts and lines of the preprocessor.
static QString codeOf(const QString& file)
{
    static const QRegularExpression raw(R"re(R"(\w*)\(.*?\)\1")re",
                                        QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression comment(R"re(//[^\n]*|/\*.*?\*/)re",
                                            QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression text(R"re("(\\.|[^"\\\n])*"|'(\\.|[^'\\\n])')re");
    static const QRegularExpression directive(R"re(^\s*#[^\n]*(\\\n[^\n]*)*)re",
                                              QRegularExpression::MultilineOption);
    return textOf(file).remove(raw).remove(comment).remove(text).remove(directive);
}

// Types of a namespace with a name, as "ripstop::System". Those of a nameless one are the file's
// own, and those within a type are told apart by it.
static QStringList typesDefinedIn(const QString& file)
{
    static const QRegularExpression space(R"(\bnamespace\b\s*([\w:]*)\s*$)");
    static const QRegularExpression type(
        R"(\b(?:struct|class|union|enum)\s+(?:alignas\([^)]*\)\s*)?(\w+)\s*(?:final)?\s*(?::[^:].*)?$)",
        QRegularExpression::DotMatchesEverythingOption);
    QStringList types;
    QStringList open; // namespaces; "{" for anything else, and for a nameless one
    const QString code = codeOf(file);
    qsizetype last = 0;
    for (qsizetype i = 0; i < code.size(); ++i) {
        const QChar c = code[i];
        if (c != '{' && c != '}' && c != ';')
            continue;
        const QString head = code.mid(last, i - last);
        last = i + 1;
        if (c == '}' && !open.isEmpty())
            open.removeLast();
        if (c != '{')
            continue;
        const auto inSpace = space.match(head);
        const auto isType = type.match(head);
        if (isType.hasMatch() && !open.isEmpty() && !open.contains("{"))
            types << open.join("::") + "::" + isType.captured(1);
        const QString name = inSpace.captured(1);
        open << (name.isEmpty() ? QStringLiteral("{") : name);
    }
    return types;
}

class TestRooms : public QObject
{
    Q_OBJECT

private slots:
    // A new folder must be given its place in rooms.txt.
    void everyFolderIsARoom()
    {
        QStringList paths;
        for (const Room& room : plan().rooms)
            paths << room.path;
        for (const char* top : {"model", "views", "app"})
            for (const QString& folder : foldersUnder(top))
                QVERIFY2(paths.contains(folder), qPrintable(folder + " is not in rooms.txt"));
        for (const QString& path : paths)
            QVERIFY2(QDir(QStringLiteral(SOURCE_DIR "/") + path).exists(), qPrintable(path));
    }

    // A room may include those above it, so that there are no circles.
    void arrowsGoOneWay()
    {
        QStringList above;
        for (const Room& room : plan().rooms) {
            for (const QString& other : room.rooms)
                QVERIFY2(above.contains(other),
                         qPrintable(room.path + " names " + other + ", which is not above it"));
            above << room.name();
        }
    }

    // What a line allows and nobody uses hides the day on which somebody does.
    void nothingIsAllowedInVain()
    {
        for (const Room& room : plan().rooms) {
            QSet<QString> used;
            for (const QString& file : sourcesUnder(room.path))
                for (const Include& include : includesOf(file))
                    used << include.header.section('/', 0, 0);
            for (const QString& other : room.rooms)
                QVERIFY2(used.contains(other),
                         qPrintable(room.path + " may include " + other + " and does not"));
        }
    }

    void includes_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("room");
        for (int i = 0; i < plan().rooms.size(); ++i)
            for (const QString& file : sourcesUnder(plan().rooms[i].path))
                QTest::newRow(qPrintable(relative(file))) << file << i;
    }

    void includes()
    {
        QFETCH(QString, file);
        QFETCH(int, room);
        const Room place = plan().rooms[room];

        QStringList libraries = place.libraries;
        if (file.endsWith(".cpp"))
            libraries += place.hidden;

        for (const auto& [header, isOurs] : includesOf(file)) {
            if (isOurs) {
                const QString target = header.section('/', 0, 0);
                const bool ownMoc = header == QFileInfo(file).completeBaseName() + ".moc";
                QVERIFY2(
                    ownMoc || target == place.name() || place.rooms.contains(target),
                    qPrintable(header + " is of a room that " + place.path + " may not look into"));
            } else if (header.contains('.') || header.contains('/') || header[0].isUpper()) {
                // not the standard library
                QVERIFY2(std::any_of(libraries.begin(), libraries.end(),
                                     [&, header = header](const QString& p) {
                                         return header.startsWith(p);
                                     }),
                         qPrintable(header + " is of a library that " + place.path
                                    + " may not use here"));
            }
        }
    }

    // Nothing of the window sees the machinery of the engine, through however many headers.
    void walls_data()
    {
        QTest::addColumn<QString>("file");
        const QStringList& on = plan().walls.on;
        for (const Room& room : plan().rooms)
            if (on.contains(room.path) || on.contains(room.path.section('/', 0, 0) + "/*"))
                for (const QString& file : sourcesUnder(room.path))
                    QTest::newRow(qPrintable(relative(file))) << file;
    }

    void walls()
    {
        QFETCH(QString, file);
        for (const Include& include : includesOf(file)) {
            if (!include.isOurs || fileOf(include.header).isEmpty())
                continue;
            const Reached& reached = reachedFrom(include.header);
            for (auto it = reached.begin(); it != reached.end(); ++it)
                QVERIFY2(!plan().walls.behind.contains(it.key().section('/', 0, 0)),
                         qPrintable("sees " + wayTo(it.key(), reached)));
        }
    }

    // Neither of two headers could be read first.
    void noHeadersIncludeEachOther_data()
    {
        QTest::addColumn<QString>("file");
        for (const char* top : {"model", "views", "app"})
            for (const QString& file : sourcesUnder(top))
                if (!file.endsWith(".cpp"))
                    QTest::newRow(qPrintable(relative(file))) << file;
    }

    void noHeadersIncludeEachOther()
    {
        QFETCH(QString, file);
        const QString header = relative(file).section('/', 1);
        for (const Include& include : includesOf(file)) {
            if (!include.isOurs || fileOf(include.header).isEmpty())
                continue;
            const Reached& reached = reachedFrom(include.header);
            QVERIFY2(!reached.contains(header),
                     qPrintable("includes itself by " + wayTo(header, reached)));
        }
    }

    // A header and its source are one noun. Where two nouns include each other, none of them can be
    // understood or moved alone. In the rooms of the window there are none; the others are to
    // follow.
    void nounsGoOneWay_data()
    {
        QTest::addColumn<QString>("room");
        for (const QString& path : foldersUnder("app"))
            QTest::newRow(qPrintable(path)) << path;
    }

    void nounsGoOneWay()
    {
        QFETCH(QString, room);
        const QMap<QString, QStringList> nouns = nounsOf(room);
        QVERIFY(!nouns.isEmpty());
        for (auto it = nouns.begin(); it != nouns.end(); ++it) {
            const QString way = wayBack(it.key(), nouns);
            QVERIFY2(way.isEmpty(), qPrintable(way));
        }
    }

    // Two types of one name in one namespace compile and link, and are undefined behaviour.
    void everyTypeIsDefinedOnce()
    {
        QMap<QString, QStringList> places;
        for (const char* top : {"model", "views", "app", "tests"})
            for (const QString& file : sourcesUnder(top))
                for (const QString& type : typesDefinedIn(file))
                    places[type] << relative(file);
        QVERIFY2(places.contains("ripstop::System") && places.contains("ripstop::Integrator"),
                 "the sources are not understood");
        for (auto it = places.begin(); it != places.end(); ++it)
            QVERIFY2(it->size() == 1,
                     qPrintable(it.key() + " is defined in " + it->join(" and in ")));
    }

    // A header says what it is for before it says anything else, and a long source its stages.
    void sourcesOpenLikeAPage()
    {
        constexpr qsizetype longSource = 100; // lines
        for (const char* top : {"model", "views", "app", "tests"})
            for (const QString& file : sourcesUnder(top)) {
                const QString text = textOf(file);
                const bool isHeader = file.endsWith(".h");
                if (isHeader || (file.endsWith(".cpp") && text.count('\n') > longSource))
                    QVERIFY2(text.startsWith("//"), qPrintable(relative(file)));
            }
    }

    void filesAreShort_data()
    {
        everySource();
        for (const Limit& limit : limits)
            QVERIFY2(QFile::exists(QStringLiteral(SOURCE_DIR "/") + limit.file), limit.file);
    }

    void filesAreShort()
    {
        QFETCH(QString, file);
        const auto own = std::ranges::find_if(
            limits, [&](const Limit& limit) { return relative(file) == limit.file; });
        const int limit = own == limits.end() ? usualLimit : own->lines;
        const auto lines = textOf(file).count('\n');
        QVERIFY2(lines <= limit,
                 qPrintable(QString("%1 lines; the limit is %2").arg(lines).arg(limit)));
    }

    void habits_data()
    {
        QTest::addColumn<QString>("pattern");
        QTest::addColumn<QString>("instead");
        // clang-format off
        QTest::newRow("no singletons")         << R"((?<!QCoreApplication::)(?<!QApplication::)\binstance\(\))" << "pass a reference from main()";
        QTest::newRow("no search by name")     << R"(\bfind(Child|Children)\s*[<(])"                            << "keep the pointer";
        QTest::newRow("no guess at the sender") << R"(\bsender\(\))"                                            << "capture it in a lambda with a context";
        // clang-format on
    }

    void habits()
    {
        QFETCH(QString, pattern);
        QFETCH(QString, instead);
        const QRegularExpression expression(pattern, QRegularExpression::MultilineOption);
        for (const char* top : {"model", "views", "app"})
            for (const QString& file : sourcesUnder(top)) {
                const auto match = expression.match(textOf(file));
                QVERIFY2(!match.hasMatch(),
                         qPrintable(relative(file) + ": " + match.captured() + "; " + instead));
            }
    }

    void headersKeepToTheirNames()
    {
        for (const char* top : {"model", "views", "app"})
            for (const QString& file : sourcesUnder(top))
                if (file.endsWith(".h")) {
                    const QString text = textOf(file);
                    QVERIFY2(!text.contains("using namespace"), qPrintable(relative(file)));
                    QVERIFY2(text.contains("#pragma once"), qPrintable(relative(file)));
                }
    }

private:
    static void everySource()
    {
        QTest::addColumn<QString>("file");
        for (const char* top : {"model", "views", "app", "tests"})
            for (const QString& file : sourcesUnder(top))
                QTest::newRow(qPrintable(relative(file))) << file;
    }
};

const RegisteredTest registered("test_rooms", runPlain<TestRooms>);

} // namespace ripstop::test_rooms
#include "test_rooms.moc"
