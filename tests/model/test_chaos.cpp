// Every command that writes, ended at a random moment: killed, told to end, on a full disk, with
// its folder read-only or gone. What must hold is that a file is the old one or a whole new one,
// and that nothing is left behind when the next command is through.
//
// A Work is a command with its targets in a folder of its own. It is run to its end once, for the
// files that it makes and the time that it takes. The suite kills for some seconds; ./dev chaos N
// kills N times and more (RIPSTOP_CHAOS), from a seed that is printed (RIPSTOP_CHAOS_SEED).
#include "bundle/bundle.h"
#include "io/recording_file.h"
#include "io/scene_file.h"
#include "model/cli_call.h"
#include "registered_test.h"

#include <QElapsedTimer>
#include <QRandomGenerator>
#include <QTemporaryDir>

#include <array>
#include <csignal>

#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ripstop::test_chaos {

namespace {

const QByteArray oldContent = "what was there before\n";

struct Work
{
    const char* name;
    QStringList arguments;
    QStringList targets;
};

const std::vector<Work>& works()
{
    const QString rope = scene("rope"), kite = scene("delta_kite");
    static const std::vector<Work> list{
        {"run",
         {"run", rope, "--seconds", "4", "--threads", "1", "--csv", "probes.csv", "--tears",
          "tears.csv", "--loads", "loads.csv", "--events", "events.csv", "--final",
          "end.ripstop.json", "--record", "flight.ripstop-run"},
         {"probes.csv", "tears.csv", "loads.csv", "events.csv", "end.ripstop.json",
          "flight.ripstop-run"}},
        {"sweep",
         {"sweep", rope, "--sweep", "settings.airDensity=1:0.05:1.5", "--seconds", "0.3", "-o",
          "sweep.csv"},
         {"sweep.csv"}},
        {"certify",
         {"certify", scene("pendulum"), "--seconds", "0.3", "--csv", "certificate.csv", "--record",
          "certified.ripstop-run"},
         {"certificate.csv", "certified.ripstop-run"}},
        {"glTF", {"export", kite, "-o", "kite.glb", "--to", "1"}, {"kite.glb"}},
        {"ParaView", {"export", kite, "-o", "kite.pvd", "--to", "0.5"}, {"kite.pvd"}},
        {"numbered files",
         {"export", kite, "-o", "kite_{frame}.obj", "--to", "0.5"},
         {"kite_0000.obj"}},
        {"table", {"export", kite, "-o", "kite.csv", "--to", "1"}, {"kite.csv"}},
        {"moment", {"export", kite, "-o", "kite.ply", "--to", "0.2"}, {"kite.ply"}},
        {"zip", {"bundle", rope, "-o", "rope.zip", "--seconds", "0.3"}, {"rope.zip"}},
        {"bundle", {"bundle", rope, "-o", "rope", "--seconds", "0.3"}, {"rope"}},
        {"build", {"build", "cloth", "-o", "cloth.ripstop.json"}, {"cloth.ripstop.json"}},
        {"weigh",
         {"weigh", kite, "--set", "sail.arealDensity=0.04", "-o", "weighed.ripstop.json"},
         {"weighed.ripstop.json"}},
        {"preset",
         {"presets", scene("ripstop_kite"), "--save", "own", "--material", "sail", "--materials",
          "own.json", "--replace"},
         {"own.json"}}};
    return list;
}

QStringList namesIn(const QString& folder)
{
    return QDir(folder).entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden,
                                  QDir::Name);
}

// Names of files under way, in the folder and those in it.
QStringList leftIn(const QString& folder)
{
    QStringList left;
    for (const QFileInfo& one :
         QDir(folder).entryInfoList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden)) {
        if (one.fileName().contains(".part"))
            left << one.fileName();
        else if (one.isDir())
            left << leftIn(one.filePath());
    }
    return left;
}

// Whether its reader takes it as whole. Tables end with a whole line, those of a run with a mark.
bool isWhole(const QString& path)
{
    const std::string file = path.toStdString();
    if (path.endsWith(".ripstop.json"))
        return bool(readScene(file));
    if (path.endsWith(".ripstop-run")) {
        const auto opened = openRecording(file);
        return opened && opened->damage.empty();
    }
    if (path.endsWith(".zip") || QFileInfo(path).isDir()) {
        const auto bundle = openBundle(file);
        return bundle && bundle->changed.empty();
    }
    const QByteArray content = contentOf(path);
    if (path.endsWith("probes.csv"))
        return content.contains("\n# end;") && content.endsWith('\n');
    return !content.isEmpty() && content.endsWith('\n');
}

class Arena
{
public:
    explicit Arena(const Work& work)
        : m_work(work)
    {
        QElapsedTimer timer;
        timer.start();
        QProcess program;
        start(program, folder());
        m_works = program.waitForFinished(120000) && program.exitCode() == 0;
        m_said = program.readAllStandardError();
        m_time = std::max<qint64>(1, timer.elapsed());
        for (const QString& target : work.targets)
            m_new[target] = contentOf(path(target));
    }

    QByteArray whyNot() const { return m_works ? QByteArray() : "it fails: " + m_said; }
    QString folder() const { return m_folder.path(); }
    QString path(const QString& name) const { return m_folder.filePath(name); }
    qint64 time() const { return m_time; } // ms
    const Work& work() const { return m_work; }

    void start(QProcess& program, const QString& folder) const
    {
        program.setWorkingDirectory(folder);
        program.start(CLI_PROGRAM, m_work.arguments);
        program.waitForStarted();
    }

    // A complete old file in the place of each target; folders keep the bundle that is in them, and
    // own materials must be readable.
    void putOld() const
    {
        for (const QString& target : m_work.targets)
            if (!QFileInfo(path(target)).isDir() && !target.endsWith("own.json"))
                write(path(target), oldContent);
    }

    // What is wrong in a folder after a command has ended, or nothing. Killed, a command leaves all
    // of a file or none; told to end, what it had, as a whole file.
    QByteArray flaw(const QString& folder, bool isKilled) const
    {
        for (const QString& target : m_work.targets) {
            const QString file = QDir(folder).filePath(target);
            const QByteArray content = contentOf(file);
            if (!QFileInfo(file).isDir() && (content == oldContent || content == m_new[target]))
                continue;
            const bool mayBeShorter = !isKilled || target == "sweep.csv" || QFileInfo(file).isDir()
                                      || target.endsWith(".zip");
            if (!mayBeShorter || !isWhole(file))
                return target.toUtf8() + " is neither the old nor a whole new one: "
                       + content.left(200) + " ... " + content.right(100);
        }
        return {};
    }

private:
    Work m_work;
    QTemporaryDir m_folder;
    bool m_works = false;
    QByteArray m_said;
    qint64 m_time = 1; // ms
    QMap<QString, QByteArray> m_new;
};

void addWorks()
{
    QTest::addColumn<int>("work");
    for (std::size_t i = 0; i < works().size(); ++i)
        QTest::newRow(works()[i].name) << int(i);
}

// A disk of a given size for as long as it lives, where one may be made.
class SmallDisk
{
public:
    explicit SmallDisk(const char* size)
    {
        const QByteArray options = QByteArray("size=") + size;
        m_isThere = ::mount("tmpfs", folder().toLocal8Bit(), "tmpfs", 0, options) == 0;
    }
    ~SmallDisk()
    {
        if (m_isThere)
            ::umount2(folder().toLocal8Bit(), MNT_DETACH);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    bool isThere() const { return m_isThere; }
    QString folder() const { return m_folder.path(); }

private:
    QTemporaryDir m_folder;
    bool m_isThere = false;
};

// Makes a file or a folder read-only for as long as it lives: for root, who may write where the
// permissions forbid it, by a mount of it over itself, for others by its permissions.
class ReadOnly
{
public:
    explicit ReadOnly(const QString& path)
        : m_path(path.toLocal8Bit())
    {
        m_isMounted = ::mount(m_path, m_path, nullptr, MS_BIND, nullptr) == 0;
        if (m_isMounted)
            ::mount(nullptr, m_path, nullptr, MS_REMOUNT | MS_BIND | MS_RDONLY, nullptr);
        else
            ::chmod(m_path, S_IRUSR | S_IXUSR);
    }
    ~ReadOnly()
    {
        if (m_isMounted)
            ::umount2(m_path, MNT_DETACH);
        else
            ::chmod(m_path, S_IRWXU);
    }
    ReadOnly(const ReadOnly&) = delete;
    ReadOnly& operator=(const ReadOnly&) = delete;

    bool isInForce() const { return ::access(m_path, W_OK) != 0; }

private:
    QByteArray m_path;
    bool m_isMounted = false;
};

} // namespace

class TestChaos : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const QByteArray seed = qgetenv("RIPSTOP_CHAOS_SEED");
        const quint32 number =
            seed.isEmpty() ? QRandomGenerator::global()->generate() : seed.toUInt();
        m_random = QRandomGenerator(number);
        qInfo("seed %u", number);
        if (const int wanted = qEnvironmentVariableIntValue("RIPSTOP_CHAOS"); wanted > 0)
            m_kills = std::max(1, (wanted + int(works().size()) - 1) / int(works().size()));
    }

    void cleanupTestCase()
    {
        qInfo("%d commands were ended, %d of them in their work", m_all, m_in);
    }

    void endsAtAnyMoment_data() { addWorks(); }

    void endsAtAnyMoment()
    {
        QFETCH(int, work);
        const Arena arena(works()[std::size_t(work)]);
        QCOMPARE(arena.whyNot(), QByteArray());
        constexpr std::array ways{SIGKILL, SIGTERM, SIGINT};
        int recordings = 0;
        for (int i = 0; i < m_kills; ++i) {
            arena.putOld();
            const int signal = ways[i < 2 ? std::size_t(i) : m_random.bounded(3)];
            QProcess program;
            const QStringList before = leftIn(arena.folder());
            arena.start(program, arena.folder());
            QThread::usleep(m_random.bounded(quint32(1100 * arena.time())));
            ::kill(pid_t(program.processId()), signal);
            ++m_all;
            QVERIFY(program.waitForFinished(120000));
            m_in += program.exitStatus() == QProcess::CrashExit || program.exitCode() != 0;
            QCOMPARE(arena.flaw(arena.folder(), signal == SIGKILL), QByteArray());
            for (const QString& left : leftIn(arena.folder())) {
                QVERIFY2(signal == SIGKILL || before.contains(left), qPrintable(left));
                if (left.endsWith(".ripstop-run"))
                    recordings += bool(openRecording(arena.path(left).toStdString()));
            }
        }
        QProcess next; // takes away what the killed ones have left
        arena.start(next, arena.folder());
        QVERIFY(next.waitForFinished(120000));
        QCOMPARE(next.exitCode(), 0);
        QCOMPARE(leftIn(arena.folder()), QStringList());
        QCOMPARE(arena.flaw(arena.folder(), false), QByteArray());
        if (recordings > 0)
            qInfo("%d recordings of killed runs could be read", recordings);
    }

    void fillsTheDisk_data() { addWorks(); }

    // The size of files is limited, which makes a write fail in its middle.
    void fillsTheDisk()
    {
        QFETCH(int, work);
        const Arena arena(works()[std::size_t(work)]);
        QCOMPARE(arena.whyNot(), QByteArray());
        arena.putOld();
        for (const rlim_t size : {100, 5000}) {
            QProcess program;
            program.setChildProcessModifier([size] {
                const rlimit limit{size, size};
                ::setrlimit(RLIMIT_FSIZE, &limit);
            });
            arena.start(program, arena.folder());
            QVERIFY(program.waitForFinished(120000));
            const QString said = program.readAllStandardError();
            QCOMPARE(program.exitStatus(), QProcess::NormalExit);
            QVERIFY2(program.exitCode() == 1 || size > 100, qPrintable(said));
            QVERIFY2(program.exitCode() == 0 || !said.isEmpty(), "it fails in silence");
            QCOMPARE(arena.flaw(arena.folder(), true), QByteArray());
            QCOMPARE(leftIn(arena.folder()), QStringList());
        }
    }

    void writesOnASmallDisk_data() { addWorks(); }

    // Of 16 KB, a page for each file, where the system lets one be made.
    void writesOnASmallDisk()
    {
        QFETCH(int, work);
        const Arena arena(works()[std::size_t(work)]);
        QCOMPARE(arena.whyNot(), QByteArray());
        const SmallDisk disk("16k");
        if (!disk.isThere())
            QSKIP("Only root may make a small disk; limits of the size of files are tested above.");
        QProcess program;
        arena.start(program, disk.folder());
        QVERIFY(program.waitForFinished(120000));
        const QByteArray said = program.readAllStandardError();
        QCOMPARE(leftIn(disk.folder()), QStringList());
        if (program.exitCode() == 0)
            QCOMPARE(arena.flaw(disk.folder(), false), QByteArray());
        else
            QVERIFY2(!said.isEmpty(), "it fails in silence");
        for (const QString& name : namesIn(disk.folder()))
            QVERIFY2(QFileInfo(QDir(disk.folder()).filePath(name)).isDir()
                         || isWhole(QDir(disk.folder()).filePath(name)),
                     qPrintable(name));
    }

    void mayNotWrite_data()
    {
        QTest::addColumn<int>("work");
        QTest::addColumn<bool>("inFolder");
        for (std::size_t i = 0; i < works().size(); ++i) {
            QTest::addRow("%s, folder", works()[i].name) << int(i) << true;
            QTest::addRow("%s, target", works()[i].name) << int(i) << false;
        }
    }

    // Neither in a folder that is read-only nor over a file that is.
    void mayNotWrite()
    {
        QFETCH(int, work);
        QFETCH(bool, inFolder);
        const Arena arena(works()[std::size_t(work)]);
        QCOMPARE(arena.whyNot(), QByteArray());
        arena.putOld();
        const ReadOnly readOnly(inFolder ? arena.folder()
                                         : arena.path(arena.work().targets.first()));
        if (!readOnly.isInForce())
            QSKIP("Nothing can be made read-only here.");
        QProcess program;
        arena.start(program, arena.folder());
        QVERIFY(program.waitForFinished(120000));
        const QString said = program.readAllStandardError();
        QCOMPARE(program.exitStatus(), QProcess::NormalExit);
        QVERIFY2(program.exitCode() == 1, qPrintable(said));
        QCOMPARE(said.count('\n'), 1);
        QVERIFY2(said.contains("choose another folder"), qPrintable(said));
        QCOMPARE(arena.flaw(arena.folder(), true), QByteArray());
        QCOMPARE(leftIn(arena.folder()), QStringList());
    }

    void losesItsFolder_data() { addWorks(); }

    void losesItsFolder()
    {
        QFETCH(int, work);
        const Arena arena(works()[std::size_t(work)]);
        QCOMPARE(arena.whyNot(), QByteArray());
        arena.putOld();
        const QTemporaryDir elsewhere;
        const QString moved = elsewhere.filePath("moved");
        QProcess program;
        arena.start(program, arena.folder());
        QThread::usleep(m_random.bounded(quint32(1000 * arena.time())));
        QVERIFY(QDir().rename(arena.folder(), moved));
        QVERIFY(program.waitForFinished(120000));
        const QByteArray flaw = arena.flaw(moved, true);
        QVERIFY(QDir().rename(moved, arena.folder()));
        QCOMPARE(program.exitStatus(), QProcess::NormalExit);
        QCOMPARE(flaw, QByteArray());
    }

private:
    QRandomGenerator m_random;
    int m_kills = 3; // of each command
    int m_all = 0;
    int m_in = 0;
};

const RegisteredTest registered("test_chaos", runWithCore<TestChaos>);

} // namespace ripstop::test_chaos
#include "test_chaos.moc"
