// Feeds each reader of tests/fuzz/fuzz_readers.h its seeds, and for a few tenths of a second simple
// changes of them: bytes changed, pieces cut out, doubled and swapped, numbers made large. The
// changes are the same in each run. A reader that crashes, hangs or reads what is not sound ends
// the test; the input is left in a file.
//
// What libFuzzer finds in hours (./dev fuzz) becomes a seed, and is looked at here from then on.
#include "fuzz/fuzz_readers.h"
#include "registered_test.h"

#include "model/files.h"

#include <QDir>
#include <QElapsedTimer>
#include <QTemporaryFile>
#include <QtTest>

#include <csignal>
#include <random>

#include <unistd.h>

namespace ripstop::test_fuzz {

namespace {

// Simple changes of some seeds.
class Changes
{
public:
    explicit Changes(QList<QByteArray> seeds)
        : m_seeds(std::move(seeds))
    {}

    QByteArray next()
    {
        QByteArray bytes = m_seeds[below(m_seeds.size())];
        for (qsizetype change = 1 + below(4); change > 0 && !bytes.isEmpty(); --change)
            bytes = changed(bytes);
        return bytes;
    }

private:
    qsizetype below(qsizetype end) { return qsizetype(m_random() % std::uint64_t(end)); }

    QByteArray changed(QByteArray bytes)
    {
        static const QList<QByteArray> words{"-1", "0",  "1e308", "nan", "4294967295", "\"",
                                             "[",  "{}", ",",     "\n",  "#",          "null",
                                             "-",  " ",  "true",  "\\u0"};
        const qsizetype at = below(bytes.size());
        const qsizetype length = 1 + below(std::min<qsizetype>(bytes.size() - at, 64));
        switch (below(7)) {
        case 0:
            bytes[at] = char(below(256));
            break;
        case 1:
            bytes[at] = char(bytes[at] ^ (1 << below(8)));
            break;
        case 2:
            bytes.remove(at, length);
            break;
        case 3:
            bytes.insert(at, bytes.mid(below(bytes.size()), length));
            break;
        case 4:
            bytes.replace(at, below(4), words[below(words.size())]);
            break;
        case 5:
            bytes.replace(at, std::min<qsizetype>(length, 8), QByteArray(8, char(-below(2))));
            break;
        default:
            if (below(4) == 0)
                bytes.truncate(at);
        }
        return bytes;
    }

    QList<QByteArray> m_seeds;
    std::mt19937_64 m_random{22};
};

// The input that is being read, for whoever ends the program.
QByteArray underway;
int keptInput = -1;

void keepInput(int signal)
{
    if (::write(keptInput, underway.constData(), std::size_t(underway.size())) < 0)
        ::_exit(signal);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

QList<QByteArray> seedsOf(std::string_view reader)
{
    const QDir folder(QStringLiteral(SOURCE_DIR "/tests/fuzz/seeds/")
                      + QString::fromLatin1(reader.data(), qsizetype(reader.size())));
    QList<QByteArray> seeds;
    for (const QString& name : folder.entryList(QDir::Files, QDir::Name))
        seeds << contentOf(folder.filePath(name));
    return seeds;
}

} // namespace

class TestFuzz : public QObject
{
    Q_OBJECT

private slots:
    // An input that ends the program is left in a file.
    void initTestCase()
    {
        QVERIFY(m_kept.open());
        m_kept.setAutoRemove(false);
        keptInput = m_kept.handle();
        for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
            std::signal(signal, keepInput);
        qInfo("what ends the program is kept in %s", qPrintable(m_kept.fileName()));
    }

    void cleanupTestCase() { QVERIFY(m_kept.remove()); }

    void everyReader_data()
    {
        QTest::addColumn<int>("number");
        int number = 0;
        for (const FuzzReader& reader : fuzzReaders())
            QTest::newRow(std::string(reader.name).c_str()) << number++;
    }

    void everyReader()
    {
        QFETCH(int, number);
        const FuzzReader& reader = fuzzReaders()[std::size_t(number)];
        const QList<QByteArray> seeds = seedsOf(reader.name);
        QVERIFY2(!seeds.isEmpty(), "it has no seeds");
        for (const QByteArray& seed : seeds)
            reader.read({seed.constData(), std::size_t(seed.size())});

        const QByteArray milliseconds = qgetenv("RIPSTOP_FUZZ_MS");
        const qint64 end = milliseconds.isEmpty() ? 350 : milliseconds.toLongLong();
        Changes changes(seeds);
        QElapsedTimer clock;
        clock.start();
        int count = 0;
        for (; clock.elapsed() < end; ++count) {
            underway = changes.next();
            reader.read({underway.constData(), std::size_t(underway.size())});
        }
        QVERIFY2(clock.elapsed() < end + 20000, "an input took long");
        qInfo("%d inputs", count);
    }

    void everyFolderOfSeedsHasAReader()
    {
        for (const QString& name :
             QDir(SOURCE_DIR "/tests/fuzz/seeds").entryList(QDir::Dirs | QDir::NoDotAndDotDot))
            QVERIFY2(std::ranges::find(fuzzReaders(), name.toStdString(), &FuzzReader::name)
                         != fuzzReaders().end(),
                     qPrintable(name));
    }

private:
    QTemporaryFile m_kept;
};

const RegisteredTest registered("test_fuzz", runWithCore<TestFuzz>);

} // namespace ripstop::test_fuzz
#include "test_fuzz.moc"
