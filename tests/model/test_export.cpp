// Exported files, read back by other means than ours.
//
// Stages: the formats of one moment, then series and tables with their rates; that a moment does
// not depend on the way to it; then cancelling, runs that stop early, failures of writing, and
// tables without probes.
#include "compile/compile.h"
#include "export/export_run.h"
#include "export/format.h"
#include "io/csv.h"
#include "model/files.h"
#include "registered_test.h"
#include "scene/scene.h"
#include "simulation/simulation.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtEndian>
#include <QtTest>

#include <cmath>
#include <cstring>
#include <limits>

namespace ripstop::test_export {

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

// A square of two panels with its diagonal and a free line. The diagonal is torn, so the second
// panel is gone.
//
//     3---2
//     | / |      4: hangs on 0
//     0---1
Frame square()
{
    auto layout = std::make_shared<Layout>();
    layout->particleId = {11, 12, 13, 14, 15};
    layout->pinned = {1, 0, 0, 0, 0};
    layout->links = {{21, LinkKind::Rod, 0, 1, 1.0},    {22, LinkKind::Rod, 1, 2, 1.0},
                     {23, LinkKind::Spring, 0, 2, 1.4}, {24, LinkKind::Rod, 2, 3, 1.0},
                     {25, LinkKind::Rod, 3, 0, 1.0},    {26, LinkKind::Rod, 0, 4, 1.0}};
    layout->panelId = {31, 32};
    layout->panelCorners = {{0, 1, 2}, {0, 2, 3}};
    layout->probes = {{41, "height", "m", true},
                      {42, "glide ratio", "", true},
                      {43, "pull, \"left\"", "N", true}};
    Frame frame;
    frame.layout = layout;
    frame.time = 1.25;
    frame.position = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}, {0, -1, 0}};
    frame.velocity = {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}, {0, 0, -4.5}};
    frame.strain = {0.01, 0.03, 0.0, 0.02, -0.01, 0.25};
    frame.tension = {1.0, 3.0, 0.0, 2.0, -1.0, 9.80665};
    frame.torn = {0, 0, 1, 0, 0, 0};
    frame.panelLoad = {{0, 0, 7}, {0, 0, 0}};
    frame.gone = {0, 1};
    frame.probe = {2.5, notANumber, -1e-7};
    return frame;
}

// A weight on a line of 1 m, and a probe of its height. One step is 1/100 s.
Scene pendulum()
{
    Part part;
    part.particles = {{.id = Id{2}, .pinned = true},
                      {.id = Id{3}, .position = Vec3(1.0, 0.0, 0.0)}};
    part.links = {{.id = Id{4}, .from = Id{2}, .to = Id{3}}};
    Scene scene;
    scene.settings.timeStep = 0.01;
    scene.items = {{Id{1}, part}, {Id{5}, Probe{.name = "height", .target = Id{3}}}};
    scene.nextId = Id{6};
    return scene;
}

Simulation simulationOf(const Scene& scene) { return Simulation(*compile(scene)); }

std::optional<Failure> written(const Frame& frame, const std::string& target)
{
    return writeMoment(frame, MeshAppearance(), target);
}

int countOf(const QStringList& lines, const QString& start)
{
    return int(std::count_if(lines.begin(), lines.end(),
                             [&](const QString& line) { return line.startsWith(start); }));
}

// What a VTP file says, decoded.
struct Vtp
{
    QMap<QString, QString> piece;          // attributes of the piece
    QMap<QString, QVector<double>> values; // by "PointData/velocity (m/s)"
    QMap<QString, QVector<qint64>> integers;
    QString error;
};

// The array that begins there: how many blocks, their size, that of a smaller last one, how long
// each is when compressed, and the blocks.
template <typename T>
QVector<T> decoded(const QByteArray& values, qsizetype offset, QString& error)
{
    const auto wordAt = [&](qsizetype i) {
        quint64 word = 0;
        if (offset + 8 * (i + 1) <= values.size())
            std::memcpy(&word, values.data() + offset + 8 * i, 8);
        else
            error = "cut off";
        return word;
    };
    const auto blocks = qsizetype(wordAt(0));
    QByteArray bytes;
    qsizetype at = offset + 8 * (3 + blocks);
    for (qsizetype i = 0; i < blocks; ++i) {
        const bool isShort = i == blocks - 1 && wordAt(2) > 0;
        const quint64 size = wordAt(isShort ? 2 : 1);
        QByteArray packed(4, '\0'); // qUncompress() wants the size before the block
        qToBigEndian(quint32(size), packed.data());
        const auto length = qsizetype(wordAt(3 + i));
        const QByteArray block = qUncompress(packed + values.mid(at, length));
        if (quint64(block.size()) != size)
            error = "wrong length";
        bytes += block;
        at += length;
    }
    QVector<T> list(qsizetype(bytes.size() / qsizetype(sizeof(T))));
    if (!list.isEmpty())
        std::memcpy(list.data(), bytes.data(), std::size_t(bytes.size()));
    return list;
}

Vtp readVtp(const QString& path)
{
    Vtp vtp;
    const QByteArray content = contentOf(path);
    const QByteArray mark = "<AppendedData encoding=\"raw\">\n_";
    const qsizetype begin = content.indexOf(mark);
    if (begin < 0)
        vtp.error = "no values";
    const QByteArray values = content.mid(begin + mark.size());
    QXmlStreamReader xml(content.left(begin) + "</VTKFile>");
    QStringList sections;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement()) {
            const auto attributes = xml.attributes();
            if (xml.name() == u"Piece")
                for (const auto& attribute : attributes)
                    vtp.piece[attribute.name().toString()] = attribute.value().toString();
            if (xml.name() == u"DataArray") {
                const QString name = sections.back() + "/" + attributes.value("Name").toString();
                const qsizetype offset = attributes.value("offset").toLongLong();
                if (attributes.value("type") == u"Int64")
                    vtp.integers[name] = decoded<qint64>(values, offset, vtp.error);
                else
                    vtp.values[name] = decoded<double>(values, offset, vtp.error);
                xml.skipCurrentElement();
            } else {
                sections.push_back(xml.name().toString());
            }
        } else if (xml.isEndElement()) {
            sections.pop_back();
        }
    }
    if (xml.hasError())
        vtp.error = xml.errorString();
    return vtp;
}

} // namespace

class TestExport : public QObject
{
    Q_OBJECT

private slots:
    void obj()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("a kite.obj");
        QVERIFY(!written(square(), path.toStdString()));
        const QStringList lines = QString(contentOf(path)).split('\n');
        QCOMPARE(countOf(lines, "v "), 5);
        QVERIFY(lines.contains("v 1 1 0.1"));
        QCOMPARE(countOf(lines, "f "), 1); // the other panel is gone
        QVERIFY(lines.contains("f 1//1 2//2 3//3"));
        QCOMPARE(countOf(lines, "l "), 5); // the diagonal is torn
        QVERIFY(lines.contains("l 1 5"));
        QVERIFY(!lines.contains("l 1 3"));
    }

    void ply()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("kite.ply");
        QVERIFY(!written(square(), path.toStdString()));
        const QStringList lines = QString(contentOf(path)).trimmed().split('\n');
        QCOMPARE(lines.front(), QString("ply"));
        QVERIFY(lines.contains("element vertex 5"));
        QVERIFY(lines.contains("element face 1"));
        QVERIFY(lines.contains("element edge 5"));
        const qsizetype header = lines.indexOf("end_header") + 1;
        QCOMPARE(lines.size() - header, 5 + 1 + 5);
        QCOMPARE(lines[header + 4], QString("0 -1 0 0 0 -4.5"));
        QCOMPARE(lines[header + 5], QString("3 0 1 2"));
        QCOMPARE(lines.back(), QString("0 4 0.25 9.80665"));
    }

    void vtp()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("kite.vtp");
        QVERIFY(!written(square(), path.toStdString()));
        const Vtp vtp = readVtp(path);
        QCOMPARE(vtp.error, QString());
        QCOMPARE(vtp.piece["NumberOfPoints"], QString("5"));
        QCOMPARE(vtp.piece["NumberOfLines"], QString("5"));
        QCOMPARE(vtp.piece["NumberOfPolys"], QString("1"));

        using Numbers = QVector<double>;
        using Wholes = QVector<qint64>;
        QCOMPARE(vtp.values["FieldData/TimeValue"], Numbers{1.25});
        QCOMPARE(vtp.values["Points/Points"],
                 (Numbers{0, 0, 0, 1, 0, 0, 1, 1, 0.1, 0, 1, 0, 0, -1, 0}));
        QCOMPARE(vtp.values["PointData/velocity (m/s)"].back(), -4.5);
        // both ends of the diagonal
        QCOMPARE(vtp.values["PointData/torn links (1)"], (Numbers{1, 0, 1, 0, 0}));
        QCOMPARE(vtp.integers["PointData/id"], (Wholes{11, 12, 13, 14, 15}));

        QCOMPARE(vtp.integers["Lines/connectivity"], (Wholes{0, 1, 1, 2, 2, 3, 3, 0, 0, 4}));
        QCOMPARE(vtp.integers["Lines/offsets"], (Wholes{2, 4, 6, 8, 10}));
        QCOMPARE(vtp.integers["Polys/connectivity"], (Wholes{0, 1, 2}));
        QCOMPARE(vtp.integers["Polys/offsets"], (Wholes{3}));

        // five lines, then the panel: its strain is the largest along its edges, 1 to 2
        QCOMPARE(vtp.values["CellData/strain (1)"], (Numbers{0.01, 0.03, 0.02, -0.01, 0.25, 0.03}));
        QCOMPARE(vtp.values["CellData/tension (N)"], (Numbers{1, 3, 2, -1, 9.80665, 0}));
        QCOMPARE(vtp.values["CellData/panel load (N)"].size(), 6 * 3);
        QCOMPARE(vtp.values["CellData/panel load (N)"].back(), 7.0);
        QCOMPARE(vtp.integers["CellData/id"], (Wholes{21, 22, 24, 25, 26, 31}));
    }

    // Where panels carry the pull of a fabric they have strain, tension and state of their own.
    void vtpOfElasticPanels()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("sail.vtp");
        Frame frame = square();
        frame.panelPull = {{true, ClothState::Wrinkled, 0.002, 80.0}, {}};
        QVERIFY(!written(frame, path.toStdString()));
        const Vtp vtp = readVtp(path);
        QCOMPARE(vtp.error, QString());
        QCOMPARE(vtp.values["CellData/strain (1)"].back(), 0.002);
        QCOMPARE(vtp.values["CellData/panel tension (N/m)"],
                 (QVector<double>{0, 0, 0, 0, 0, 80.0}));
        QCOMPARE(vtp.integers["CellData/cloth (0 slack, 1 wrinkled, 2 taut)"],
                 (QVector<qint64>{-1, -1, -1, -1, -1, 1}));
    }

    void vtpOfNothing()
    {
        QTemporaryDir folder;
        Frame frame;
        frame.layout = std::make_shared<Layout>();
        QVERIFY(!written(frame, folder.filePath("a.vtp").toStdString()));
        QCOMPARE(readVtp(folder.filePath("a.vtp")).error, QString());
        QVERIFY(!written(frame, folder.filePath("a.obj").toStdString()));
        QVERIFY(!written(frame, folder.filePath("a.ply").toStdString()));
    }

    void csv()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("kite.csv");
        Frame frame = square();
        Result<CsvWriter> table = CsvWriter::open(path.toStdString(), frame);
        QVERIFY(table);
        table->add(frame);
        frame.time = 1.5;
        frame.probe = {-0.0, 1.0 / 3.0, std::numeric_limits<double>::infinity()};
        table->add(frame);
        QVERIFY(!table->close(frame));
        QStringList lines = QString(contentOf(path)).split('\n');
        QCOMPARE(lines.size(), 6);
        QVERIFY(lines.takeFirst().startsWith("# Ripstop "));
        QCOMPARE(lines.takeAt(3), QString("# end; state at 1.5 s: 0000000000000000"));
        QCOMPARE(lines[0], QString("time (s),height (m),glide ratio,\"pull, \"\"left\"\" (N)\""));
        QCOMPARE(lines[1], QString("1.25,2.5,,-1e-07"));
        QCOMPARE(lines[2], QString("1.5,-0.0,0.3333333333333333,"));
        QCOMPARE(lines[3], QString());
    }

    // A series over 0.1 to 0.5 s at 10 frames per second has five frames.
    void series()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("a & b.pvd");
        Simulation simulation = simulationOf(pendulum());
        FlownFrames flown(simulation);
        double share = 0.0;
        const auto failure =
            exportRun(flown, MeshAppearance(), {.from = 0.1, .to = 0.5, .fps = 10.0},
                      path.toStdString(), [&](double done) {
                          const bool forward = done >= share;
                          share = done;
                          return forward;
                      });
        QVERIFY2(!failure, failure ? failure->message.english().c_str() : "");
        QCOMPARE(share, 1.0);

        QXmlStreamReader xml(contentOf(path));
        QVector<double> times;
        while (!xml.atEnd())
            if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == u"DataSet") {
                times.push_back(xml.attributes().value("timestep").toDouble());
                const QString file = folder.filePath(xml.attributes().value("file").toString());
                const Vtp vtp = readVtp(file);
                QCOMPARE(vtp.error, QString());
                QCOMPARE(vtp.values["FieldData/TimeValue"].front(), times.back());
            }
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
        QCOMPARE(times.size(), 5);
        for (int i = 0; i < 5; ++i)
            QVERIFY(std::abs(times[i] - 0.1 * (i + 1)) < 1e-9);
        QCOMPARE(QDir(folder.filePath("a & b")).entryList(QDir::Files).size(), 5);
    }

    // A rate above that of the steps gives each step once.
    void table()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("height.csv");
        Simulation simulation = simulationOf(pendulum());
        FlownFrames flown(simulation);
        QVERIFY(!exportRun(flown, MeshAppearance(), {.from = 0.0, .to = 0.2, .fps = 1000.0},
                           path.toStdString()));
        const QStringList lines = QString(contentOf(path)).trimmed().split('\n');
        QCOMPARE(lines.size(), 3 + 21); // two comments
        QCOMPARE(lines[1], QString("time (s),height (m)"));
        QCOMPARE(lines[2], QString("0,0"));
    }

    // The same moment, whether one runs there at once or by way of a series.
    void momentIsTheSameEitherWay()
    {
        QTemporaryDir folder;
        Simulation direct = simulationOf(pendulum());
        QVERIFY(direct.runUntil(0.3));
        QVERIFY(!written(*direct.frame(), folder.filePath("direct.ply").toStdString()));
        Simulation exported = simulationOf(pendulum());
        FlownFrames flown(exported);
        QVERIFY(!exportRun(flown, MeshAppearance(), {.to = 0.3},
                           folder.filePath("exported.ply").toStdString()));
        QCOMPARE(contentOf(folder.filePath("exported.ply")),
                 contentOf(folder.filePath("direct.ply")));
    }

    void cancelRemovesWhatWasWritten_data()
    {
        QTest::addColumn<QString>("target");
        for (const char* target : {"kite.pvd", "kite.csv", "kite.obj", "kite.glb", "kite.pc2",
                                   "kite.mdd", "kite_{frame}.ply"})
            QTest::newRow(target) << target;
    }

    void cancelRemovesWhatWasWritten()
    {
        QFETCH(QString, target);
        QTemporaryDir folder;
        Simulation simulation = simulationOf(pendulum());
        FlownFrames flown(simulation);
        const auto failure = exportRun(flown, MeshAppearance(), {.from = 0.0, .to = 2.0},
                                       folder.filePath(target).toStdString(),
                                       [](double done) { return done < 0.5; });
        QVERIFY(failure);
        QVERIFY(failure->message.english().find("cancelled") != std::string::npos);
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    // A ball that falls faster than the speed limit allows after 1 s.
    void whatWasFlownBeforeATroubleIsKept()
    {
        QTemporaryDir folder;
        Scene scene = pendulum();
        std::get<Part>(scene.items[0].item).links.clear();
        scene.settings.speedLimit = 9.80665;
        Simulation simulation = simulationOf(scene);
        FlownFrames flown(simulation);
        const QString path = folder.filePath("fall.csv");
        const auto failure = exportRun(flown, MeshAppearance(),
                                       {.from = 0.0, .to = 5.0, .fps = 10.0}, path.toStdString());
        QVERIFY(failure);
        QVERIFY(simulation.trouble());
        QVERIFY(failure->message.english().find("stopped") != std::string::npos);
        const QStringList lines = QString(contentOf(path)).trimmed().split('\n');
        QVERIFY(lines.size() >= 3 + 10 && lines.size() <= 3 + 12); // two of them are comments
    }

    void failures_data()
    {
        QTest::addColumn<QString>("target");
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::addColumn<double>("fps");
        QTest::addColumn<QString>("fragment");

        // clang-format off
        QTest::newRow("unknown extension")   << "kite.abc"           << 0.0  << 1.0 << 25.0 << ".obj, .ply";
        QTest::newRow("no extension")        << "kite"               << 0.0  << 1.0 << 25.0 << ".pvd";
        QTest::newRow("OBJ into nowhere")    << "missing/kite.obj"   << 0.0  << 0.1 << 25.0 << "there is no folder";
        QTest::newRow("PLY where none may")  << "/proc/kite.ply"     << 0.0  << 0.1 << 25.0 << "/proc/kite.ply";
        QTest::newRow("series into nowhere") << "missing/kite.pvd"   << 0.0  << 0.1 << 25.0 << "missing/kite";
        QTest::newRow("glTF into nowhere")   << "missing/kite.glb"   << 0.0  << 0.1 << 25.0 << "missing/kite.glb";
        QTest::newRow("cache where none may") << "/proc/kite.pc2"    << 0.0  << 0.1 << 25.0 << "/proc/kite.pc2";
        QTest::newRow("CSV where none may")  << "/proc/kite.csv"     << 0.0  << 0.1 << 25.0 << "/proc/kite.csv";
        QTest::newRow("end before start")    << "kite.pvd"           << 1.0  << 0.5 << 25.0 << "end of the range";
        QTest::newRow("before the design")   << "kite.pvd"           << -1.0 << 0.5 << 25.0 << "begins only at";
        QTest::newRow("no frames")           << "kite.pvd"           << 0.0  << 0.5 << 0.0  << "above 0";
        QTest::newRow("not a time")          << "kite.obj"           << 0.0  << notANumber << 25.0 << "range";
        // clang-format on
    }

    void failures()
    {
        QFETCH(QString, target);
        QFETCH(double, from);
        QFETCH(double, to);
        QFETCH(double, fps);
        QFETCH(QString, fragment);
        QTemporaryDir folder;
        Simulation simulation = simulationOf(pendulum());
        FlownFrames flown(simulation);
        const QString path = target.startsWith('/') ? target : folder.filePath(target);
        const auto failure = exportRun(flown, MeshAppearance(),
                                       {.from = from, .to = to, .fps = fps}, path.toStdString());
        QVERIFY(failure);
        QVERIFY2(failure->message.english().find(fragment.toStdString()) != std::string::npos,
                 failure->message.english().c_str());
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void tableWithoutProbes()
    {
        QTemporaryDir folder;
        Scene scene = pendulum();
        scene.items.pop_back();
        Simulation simulation = simulationOf(scene);
        FlownFrames flown(simulation);
        const auto failure = exportRun(flown, MeshAppearance(), {.from = 0.0, .to = 1.0},
                                       folder.filePath("kite.csv").toStdString());
        QVERIFY(failure);
        QVERIFY(failure->message.english().find("add a probe") != std::string::npos);
        QVERIFY(QDir(folder.path()).isEmpty());
    }
};

const RegisteredTest registered("test_export", runPlain<TestExport>);

} // namespace ripstop::test_export
#include "test_export.moc"
