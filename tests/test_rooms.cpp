// The plan of the house: who may include whom, and what stays out of which room.
#include <QtTest>

#include <QDirIterator>
#include <QRegularExpression>

// A room sees itself, the rooms listed for it, and nothing else of ours; of foreign headers it sees
// the standard library and those that start with a prefix listed for it. What `hidden` lists may
// be included by sources only, so that no other room is tied to it.
struct Room
{
    QString path;
    QStringList rooms;
    QStringList libraries;
    QStringList hidden;
};

static const QStringList json{"rapidjson/", "assimp/"};
static const QStringList posix{"fcntl.h", "sys/", "unistd.h"};

static const QList<Room> namedRooms = {
    // clang-format off
    {"model/base",     {},                                                           {"Eigen/"},  {}},
    {"model/shapes",   {"base"},                                                     {"Eigen/"},  {"png.h", "assimp/"}},
    {"model/scene",    {"base", "shapes"},                                           {"Eigen/"},  {"muParser.h"}},
    {"model/builders", {"base", "scene"},                                            {"Eigen/"},  {}},
    {"model/author",   {"base", "shapes", "scene", "builders"},                      {"Eigen/"},  {}},
    {"model/sim",      {"base", "shapes"},                                           {"Eigen/"},  {"oneapi/", "tbb/", "sanitizer/"}},
    {"model/measure",  {"base", "sim"},                                              {"Eigen/"},  {}},
    {"model/compile",  {"base", "shapes", "scene", "sim"},                           {"Eigen/"},  {}},
    {"model/run",      {"base", "scene", "sim", "compile", "measure"},               {"Eigen/"},  {"zstd.h"}},
    {"model/verify",   {"base", "scene", "builders", "sim", "compile", "measure", "run"},
                                                                                     {"Eigen/"},  {}},
    {"model/io",       {"base", "scene", "measure", "run"},                          {"Eigen/"},  json + posix},
    {"model/export",   {"base", "scene", "run", "io"},                               {"Eigen/"},  {"assimp/", "tiny_gltf.h"}},
    {"model/bundle",   {"base", "scene", "compile", "measure", "run", "io", "export"},
                                                                                     {"Eigen/"},  {"zip.h", "nlohmann/"}},
    {"views/document", {"base", "scene", "author", "compile", "run", "io"},          {"Q", "Eigen/"},        {}},
    {"views/viewport", {"base", "shapes", "scene", "author", "run", "document", "icons"},
                                                                                     {"Q", "Eigen/", "vtk"}, {}},
    {"app/cli",        {"base", "shapes", "scene", "builders", "author", "sim", "compile", "measure",
                        "run", "io", "export", "bundle", "verify"},
                                                                                     {"Eigen/", "CLI/", "nlohmann/"}, posix},
    // clang-format on
};

// Every other room of the views, and the editor, which alone may put them together.
static const QStringList viewsMayInclude{"base", "scene", "author", "run", "document", "icons"};
static const QHash<QString, QStringList> viewsMayAlsoInclude{
    {"start", {"builders"}}, // the gallery offers builders
    {"plots", {"io"}},       // curves are saved as tables
    {"import", {"shapes"}},  // files of meshes are read
};

static QString relative(const QString& file) { return file.mid(int(strlen(SOURCE_DIR)) + 1); }

static QStringList sourcesUnder(const QString& folder)
{
    QStringList files;
    QDirIterator found(QStringLiteral(SOURCE_DIR "/") + folder, {"*.h", "*.cpp"}, QDir::Files,
                       QDirIterator::Subdirectories);
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

static QList<Room> allRooms()
{
    QList<Room> rooms = namedRooms;
    const auto isNamed = [](const QString& path) {
        return std::any_of(namedRooms.begin(), namedRooms.end(),
                           [&](const Room& room) { return room.path == path; });
    };
    QStringList everything{"editor"};
    for (const QString& path : foldersUnder("model") + foldersUnder("views")) {
        const QString name = path.section('/', 1);
        everything << name;
        if (path.startsWith("views/") && !isNamed(path))
            rooms.append({path,
                          viewsMayInclude + viewsMayAlsoInclude.value(name),
                          {"Q"},
                          name == "plots"
                              ? QStringList{"Eigen/", "unsupported/Eigen/", "qcustomplot.h"}
                              : QStringList{"Eigen/"}});
    }
    rooms.append({"app/editor", everything, {"Q", "Eigen/"}, {}});
    return rooms;
}

static QString textOf(const QString& file)
{
    QFile source(file);
    return source.open(QIODevice::ReadOnly) ? QString::fromUtf8(source.readAll()) : QString();
}

class TestRooms : public QObject
{
    Q_OBJECT

private slots:
    // A new folder of the model must be given its place in the table above.
    void everyFolderIsARoom()
    {
        QStringList paths;
        for (const Room& room : allRooms())
            paths << room.path;
        for (const char* top : {"model", "views", "app"})
            for (const QString& folder : foldersUnder(top))
                QVERIFY2(paths.contains(folder), qPrintable(folder + " is not in the table"));
    }

    void includes_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("room");
        const QList<Room> rooms = allRooms();
        for (int i = 0; i < rooms.size(); ++i)
            for (const QString& file : sourcesUnder(rooms[i].path))
                QTest::newRow(qPrintable(relative(file))) << file << i;
    }

    void includes()
    {
        QFETCH(QString, file);
        QFETCH(int, room);
        const Room place = allRooms()[room];

        QStringList libraries = place.libraries;
        if (file.endsWith(".cpp"))
            libraries += place.hidden;

        static const QRegularExpression include("^\\s*#\\s*include\\s+([<\"])([^>\"]+)[>\"]",
                                                QRegularExpression::MultilineOption);
        auto matches = include.globalMatch(textOf(file));
        while (matches.hasNext()) {
            const auto match = matches.next();
            const QString header = match.captured(2);
            if (match.captured(1) == "\"") {
                const QString target = header.section('/', 0, 0);
                const bool ownMoc = header == QFileInfo(file).completeBaseName() + ".moc";
                QVERIFY2(
                    ownMoc || target == place.path.section('/', 1) || place.rooms.contains(target),
                    qPrintable(header + " is of a room that " + place.path + " may not look into"));
            } else if (header.contains('.') || header.contains('/') || header[0].isUpper()) {
                // not the standard library
                QVERIFY2(std::any_of(libraries.begin(), libraries.end(),
                                     [&](const QString& p) { return header.startsWith(p); }),
                         qPrintable(header + " is of a library that " + place.path
                                    + " may not use here"));
            }
        }
    }

    void filesAreShort_data() { everySource(); }

    void filesAreShort()
    {
        QFETCH(QString, file);
        const auto lines = textOf(file).count('\n');
        QVERIFY2(lines <= 500, qPrintable(QString("%1 lines; the limit is 500").arg(lines)));
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

QTEST_APPLESS_MAIN(TestRooms)
#include "test_rooms.moc"
