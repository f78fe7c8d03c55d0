// Small files that ask for much: lists and sizes in a recording that are not there, steps and times
// that nobody has recorded, archives that unpack to a thousand times their size. Each is forged
// with its checksums repaired, and refused by what is there; what packs well by rights is read.
//
// Stages: the counts of bytes; recordings, of which each row forges one number; a sheet at rest;
// archives.
#include "base/bytes.h"
#include "builders/builder.h"
#include "bundle/bundle.h"
#include "bundle/zip_file.h"
#include "io/recording_file.h"
#include "recording/run_chunk.h"
#include "recording/run_fields.h"
#include "registered_test.h"
#include "shapes/height_picture.h"

#include "files.h"
#include "flown.h"
#include "recording_blocks.h"
#include "system/moment.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QtEndian>
#include <QtTest>

#include <sys/resource.h>

Q_DECLARE_METATYPE(void (*)(ripstop::StretchParts&))

namespace ripstop::test_bombs {

namespace {

constexpr std::int64_t flownSteps = 40;

std::string bytesOf(const StoredChunk& chunk)
{
    ByteWriter writer;
    writer(chunk);
    return writer.take();
}

// A zstd frame without content that claims to have this much.
std::string claiming(std::uint64_t size)
{
    std::string frame("\x28\xb5\x2f\xfd\xe0", 5); // magic; one segment, a size of eight bytes
    frame.append(reinterpret_cast<const char*>(&size), sizeof size);
    return frame + std::string("\x01\0\0", 3); // the last block, raw and empty
}

QByteArray bigEndian(quint32 number)
{
    QByteArray bytes(4, 0);
    qToBigEndian(number, bytes.data());
    return bytes;
}

// A piece of a PNG with its checksum, CRC-32 as ISO 3309 has it.
QByteArray pngChunk(const QByteArray& type, const QByteArray& data)
{
    quint32 crc = 0xffffffffu;
    for (const char c : type + data) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320u : 0u);
    }
    return bigEndian(quint32(data.size())) + type + data + bigEndian(~crc);
}

// A grey PNG of 8 bits that is `side` points wide and high, and has `rows` black rows.
QByteArray blackPng(quint32 side, quint32 rows)
{
    const QByteArray zeros(qsizetype(rows) * (side + 1), 0); // a row begins with its filter
    return "\x89PNG\r\n\x1a\n"
           + pngChunk("IHDR", bigEndian(side) + bigEndian(side) + QByteArray::fromHex("0800000000"))
           + pngChunk("IDAT", qCompress(zeros, 9).mid(4)) // the size is Qt's
           + pngChunk("IEND", {});
}

long peakMemory() // KiB
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

using Forge = void (*)(StretchParts& stretch);

void forgeHead(StretchParts& stretch, void (*forge)(StoredChunk& chunk))
{
    const std::string bytes = *unpacked(stretch.head);
    StoredChunk chunk;
    ByteReader reader(bytes);
    reader(chunk);
    forge(chunk);
    stretch.head = packed(bytesOf(chunk), Packing::Small);
}

} // namespace

class TestBombs : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        const auto recording = flown(*build(*findBuilder("rope"), {}), flownSteps);
        m_file = m_folder.filePath("run.ripstop-run");
        QVERIFY(!saveRecording(*recording, m_file.toStdString()));
        QVERIFY(blocksOf(contentOf(m_file).toStdString()).first(RecordingBlock::Stretch));
    }

    // An input takes ten bytes at least: a thousand bytes hold no more than a hundred of them.
    void aListAsksForWhatItsBytesHold()
    {
        ByteWriter writer;
        writer(std::uint64_t(101));
        const std::string bytes = writer.take() + std::string(1000, '\0');
        ByteReader reader(bytes);
        std::vector<RunInput> inputs;
        reader(inputs);
        QVERIFY(!reader.ok());
        QVERIFY(inputs.empty());
    }

    void forgedRecordings_data()
    {
        QTest::addColumn<Forge>("forge");
        QTest::addColumn<QString>("says");
        const QString memory = "asks for more memory than its bytes may need";
        const auto row = [&](const char* name, Forge forge, const QString& says) {
            QTest::newRow(name) << forge << says;
        };
        row("nothing forged", [](StretchParts&) {}, {});
        row(
            "frames that claim 3.2 GB",
            [](StretchParts& stretch) { stretch.frames = claiming(3200000000u); }, memory);
        row(
            "a head that claims 3.2 GB",
            [](StretchParts& stretch) { stretch.head = claiming(3200000000u); }, memory);
        row(
            "8 MB of inputs from some hundred bytes",
            [](StretchParts& stretch) {
                const std::uint64_t count = 8000000;
                std::string bytes = bytesOf(StoredChunk{0, 0, {0}, {0.0}, {1}, {}, {}});
                bytes.resize(bytes.size() - 2 * sizeof count);
                bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
                bytes.resize(bytes.size() + count);
                stretch.head = packed(bytes, Packing::Small);
            },
            memory);
        row(
            "a frame of step 10^15",
            [](StretchParts& stretch) {
                forgeHead(stretch,
                          [](StoredChunk& chunk) { chunk.frameSteps.back() = 1000000000000000; });
            },
            "is damaged");
        row(
            "a first step that no number follows",
            [](StretchParts& stretch) {
                forgeHead(stretch, [](StoredChunk& chunk) {
                    chunk.firstStep = chunk.frameSteps.front() = chunk.frameSteps.back() =
                        std::numeric_limits<std::int64_t>::max();
                });
            },
            "is damaged");
        row(
            "a frame after 10^9 s",
            [](StretchParts& stretch) {
                forgeHead(stretch, [](StoredChunk& chunk) { chunk.frameTimes.back() = 1e9; });
            },
            "is damaged");
        row(
            "a frame at no time",
            [](StretchParts& stretch) {
                forgeHead(stretch, [](StoredChunk& chunk) { chunk.frameTimes.back() = NAN; });
            },
            "is damaged");
        row(
            "a start 10^12 steps before",
            [](StretchParts& stretch) {
                std::optional<RunChunk> chunk = chunkOf(*unpacked(stretch.frames));
                State start = *chunk->start;
                start.step = -1000000000000;
                chunk->start = std::make_shared<const State>(start);
                stretch.frames = packed(ripstop::bytesOf(*chunk));
            },
            "is damaged");
        row(
            "a step of 2^31 substeps",
            [](StretchParts& stretch) {
                std::optional<RunChunk> chunk = chunkOf(*unpacked(stretch.frames));
                State start = *chunk->start;
                start.substeps = std::numeric_limits<int>::max();
                chunk->start = std::make_shared<const State>(start);
                stretch.frames = packed(ripstop::bytesOf(*chunk));
            },
            "does not fit its design");
    }

    // It is refused when it is opened or when its last step is asked for, at once and in little
    // memory.
    void forgedRecordings()
    {
        QFETCH(Forge, forge);
        QFETCH(QString, says);
        RecordingBlocks blocks = blocksOf(contentOf(m_file).toStdString());
        RecordingBlock& block = *blocks.first(RecordingBlock::Stretch);
        StretchParts stretch = partsOf(block.content);
        forge(stretch);
        block.content = ripstop::contentOf(stretch);
        const QString forged = m_folder.filePath("forged.ripstop-run");
        write(forged, QByteArray::fromStdString(fileOf(blocks)));

        [[maybe_unused]] const long before = peakMemory();
        QElapsedTimer clock;
        clock.start();
        std::string said;
        if (const auto opened = openRecording(forged.toStdString()); !opened)
            said = opened.message().english();
        else if (!opened->damage.empty())
            said = opened->damage.english();
        else if (const auto moment = opened->recording->moment(flownSteps); !moment)
            said = moment.message().english();
        QVERIFY2(says.isEmpty() ? said.empty() : said.find(says.toStdString()) != std::string::npos,
                 said.c_str());
        QVERIFY(clock.elapsed() < 5000);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
        QVERIFY(peakMemory() - before < 64 * 1024);
#endif
    }

    // What stands still packs to a thousandth, and is read all the same.
    void aSheetAtRest()
    {
        Scene scene = *build(*findBuilder("cloth"),
                             {{"columns", 60.0}, {"rows", 60.0}, {"sphere", 0.0}, {"hang", 3.0}});
        scene.settings.gravity = Vec3::Zero();
        const auto recording = flown(scene, 100);
        recording->settle();
        const std::string bytes = *recording->chunkBytes(0);
        QVERIFY(*unpackedSize(bytes) > 500 * bytes.size());
        const QString file = m_folder.filePath("rest.ripstop-run");
        QVERIFY(!saveRecording(*recording, file.toStdString()));
        const auto opened = openRecording(file.toStdString());
        QVERIFY2(opened, opened ? "" : opened.message().english().c_str());
        QVERIFY2(opened->damage.empty(), opened->damage.english().c_str());
        QVERIFY(opened->recording->moment(100));
    }

    // 100 MiB of zeros, of which a zip takes a thousandth.
    void anArchiveThatGrows()
    {
        QVERIFY(QDir().mkpath(m_folder.filePath("large")));
        QFile zeros(m_folder.filePath("large/probes.csv"));
        QVERIFY(zeros.open(QIODevice::WriteOnly));
        QVERIFY(zeros.resize(qint64(100) << 20));
        zeros.close();
        const QString zip = m_folder.filePath("large.zip");
        QVERIFY(
            !zipFolder(m_folder.filePath("large").toStdString(), "large", zip.toStdString(), {}));
        QVERIFY(QFileInfo(zip).size() < (1 << 20));
        QVERIFY(zeros.remove());

        QVERIFY(QDir().mkpath(m_folder.filePath("unpacked")));
        const auto failure =
            unzip(zip.toStdString(), m_folder.filePath("unpacked").toStdString(), {});
        QVERIFY(failure);
        const std::string said = failure->message.english();
        QVERIFY2(said.find("large.zip") != std::string::npos
                     && said.find("far more in it than its size allows") != std::string::npos,
                 said.c_str());
        QVERIFY(!openBundle(zip.toStdString()));
    }

    // A black picture has a thousand points for each of its bytes.
    void aBlackPicture()
    {
        const QString file = m_folder.filePath("black.png");
        write(file, blackPng(2048, 2048));
        QVERIFY(QFileInfo(file).size() < 10000);
        const auto small = readHeightPicture(file.toStdString());
        QVERIFY2(small, small ? "" : small.message().english().c_str());
        QVERIFY(std::ranges::all_of(small->height, [](double height) { return height == 0.0; }));

        write(file, blackPng(8192, 1)); // it is refused by its head
        const long before = peakMemory();
        const auto refused = readHeightPicture(file.toStdString());
        QVERIFY(!refused);
        const std::string said = refused.message().english();
        QVERIFY2(said.find("black.png") != std::string::npos
                     && said.find("too few bytes for 8192 x 8192 points") != std::string::npos,
                 said.c_str());
        QVERIFY(peakMemory() - before < 16 * 1024); // KiB, of 64 MiB that the points would take
    }

private:
    QTemporaryDir m_folder;
    QString m_file;
};

const RegisteredTest registered("test_bombs", runWithCore<TestBombs>);

} // namespace ripstop::test_bombs
#include "test_bombs.moc"
