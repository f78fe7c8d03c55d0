// Turns what hands did into rows and back.
//
// 1. RowReader and append() go over the fields of a note in one order, the list in
//    base/hand_fields.h (jetOf() for a fan), so that reading and writing cannot differ.
// 2. The table `words` says for each word how many numbers follow it, how many of them are keys,
//    and how they are read; Writer gives the word and the numbers of each alternative.
// 3. handOf() finds the word, reads finite numbers to the end of the row, and checks their count
//    and the keys before the note is made, as RowReader itself checks nothing.
#include "io/hand_rows.h"

#include "base/hand_fields.h"
#include "io/csv.h"
#include "io/json_text.h"
#include "scene/property.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <type_traits>

namespace ripstop {
namespace {

using Numbers = std::vector<double>;

// A row has the numbers of a note in the order of its fields (base/hand_fields.h), and so it is
// written and read by these.
class RowReader
{
public:
    explicit RowReader(const Numbers& numbers)
        : m_next(numbers.begin())
    {}

    void take(double& number) { number = *m_next++; }
    void take(std::uint32_t& key) { key = std::uint32_t(*m_next++); }
    void take(Vec3& value)
    {
        for (int k = 0; k < 3; ++k)
            take(value[k]);
    }
    void take(std::array<std::uint32_t, 3>& keys)
    {
        for (std::uint32_t& key : keys)
            take(key);
    }
    template <HasFields T>
    void take(T& record)
    {
        forEachField<T>([&](auto field) { take(field.of(record)); });
    }

private:
    Numbers::const_iterator m_next;
};

void append(Numbers& numbers, double number) { numbers.push_back(number); }
void append(Numbers& numbers, const Vec3& v) { numbers.insert(numbers.end(), v.begin(), v.end()); }
void append(Numbers& numbers, const std::array<std::uint32_t, 3>& keys)
{
    numbers.insert(numbers.end(), keys.begin(), keys.end());
}
template <HasFields T>
void append(Numbers& numbers, const T& record)
{
    forEachField<T>([&](auto field) { append(numbers, field.of(record)); });
}

// How many numbers those are.
template <typename T>
constexpr std::size_t numbersIn()
{
    std::size_t sum = 0;
    if constexpr (HasFields<T>)
        forEachField<T>([&](auto field) { sum += numbersIn<TypeIn<T, decltype(field)>>(); });
    else
        sum = std::is_arithmetic_v<T> ? 1 : 3;
    return sum;
}

// What a row has of a fan, which is a jet.
template <typename Fan>
auto jetOf(Fan& fan)
{
    return std::tie(fan.origin, fan.velocity, fan.radius, fan.widening);
}

template <typename T>
HandNote::What noteOf(const Numbers& numbers)
{
    T note;
    RowReader(numbers).take(note);
    return note;
}

HandNote::What fanOf(const Numbers& numbers)
{
    Airflow fan;
    fan.kind = WindKind::Jet;
    RowReader row(numbers);
    std::apply([&](auto&... value) { (row.take(value), ...); }, jetOf(fan));
    return fan;
}

HandNote::What pinOf(const Numbers& numbers, bool holds)
{
    HandNote::Pin pin;
    RowReader(numbers).take(pin.particle);
    pin.holds = holds;
    return pin;
}

constexpr std::size_t ofCut = numbersIn<Cut::Edge>(); // for each point

HandNote::What cutOf(const Numbers& numbers)
{
    auto cut = std::make_shared<Cut>();
    cut->edges.resize(numbers.size() / ofCut);
    RowReader row(numbers);
    for (Cut::Edge& edge : cut->edges)
        row.take(edge);
    return std::shared_ptr<const Cut>(std::move(cut));
}

struct Word
{
    std::string_view word;
    std::size_t count;     // of numbers
    std::size_t keys;      // how many of them, at the start, are whole
    std::string_view what; // they are, for messages
    HandNote::What (*read)(const Numbers&);
};

// In the order of the alternatives of HandNote::What; a pin has two words.
const std::array words{
    Word{"@pull", numbersIn<HandPull>(), 3,
         "three particles, their shares, x, y, z, stiffness, damping, most force",
         noteOf<HandPull>},
    Word{"@let go", 0, 0, "nothing",
         [](const Numbers&) -> HandNote::What { return HandNote::LetGo{}; }},
    Word{"@pin", 1, 1, "a particle", [](const Numbers& numbers) { return pinOf(numbers, true); }},
    Word{"@unpin", 1, 1, "a particle",
         [](const Numbers& numbers) { return pinOf(numbers, false); }},
    Word{"@carry", numbersIn<Carry>(), 1, "a collider and x, y, z", noteOf<Carry>},
    Word{"@fan", 8, 0, "x, y, z, velocity x, y, z, radius, widening", fanOf},
    Word{"@fan off", 0, 0, "nothing",
         [](const Numbers&) -> HandNote::What { return HandNote::FanOff{}; }},
    Word{"@cut", ofCut, 0, "near x, y, z and far x, y, z of two or more points", cutOf},
    Word{"@halt", 0, 0, "nothing",
         [](const Numbers&) -> HandNote::What { return HandNote::Halt{}; }},
};

// The word and the numbers of each alternative.
struct Writer
{
    Numbers& n;

    std::string_view operator()(const HandPull& pull) const
    {
        append(n, pull);
        return "@pull";
    }
    std::string_view operator()(HandNote::LetGo) const { return "@let go"; }
    std::string_view operator()(const HandNote::Pin& pin) const
    {
        n.push_back(pin.particle);
        return pin.holds ? "@pin" : "@unpin";
    }
    std::string_view operator()(const Carry& carry) const
    {
        append(n, carry);
        return "@carry";
    }
    std::string_view operator()(const Airflow& fan) const
    {
        std::apply([&](const auto&... value) { (append(n, value), ...); }, jetOf(fan));
        return "@fan";
    }
    std::string_view operator()(HandNote::FanOff) const { return "@fan off"; }
    std::string_view operator()(const std::shared_ptr<const Cut>& cut) const
    {
        for (const Cut::Edge& edge : cut->edges)
            append(n, edge);
        return "@cut";
    }
    std::string_view operator()(HandNote::Halt) const { return "@halt"; }
};

std::string_view takeCell(std::string_view& row)
{
    const std::string_view cell = row.substr(0, row.find(','));
    row.remove_prefix(std::min(row.size(), cell.size() + 1));
    return cellContent(cell);
}

bool isKey(double number)
{
    return number >= 0.0 && number <= std::numeric_limits<std::uint32_t>::max()
           && number == std::floor(number);
}

bool fits(const Word& word, const Numbers& numbers)
{
    const bool several = word.count == ofCut;
    if (several ? numbers.size() < 2 * ofCut || numbers.size() % ofCut != 0
                : numbers.size() != word.count)
        return false;
    for (std::size_t i = 0; i < word.keys; ++i)
        if (!isKey(numbers[i]))
            return false;
    return true;
}

// So files have them: with another number a track is one of a later version.
static_assert(numbersIn<HandPull>() == 12 && numbersIn<Carry>() == 4 && ofCut == 6);

} // namespace

void appendHandRow(std::string& text, const HandNote::What& what)
{
    Numbers numbers;
    text += std::visit(Writer{numbers}, what);
    for (const double number : numbers) {
        text += ',';
        appendNumber(text, number);
    }
}

Result<HandNote::What> handOf(std::string_view row)
{
    const std::string_view name = takeCell(row);
    const Word* word = nullptr;
    std::vector<std::string_view> names;
    for (const Word& other : words) {
        names.push_back(other.word);
        if (other.word == name)
            word = &other;
    }
    if (!word) {
        const std::string_view near = nearest(name, names);
        return near.empty() ? Failure("a hand does not \"%1\".", name)
                            : Failure("a hand does not \"%1\"; did you mean \"%2\"?", name, near);
    }
    Numbers numbers;
    while (!cellContent(row).empty()) {
        const std::optional<double> number = cellNumber(takeCell(row));
        if (!number)
            return Failure("what follows %1 must be finite numbers.", name);
        numbers.push_back(*number);
    }
    if (!fits(*word, numbers))
        return Failure("what follows %1 must be %2.", name, word->what);
    return word->read(numbers);
}

} // namespace ripstop
