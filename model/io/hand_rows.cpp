#include "io/hand_rows.h"

#include "io/json_text.h"
#include "scene/property.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace ripstop {
namespace {

using Numbers = std::vector<double>;

Vec3 vectorAt(const Numbers& numbers, std::size_t i)
{
    return {numbers[i], numbers[i + 1], numbers[i + 2]};
}

void append(Numbers& numbers, const Vec3& v)
{
    for (int k = 0; k < 3; ++k)
        numbers.push_back(v[k]);
}

std::uint32_t keyOf(double number) { return std::uint32_t(number); }

HandNote::What pullOf(const Numbers& n)
{
    HandPull pull;
    for (std::size_t i = 0; i < 3; ++i)
        pull.grip.particle[i] = keyOf(n[i]);
    pull.grip.share = vectorAt(n, 3);
    pull.to = vectorAt(n, 6);
    pull.stiffness = n[9];
    pull.damping = n[10];
    pull.most = n[11];
    return pull;
}

HandNote::What fanOf(const Numbers& n)
{
    Airflow fan;
    fan.kind = WindKind::Jet;
    fan.origin = vectorAt(n, 0);
    fan.velocity = vectorAt(n, 3);
    fan.radius = n[6];
    fan.widening = n[7];
    return fan;
}

HandNote::What cutOf(const Numbers& n)
{
    auto cut = std::make_shared<Cut>();
    for (std::size_t i = 0; i + 6 <= n.size(); i += 6)
        cut->edges.push_back({vectorAt(n, i), vectorAt(n, i + 3)});
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

constexpr std::size_t ofCut = 6; // for each point

// In the order of the alternatives of HandNote::What; a pin has two words.
const std::array words{
    Word{"@pull", 12, 3, "three particles, their shares, x, y, z, stiffness, damping, most force",
         pullOf},
    Word{"@let go", 0, 0, "nothing",
         [](const Numbers&) -> HandNote::What { return HandNote::LetGo{}; }},
    Word{"@pin", 1, 1, "a particle",
         [](const Numbers& n) -> HandNote::What {
             return HandNote::Pin{keyOf(n[0]), true};
         }},
    Word{"@unpin", 1, 1, "a particle",
         [](const Numbers& n) -> HandNote::What {
             return HandNote::Pin{keyOf(n[0]), false};
         }},
    Word{"@carry", 4, 1, "a collider and x, y, z",
         [](const Numbers& n) -> HandNote::What {
             return Carry{keyOf(n[0]), vectorAt(n, 1)};
         }},
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
        for (const std::uint32_t key : pull.grip.particle)
            n.push_back(key);
        append(n, pull.grip.share);
        append(n, pull.to);
        n.insert(n.end(), {pull.stiffness, pull.damping, pull.most});
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
        n.push_back(carry.collider);
        append(n, carry.way);
        return "@carry";
    }
    std::string_view operator()(const Airflow& fan) const
    {
        append(n, fan.origin);
        append(n, fan.velocity);
        n.insert(n.end(), {fan.radius, fan.widening});
        return "@fan";
    }
    std::string_view operator()(HandNote::FanOff) const { return "@fan off"; }
    std::string_view operator()(const std::shared_ptr<const Cut>& cut) const
    {
        for (const Cut::Edge& edge : cut->edges) {
            append(n, edge.near);
            append(n, edge.far);
        }
        return "@cut";
    }
    std::string_view operator()(HandNote::Halt) const { return "@halt"; }
};

std::string_view trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t\r\"");
    return first == std::string_view::npos
               ? std::string_view()
               : text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

std::optional<double> numberOf(std::string_view text)
{
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::string_view takeCell(std::string_view& row)
{
    const std::string_view cell = row.substr(0, row.find(','));
    row.remove_prefix(std::min(row.size(), cell.size() + 1));
    return trimmed(cell);
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
    while (!trimmed(row).empty()) {
        const std::optional<double> number = numberOf(takeCell(row));
        if (!number)
            return Failure("what follows %1 must be finite numbers.", name);
        numbers.push_back(*number);
    }
    if (!fits(*word, numbers))
        return Failure("what follows %1 must be %2.", name, word->what);
    return word->read(numbers);
}

} // namespace ripstop
