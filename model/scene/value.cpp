// Values: what a property accepts, and how people write them.
// 1. Small readers take numbers, ids, lists and tables from text.
// 2. reading() has an overload for each type of value; it says what a text means there, or what it
//    should have been.
// 3. refusal() checks a value against its row: type, range, choices, colours, paths and polars.
// 4. valueFromText() reads and then refuses in one call; textFromValue() writes what it would
//    read.
// 5. nearest() finds the word that a misspelt one may be meant for.
#include "scene/property.h"

#include "scene/collider_path.h"
#include "scene/typed_number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

std::string number(double value)
{
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::optional<double> toNumber(std::string_view text)
{
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

std::string_view trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string_view> splitAt(char separator, std::string_view text)
{
    std::vector<std::string_view> parts;
    for (;;) {
        const auto comma = text.find(separator);
        parts.push_back(trimmed(text.substr(0, comma)));
        if (comma == std::string_view::npos)
            return parts;
        text.remove_prefix(comma + 1);
    }
}

std::optional<Id> toId(std::string_view text)
{
    if (text.starts_with('#')) // as in paths
        text.remove_prefix(1);
    const std::optional<double> value = toNumber(text);
    if (!value || *value < 0.0 || *value > 4294967295.0 || *value != std::floor(*value))
        return std::nullopt;
    return Id{std::uint32_t(*value)};
}

// The unit of "5 km/h"; empty for a number alone, and where more is to be worked out.
std::string_view behindNumber(std::string_view text)
{
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const std::string_view rest = trimmed({end, std::size_t(text.data() + text.size() - end)});
    const bool isUnit =
        error == std::errc() && rest.find_first_of("+-*^()") == rest.npos && !rest.starts_with('/');
    return isUnit ? rest : std::string_view();
}

std::string joined(std::span<const std::string_view> words)
{
    std::string text;
    for (const std::string_view word : words)
        text += (text.empty() ? "" : ", ") + std::string(word);
    return text;
}

std::optional<Message> outside(const Range& range, double value)
{
    if (!std::isfinite(value))
        return Message("must be a finite number");
    const Message low = Message::number(number(range.low));
    if (value < range.low || (range.openLow && value == range.low))
        return range.openLow ? Message("must be above %1", low)
                             : Message("must be at least %1", low);
    if (value > range.high)
        return Message("must be at most %1", Message::number(number(range.high)));
    return std::nullopt;
}

Message mustBeLike(const Value& value)
{
    static const std::array<Message, 9> byType{
        Message("must be nothing"),         Message("must be true or false"),
        Message("must be a whole number"),  Message("must be a number"),
        Message("must be a text"),          Message("must be three numbers"),
        Message("must be an id"),           Message("must be a list of ids"),
        Message("must be rows of numbers"),
    };
    return byType[value.index()];
}

std::optional<Message> refusalOfRows(const Property& property, const NumberRows& table)
{
    if (table.empty())
        return Message("needs a row");
    double last = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < table.size(); ++i) {
        const std::vector<double>& row = table[i];
        if (row.size() != std::size_t(property.columns))
            return Message("must have %1 numbers in each row (row %2)", property.columns, i + 1);
        if (!std::ranges::all_of(row, [](double value) { return std::isfinite(value); }))
            return Message("must be finite numbers (row %1)", i + 1);
        if (property.meaning == Meaning::Times) {
            if (row[0] <= last)
                return Message("must have times that rise from row to row (row %1)", i + 1);
            last = row[0];
        }
        if (property.meaning != Meaning::Polar)
            continue;
        if (row[0] < 0.0 || row[0] > 90.0 || row[0] <= last)
            return Message("must have angles that rise from row to row, between 0 and 90 (row %1)",
                           i + 1);
        if (row[2] < 0.0) // the wind would gain energy
            return Message("must have drag of at least 0 (row %1)", i + 1);
        last = row[0];
    }
    return std::nullopt;
}

bool readNumbers(std::string_view text, std::vector<double>& numbers)
{
    for (const std::string_view part : splitAt(',', text)) {
        const auto read = toNumber(part);
        if (!read)
            return false;
        numbers.push_back(*read);
    }
    return true;
}

bool isColor(std::string_view text)
{
    return text.size() == 7 && text[0] == '#'
           && text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string_view::npos;
}

// What a text means where a type of value is wanted. Without a value and without a complaint, the
// message names that type.
struct Reading
{
    std::optional<Value> value;
    Message complaint = {};
};

// How numbers are typed.
struct HowTyped
{
    std::string_view unit; // of those that bring none
    ThreeDigits behindComma;
};

Reading reading(bool, std::string_view text, const HowTyped&)
{
    if (text == "true" || text == "yes" || text == "1")
        return {true};
    if (text == "false" || text == "no" || text == "0")
        return {false};
    return {};
}

Reading reading(double, std::string_view text, const HowTyped& how)
{
    if (const auto plain = toNumber(text)) // reads infinities too, which refusal() names
        return {*plain};
    const Typed typed = typedValue(text, how.unit, how.behindComma);
    return typed.number ? Reading{typed.number->number} : Reading{{}, typed.complaint};
}

Reading reading(int, std::string_view text, const HowTyped& how)
{
    const Reading read = reading(0.0, text, how);
    const double* number = read.value ? std::get_if<double>(&*read.value) : nullptr;
    if (!number || *number != std::floor(*number) || std::abs(*number) >= 2e9)
        return {};
    return {int(*number)};
}

Reading reading(const std::string&, std::string_view text, const HowTyped&)
{
    return {std::string(text)};
}

Reading reading(const Vec3&, std::string_view text, const HowTyped& how)
{
    const auto parts = splitAt(',', text);
    if (parts.size() != 3)
        return {};
    // "20, 0, 5 km/h": the only unit, behind the last number, is that of all.
    std::string unitOfAll;
    if (toNumber(parts[0]) && toNumber(parts[1]))
        unitOfAll = behindNumber(parts[2]);
    Vec3 vector;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string number = std::string(parts[i]) + (i < 2 ? unitOfAll : "");
        const Reading part = reading(0.0, number, how);
        if (!part.value)
            return {{}, part.complaint == Message("must be a number") ? Message() : part.complaint};
        vector[Eigen::Index(i)] = std::get<double>(*part.value);
    }
    return {vector};
}

Reading reading(Id, std::string_view text, const HowTyped&)
{
    if (text.empty())
        return {noId};
    const auto id = toId(text);
    return id ? Reading{*id} : Reading{};
}

Reading reading(const std::vector<Id>&, std::string_view text, const HowTyped&)
{
    std::vector<Id> ids;
    if (!text.empty())
        for (const std::string_view part : splitAt(',', text)) {
            const auto id = toId(part);
            if (!id)
                return {};
            ids.push_back(*id);
        }
    return {ids};
}

Reading reading(const NumberRows&, std::string_view text, const HowTyped&)
{
    NumberRows table;
    if (text.ends_with(';')) // a separator may end the last row
        text.remove_suffix(1);
    for (const std::string_view part : splitAt(';', text))
        if (!readNumbers(part, table.emplace_back()))
            return {};
    return {std::move(table)};
}

Reading reading(std::monostate, std::string_view, const HowTyped&) { return {}; }

} // namespace

std::optional<Message> refusal(const Property& property, const Value& value)
{
    if (std::holds_alternative<std::monostate>(value))
        return property.optional ? std::nullopt : std::optional(Message("needs a value"));
    const bool sameType = property.optional ? std::holds_alternative<double>(value)
                                            : value.index() == property.initial.index();
    if (!sameType)
        return property.optional ? Message("must be a number") : mustBeLike(property.initial);

    if (const auto* real = std::get_if<double>(&value))
        return outside(property.range, *real);
    if (const auto* whole = std::get_if<int>(&value))
        return outside(property.range, *whole);
    if (const auto* vector = std::get_if<Vec3>(&value); vector && !vector->allFinite())
        return Message("must be three finite numbers");
    if (const auto* table = std::get_if<NumberRows>(&value))
        return refusalOfRows(property, *table);
    if (const auto* text = std::get_if<std::string>(&value)) {
        const auto choices = property.choices;
        if (!choices.empty() && std::find(choices.begin(), choices.end(), *text) == choices.end())
            return Message("must be one of %1", joined(choices));
        if (property.meaning == Meaning::Color && !isColor(*text))
            return Message("must be a colour as #rrggbb");
        if (property.meaning == Meaning::Path)
            if (const auto path = pathFromText(*text); !path)
                return path.message();
    }
    return std::nullopt;
}

std::string_view unitOf(const Scene& scene, const Property& property, const ConstRef& ref)
{
    if (!isOneOf<&Link::tearLimit, &Material::tearLimit>(property))
        return property.unit;
    const Material* material = nullptr;
    if (const auto* own = std::get_if<const Material*>(&ref))
        material = *own;
    else if (const auto* link = std::get_if<const Link*>(&ref))
        material = findItem<Material>(scene, (*link)->material);
    const TearRule rule = material ? material->tearRule : TearRule::Never;
    const bool isOfLink = std::holds_alternative<const Link*>(ref);
    switch (rule) {
    case TearRule::Length:
        return "m";
    case TearRule::Force:
        return "N";
    case TearRule::Tension:
        return isOfLink ? "N" : "N/m";
    case TearRule::Strength: // a material has its strengths for it
    case TearRule::Energy:
        return isOfLink ? "N" : "";
    case TearRule::Never:
    case TearRule::Strain:
        break;
    }
    return "";
}

Result<Value> valueFromText(const Property& property, std::string_view text)
{
    return valueFromText(property, text, property.unit);
}

Result<Value> valueFromText(const Property& property, std::string_view text, std::string_view unit,
                            ThreeDigits behindComma)
{
    text = trimmed(text);
    if (property.optional && text.empty())
        return Value(std::monostate());

    const Value shape = property.optional ? Value(0.0) : property.initial;
    const HowTyped how{unit, behindComma};
    const Reading read =
        std::visit([&](const auto& kind) { return reading(kind, text, how); }, shape);
    const auto refused = [&](const Message& reason) {
        return Failure("%1.%2 %3, not \"%4\"", Message::word(kindName(property.kind)), property.key,
                       reason, text);
    };
    if (!read.value)
        return refused(read.complaint.empty() ? mustBeLike(shape) : read.complaint);
    if (const auto reason = refusal(property, *read.value))
        return refused(*reason);
    return *read.value;
}

std::string textFromValue(const Value& value)
{
    struct Writer
    {
        std::string operator()(std::monostate) const { return {}; }
        std::string operator()(bool b) const { return b ? "true" : "false"; }
        std::string operator()(int i) const { return std::to_string(i); }
        std::string operator()(double d) const { return number(d); }
        std::string operator()(const std::string& s) const { return s; }
        std::string operator()(const Vec3& v) const
        {
            return number(v.x()) + ", " + number(v.y()) + ", " + number(v.z());
        }
        std::string operator()(Id id) const { return std::to_string(std::uint32_t(id)); }
        std::string operator()(const std::vector<Id>& ids) const
        {
            std::string text;
            for (const Id id : ids)
                text += (text.empty() ? "" : ", ") + (*this)(id);
            return text;
        }
        std::string operator()(const NumberRows& table) const
        {
            std::string text;
            for (const std::vector<double>& row : table)
                for (std::size_t i = 0; i < row.size(); ++i)
                    text += (i > 0 ? ", " : text.empty() ? "" : "; ") + number(row[i]);
            return text;
        }
    };
    return std::visit(Writer{}, value);
}

std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates)
{
    // Levenshtein distance; a third of the letters may be wrong.
    std::string_view best;
    std::size_t bestDistance = word.size() / 3 + 2;
    std::vector<std::size_t> row;
    for (const std::string_view candidate : candidates) {
        row.resize(candidate.size() + 1);
        for (std::size_t j = 0; j <= candidate.size(); ++j)
            row[j] = j;
        for (std::size_t i = 1; i <= word.size(); ++i) {
            std::size_t diagonal = row[0];
            row[0] = i;
            for (std::size_t j = 1; j <= candidate.size(); ++j) {
                const std::size_t change = diagonal + (word[i - 1] != candidate[j - 1]);
                diagonal = row[j];
                row[j] = std::min({change, row[j] + 1, row[j - 1] + 1});
            }
        }
        if (row.back() < bestDistance) {
            bestDistance = row.back();
            best = candidate;
        }
    }
    return best;
}

} // namespace ripstop
