// In order: values as they are written; one change in words; the values of many elements together;
// and what differs, of one thing and of many.
#include "author/property_difference.h"

#include "scene/said_number.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ripstop {
namespace {

constexpr std::size_t longText = 60; // letters, that are no longer told
constexpr int wordDigits = 6;        // of a number

// --- values in words ------------------------------------------------------------------------

// How the numbers of a change are said: in one unit, which suits the largest of them.
struct Saying
{
    ReadableUnit unit;
    bool exactly = false; // for two that six digits cannot tell apart

    Message operator()(double number) const { return numberInWords(number / unit.factor, exactly); }
};

double largestIn(const Value& value)
{
    if (const auto* number = std::get_if<double>(&value))
        return std::abs(*number);
    if (const auto* vector = std::get_if<Vec3>(&value))
        return vector->cwiseAbs().maxCoeff();
    return 0.0;
}

// A value where it stands in its scene.
Message wordsOf(const Scene& scene, const Value& value, const Saying& say)
{
    if (const auto* number = std::get_if<double>(&value))
        return say(*number);
    if (const auto* v = std::get_if<Vec3>(&value))
        return Message("%1, %2, %3", say(v->x()), say(v->y()), say(v->z()));
    if (const auto* flag = std::get_if<bool>(&value))
        return *flag ? Message("yes") : Message("no");
    if (const auto* id = std::get_if<Id>(&value)) {
        if (*id == noId)
            return Message("none");
        const Item* item = findItem(scene, *id);
        return Message::verbatim(item ? nameOf(*item) : "#" + std::to_string(std::uint32_t(*id)));
    }
    if (std::holds_alternative<std::monostate>(value))
        return Message("none");
    const std::string text = textFromValue(value);
    return text.empty() ? Message("none") : Message::verbatim(text);
}

bool isTold(const Value& value)
{
    if (const auto* text = std::get_if<std::string>(&value))
        return text->size() <= longText && text->find('\n') == std::string::npos;
    return !std::holds_alternative<std::vector<Id>>(value)
           && !std::holds_alternative<NumberRows>(value);
}

// --- one difference in words ------------------------------------------------------------------

Message changeOf(const TwoScenes& scenes, const Message& subject, const Message& what,
                 const Value& from, const Value& to, const std::string& unit)
{
    if (!isTold(from) || !isTold(to))
        return Message("%1: %2 changed", subject, what);
    Saying say{readableUnit(std::max(largestIn(from), largestIn(to)), unit)};
    if (wordsOf(scenes.first, from, say) == wordsOf(scenes.second, to, say))
        say = {{1.0, unit}, true};
    return changeInWords(subject, what, wordsOf(scenes.first, from, say),
                         wordsOf(scenes.second, to, say), say.unit.name);
}

// Elements by their number, or one by its id.
Message subjectOf(Kind kind, const std::string& part, const std::vector<Id>& ids)
{
    const bool one = ids.size() == 1;
    const std::size_t n = one ? std::size_t(ids.front()) : ids.size();
    switch (kind) {
    case Kind::Particle:
        return one ? Message("%1, particle %2", part, n) : Message("%1, %2 particles", part, n);
    case Kind::Link:
        return one ? Message("%1, link %2", part, n) : Message("%1, %2 links", part, n);
    case Kind::Panel:
        return one ? Message("%1, panel %2", part, n) : Message("%1, %2 panels", part, n);
    default:
        return Message::verbatim(part);
    }
}

// --- properties -------------------------------------------------------------------------------

// Whether a thing of the first may be one of the second: it is, or nobody can tell.
bool mayBe(const ScenePairs& pairs, Id first, Id second)
{
    const auto found = pairs.secondOf.find(first);
    return found == pairs.secondOf.end() ? pairs.unknown.contains(first) || first == second
                                         : found->second == second;
}

bool mayBe(const ScenePairs& pairs, const std::vector<Id>& first, std::vector<Id> second)
{
    std::vector<Id> expected;
    for (const Id id : first) {
        if (pairs.unknown.contains(id))
            return true;
        const auto found = pairs.secondOf.find(id);
        expected.push_back(found == pairs.secondOf.end() ? id : found->second);
    }
    std::ranges::sort(expected);
    std::ranges::sort(second);
    return expected == second;
}

bool areSame(const ScenePairs& pairs, const Property& property, const ConstRef& a,
             const ConstRef& b)
{
    const Value first = property.get(a), second = property.get(b);
    if (const Id* id = std::get_if<Id>(&first))
        return mayBe(pairs, *id, std::get<Id>(second));
    if (const auto* ids = std::get_if<std::vector<Id>>(&first))
        return mayBe(pairs, *ids, std::get<std::vector<Id>>(second));
    return first == second;
}

// "x 1.1" where all numbers have changed by the same factor.
std::optional<double> commonFactor(const std::vector<Value>& from, const std::vector<Value>& to)
{
    std::optional<double> factor;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const auto* a = std::get_if<double>(&from[i]);
        const auto* b = std::get_if<double>(&to[i]);
        if (!a || !b || *a == 0.0)
            return std::nullopt;
        if (!factor)
            factor = *b / *a;
        if (std::abs(*b / *a - *factor) > 1e-9 * std::abs(*factor))
            return std::nullopt;
    }
    return factor;
}

struct Spread
{
    double low = INFINITY;
    double high = -INFINITY;

    double largest() const { return std::max(std::abs(low), std::abs(high)); }
};

// Nothing where they are no numbers.
std::optional<Spread> spreadOf(const std::vector<Value>& values)
{
    Spread spread;
    for (const Value& value : values) {
        const auto* number = std::get_if<double>(&value);
        if (!number)
            return std::nullopt;
        spread.low = std::min(spread.low, *number);
        spread.high = std::max(spread.high, *number);
    }
    return spread;
}

// "0.1 to 0.3".
Message wordsOf(const Spread& spread, const Saying& say)
{
    return spread.low == spread.high ? say(spread.low)
                                     : Message("%1 to %2", say(spread.low), say(spread.high));
}

Message farthest(const Message& subject, const std::vector<Value>& from,
                 const std::vector<Value>& to)
{
    double most = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i)
        most = std::max(most, (std::get<Vec3>(to[i]) - std::get<Vec3>(from[i])).norm());
    return Message("%1: moved by up to %2", subject, saidNumber(most, "m", wordDigits));
}

Message changeOfMany(const TwoScenes& scenes, const Property& property, const Message& subject,
                     const std::vector<Value>& from, const std::vector<Value>& to)
{
    const Message what = Message::word(property.label);
    const auto allAlike = [](const std::vector<Value>& values) {
        return std::ranges::all_of(values, [&](const Value& v) { return v == values.front(); });
    };
    if (isOneOf<&Particle::position>(property))
        return farthest(subject, from, to);
    if (allAlike(from) && allAlike(to))
        return changeOf(scenes, subject, what, from.front(), to.front(),
                        std::string(property.unit));
    if (const auto factor = commonFactor(from, to))
        return Message("%1: %2 x %3", subject, what, numberInWords(*factor));
    const auto before = spreadOf(from), after = spreadOf(to);
    if (!before || !after)
        return Message("%1: %2 changed", subject, what);
    const Saying say{readableUnit(std::max(before->largest(), after->largest()), property.unit)};
    const Message first = wordsOf(*before, say), second = wordsOf(*after, say);
    if (first != second)
        return changeInWords(subject, what, first, second, say.unit.name);
    return Message("%1: %2 changed", subject, what);
}

} // namespace

Message numberInWords(double number, bool exactly)
{
    if (!exactly)
        return Message::number(plainNumber(number, wordDigits));
    char text[32];
    return Message::number({text, std::to_chars(text, text + sizeof text, number).ptr});
}

Message changeInWords(const Message& subject, const Message& what, const Message& from,
                      const Message& to, const std::string& unit)
{
    return unit.empty() ? Message("%1: %2 %3 -> %4", subject, what, from, to)
                        : Message("%1: %2 %3 -> %4 %5", subject, what, from, to, unit);
}

Message changeOfNumber(const Message& subject, const Message& what, double from, double to,
                       const std::string& unit)
{
    const auto size = [](double number) { return std::isnan(number) ? 0.0 : std::abs(number); };
    const Saying say{readableUnit(std::max(size(from), size(to)), unit)};
    const auto words = [&](double number) {
        return std::isnan(number) ? Message("none") : say(number);
    };
    return changeInWords(subject, what, words(from), words(to), say.unit.name);
}

void compareThing(Differences& list, const TwoScenes& scenes, const std::string& name, Id idFirst,
                  Id idSecond, const ConstRef& a, const ConstRef& b)
{
    const Kind kind = kindOf(a);
    const Message subject = kind == Kind::Settings ? Message("Settings") : Message::verbatim(name);
    for (const Property& property : propertiesOf(kind)) {
        if (isOneOf<&Part::builder>(property) || areSame(scenes.pairs, property, a, b))
            continue; // the builder is told with its parameters
        const Value from = property.get(a), to = property.get(b);
        const std::string unit(property.unit);
        list.push_back({DifferenceKind::Property,
                        kind,
                        name,
                        std::string(property.key),
                        unit,
                        from,
                        to,
                        {idFirst},
                        {idSecond},
                        changeOf(scenes, subject, Message::word(property.label), from, to, unit)});
    }
}

template <typename Row>
void compareRows(Differences& list, const TwoScenes& scenes, const std::string& part,
                 const RowPairs<Row>& rows)
{
    for (const Property& property : propertiesOf(kindOfType<Row>)) {
        std::vector<Value> from, to;
        std::vector<Id> inFirst, inSecond;
        for (const auto& [a, b] : rows) {
            if (areSame(scenes.pairs, property, a, b))
                continue;
            from.push_back(property.get(a));
            to.push_back(property.get(b));
            inFirst.push_back(a->id);
            inSecond.push_back(b->id);
        }
        if (from.empty())
            continue;
        const auto common = [](const std::vector<Value>& values) {
            const auto differs = [&](const Value& value) { return value != values.front(); };
            return std::ranges::any_of(values, differs) ? Value() : values.front();
        };
        const Message subject = subjectOf(kindOfType<Row>, part, inFirst);
        list.push_back({DifferenceKind::Property, kindOfType<Row>, part, std::string(property.key),
                        std::string(property.unit), common(from), common(to), inFirst, inSecond,
                        changeOfMany(scenes, property, subject, from, to)});
    }
}

template void compareRows(Differences&, const TwoScenes&, const std::string&,
                          const RowPairs<Particle>&);
template void compareRows(Differences&, const TwoScenes&, const std::string&,
                          const RowPairs<Link>&);
template void compareRows(Differences&, const TwoScenes&, const std::string&,
                          const RowPairs<Panel>&);

} // namespace ripstop
