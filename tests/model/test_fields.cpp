// Lists of fields: nothing is missing from them, and all that walks over fields follows them.
//
// Stages: names, differences and clearing of fields; then bytes, recordings, hashes and
// carry-over, each of which has to follow the list of fields and to need no list of its own.
#include "assembly/carry_over.h"
#include "base/bytes.h"
#include "measure/diagnostics.h"
#include "recording/run_fields.h"
#include "registered_test.h"

#include <QtTest>

namespace ripstop::test_fields {

namespace {

struct Specimen
{
    int number = 0;
    Vec3 place = Vec3::Zero();
    std::optional<HandPull> pull;
    std::vector<int> some;
    std::array<int, 2> pair{};
    std::string name;
    bool late = false;

    friend bool operator==(const Specimen&, const Specimen&) = default;
};

enum class Flavour { Plain, Sweet };

constexpr auto fieldsOfSpecimen =
    fields<Specimen, field<&Specimen::number, Flavour::Sweet, Since{2}>, &Specimen::place,
           &Specimen::pull, &Specimen::some, &Specimen::pair, &Specimen::name,
           field<&Specimen::late, Compared::No>>;

} // namespace

} // namespace ripstop::test_fields

template <>
inline constexpr auto ripstop::fieldsOf<ripstop::test_fields::Specimen> =
    ripstop::test_fields::fieldsOfSpecimen;

namespace ripstop::test_fields {

namespace {

// What is left of the list without some of it is not all of it, whatever type the field has.
template <auto... members>
constexpr bool isWhole = areAllFields<Specimen, StructField<members>...>;

static_assert(isWhole<&Specimen::number, &Specimen::place, &Specimen::pull, &Specimen::some,
                      &Specimen::pair, &Specimen::name, &Specimen::late>);
static_assert(!isWhole<&Specimen::place, &Specimen::pull, &Specimen::some, &Specimen::pair,
                       &Specimen::name, &Specimen::late>);
static_assert(!isWhole<&Specimen::number, &Specimen::pull, &Specimen::some, &Specimen::pair,
                       &Specimen::name, &Specimen::late>);
static_assert(!isWhole<&Specimen::number, &Specimen::place, &Specimen::pull, &Specimen::some,
                       &Specimen::pair, &Specimen::name>);
static_assert(!isWhole<&Specimen::number, &Specimen::place, &Specimen::pull, &Specimen::some,
                       &Specimen::pair>);
static_assert(!isWhole<&Specimen::number, &Specimen::place, &Specimen::pull, &Specimen::some>);
static_assert(!isWhole<&Specimen::number, &Specimen::place, &Specimen::pull>);
static_assert(!isWhole<&Specimen::number, &Specimen::place>);
static_assert(!isWhole<&Specimen::number>);
static_assert(!isWhole<>);
static_assert(!isWhole<&Specimen::place, &Specimen::number, &Specimen::pull, &Specimen::some,
                       &Specimen::pair, &Specimen::name, &Specimen::late>); // another order

static_assert(areAllFields<HandNote::Halt>); // which has none
static_assert(!HasFields<Flavour> && HasFields<Specimen>);
static_assert(StructField<&Specimen::number>::mark(Flavour::Plain) == Flavour::Plain);
static_assert(StructField<&Specimen::number, Since{2}, Flavour::Sweet>::mark(Flavour::Plain)
              == Flavour::Sweet);

// Gives a value that it does not have.
void alter(Vec3& value) { value.x() += 1.0; }
void alter(Touched& touched) { ++touched.since; }
template <Plain T>
void alter(T& value)
{
    value = T(int(value) + 1);
}
template <typename T>
void alter(std::vector<T>& values)
{
    values.emplace_back();
}
template <typename T>
void alter(std::optional<T>& value)
{
    value.emplace();
}
template <typename T, std::size_t n>
void alter(std::array<T, n>& values)
{
    ++values.back();
}
void alter(ForceLists& lists) { std::get<LineLists>(lists).list.emplace_back(); }
template <HasFields T>
void alter(T& record)
{
    forEachField<T>([&](auto field) { alter(field.of(record)); });
}

QString named(std::string_view name)
{
    return QString::fromLatin1(name.data(), qsizetype(name.size()));
}

// Two values are equal when each compared field is, and the field that differs is named.
template <typename T>
QString wrongInComparison()
{
    QString wrong;
    forEachField<T>([&](auto field) {
        T other;
        alter(field.of(other));
        const bool counts = field.mark(Compared::Yes) == Compared::Yes;
        if ((other == T()) == counts || (differingField(other, T()) != field.name()) == counts)
            wrong += named(field.name()) + " ";
    });
    return wrong;
}

} // namespace

class TestFields : public QObject
{
    Q_OBJECT

private slots:
    void names()
    {
        QStringList all;
        forEachField<Specimen>([&](auto field) { all << named(field.name()); });
        QCOMPARE(all.join(' '), QString("number place pull some pair name late"));
    }

    void differing()
    {
        QCOMPARE(wrongInComparison<System>(), QString());
        QCOMPARE(wrongInComparison<State>(), QString());
        QCOMPARE(wrongInComparison<Hands>(), QString());
        System other;
        other.serial = 5;
        QVERIFY(other == System());
        Specimen late;
        late.late = true;
        QVERIFY(differingField(late, Specimen()).empty());
    }

    // Arrays keep their memory, all else is as in a new one.
    void clearing()
    {
        System system;
        alter(system);
        const std::size_t room = system.rods.capacity();
        QVERIFY(room > 0);
        clear(system);
        QVERIFY(system == System());
        QCOMPARE(system.serial, std::uint64_t(0));
        QCOMPARE(system.valuesSerial, std::uint64_t(0));
        QCOMPARE(system.touched.since, std::uint64_t(0));
        QCOMPARE(system.rods.capacity(), room);
    }

    // Numbers as the machine has them, lengths in eight bytes, a byte for what may be missing.
    void bytes()
    {
        Specimen sample;
        sample.number = 7;
        sample.place = Vec3(1.0, 2.0, 3.0);
        sample.some = {5, 6};
        sample.pair = {8, 9};
        sample.name = "ab";
        sample.late = true;
        std::string expected;
        const auto add = [&](const auto& value) {
            expected.append(reinterpret_cast<const char*>(&value), sizeof value);
        };
        for (const double x : {1.0, 2.0, 3.0})
            add(x);
        add(false);
        add(std::uint64_t(2));
        for (const int i : {5, 6, 8, 9})
            add(i);
        add(std::uint64_t(2));
        expected += "ab";
        add(true);

        ByteWriter first({}, 1); // when there was no number
        first(sample);
        const std::string before = first.take();
        QCOMPARE(before, expected);
        ByteWriter writer;
        writer(sample);
        const std::string now = writer.take();
        QCOMPARE(now.substr(sizeof(int)), expected);

        for (const int version : {1, newestVersion}) {
            Specimen read;
            ByteReader reader(version == 1 ? before : now, version);
            reader(read);
            QVERIFY(reader.ok() && reader.atEnd());
            QCOMPARE(read.number, version == 1 ? 0 : 7);
            read.number = 7;
            QVERIFY(read == sample);
        }
    }

    // Every field of a state is in a stretch. One of version 5 has no ramps of factors, one of
    // version 4 has neither the panels that wait at
    // a tear nor ramps of cloth, one of version 3 neither what BDF2 looks back to nor any ramps,
    // and one of version 2 has no work either.
    void recorded()
    {
        State state;
        alter(state);
        state.panelHold = {1.5}; // of one panel
        RunChunk chunk;
        chunk.start = std::make_shared<const State>(state);
        const std::string now = bytesOf(chunk);
        const std::optional<RunChunk> read = chunkOf(now);
        QVERIFY(read);
        QCOMPARE(named(differingField(*read->start, state)), QString());

        ByteWriter sixth({}, 6);
        sixth(std::uint64_t(1));
        sixth(state.factorRamps);
        const std::string till5 = now.substr(0, now.size() - sixth.take().size());
        const std::optional<RunChunk> beforeFactors = chunkOf(till5);
        QVERIFY(beforeFactors);
        QCOMPARE(named(differingField(*beforeFactors->start, state)), QString("factorRamps"));

        ByteWriter fifth({}, 5);
        fifth(std::uint64_t(1));
        fifth(state.panelHold);
        fifth(state.clothRamps);
        fifth(state.panelRamps);
        const std::string till4 = till5.substr(0, till5.size() - fifth.take().size());
        const std::optional<RunChunk> later = chunkOf(till4);
        QVERIFY(later);
        QCOMPARE(named(differingField(*later->start, state)), QString("panelHold"));
        QCOMPARE(later->start->panelHold, std::vector<double>(state.panelGone.size(), 0.0));
        QVERIFY(later->start->ramps == state.ramps);
        QVERIFY(later->start->clothRamps.empty() && later->start->panelRamps.empty());

        ByteWriter fourth({}, 4);
        fourth(std::uint64_t(1));
        fourth(state.velocityBefore);
        fourth(state.ramps);
        const std::string third = till4.substr(0, till4.size() - fourth.take().size());
        const std::optional<RunChunk> late = chunkOf(third);
        QVERIFY(late);
        State early = state;
        early.panelHold = late->start->panelHold;
        QCOMPARE(named(differingField(*late->start, early)), QString("ramps"));
        QVERIFY(late->start->velocityBefore == late->start->velocity);
        QVERIFY(late->start->ramps.empty());

        constexpr std::size_t works = sizeof(std::uint64_t) + 6 * sizeof(double);
        const std::optional<RunChunk> before = chunkOf(third.substr(0, third.size() - works));
        QVERIFY(before);
        QVERIFY(before->start->work == Work());
        QVERIFY(!chunkOf(now.substr(0, now.size() - 1)));
        QVERIFY(!chunkOf(third.substr(0, third.size() - 1)));
    }

    // The hash is of what is marked so and of nothing else.
    void hashed()
    {
        QStringList wrong;
        QStringList in;
        forEachField<State>([&](auto field) {
            State other;
            alter(field.of(other));
            const bool counts = field.mark(Hash::Out) == Hash::In;
            if ((stateHash(other) != stateHash(State())) != counts)
                wrong << named(field.name());
            if (counts)
                in << named(field.name());
        });
        QCOMPARE(wrong.join(' '), QString());
        QCOMPARE(in.join(' '), QString("step position velocity inputValue carried gusts springTorn "
                                       "rodTorn panelGone"));
    }

    // What is of the run goes over into a system that has nothing else of the old one.
    void carried()
    {
        State state;
        forEachPer<Per::Run>([](auto& value) { alter(value); }, state);
        state.tearHolds.clear(); // of links, of which there are none
        const State over = carryOver(System(), state, System());
        QCOMPARE(named(differingField(over, state)), QString());
    }
};

const RegisteredTest registered("test_fields", runPlain<TestFields>);

} // namespace ripstop::test_fields
#include "test_fields.moc"
