// A table of things in four stages: which rows and columns there are, from the property table;
// keys to sort by, taken out of the scene in one pass so that another thread can sort them; the
// text of a cell and the value that a text puts into it; and a pasted block, read cell by cell
// into one change for each property, which fails as a whole at the first cell that does not fit.
// Changed densities bring their masses (scene/weigh.h).
#include "select/sheet.h"

#include "scene/path.h"
#include "scene/typed_number.h"
#include "scene/weigh.h"
#include "select/rows_among.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace ripstop {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string numberText(double value)
{
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string nameOf(const Scene& scene, Id id)
{
    if (id == noId)
        return {};
    if (const auto thing = find(scene, id))
        if (const Property* name = findProperty(kindOf(*thing), Meaning::Name)) {
            const Value value = name->get(*thing);
            if (const auto* text = std::get_if<std::string>(&value); text && !text->empty())
                return *text;
        }
    return std::string(1, '#').append(std::to_string(std::uint32_t(id)));
}

// Things without a name of their own are told by number.
bool isNameless(const Property& property) { return property.pointsAt.contains(Kind::Particle); }

bool isNumber(const SheetColumn& column)
{
    if (!column.property || column.property->optional)
        return true;
    const Value& shape = column.property->initial;
    return std::holds_alternative<double>(shape) || std::holds_alternative<int>(shape)
           || std::holds_alternative<bool>(shape) || std::holds_alternative<Vec3>(shape);
}

double numberIn(const Value& value, int axis)
{
    if (const double* real = std::get_if<double>(&value))
        return *real;
    if (const int* whole = std::get_if<int>(&value))
        return *whole;
    if (const bool* on = std::get_if<bool>(&value))
        return *on ? 1.0 : 0.0;
    const Vec3* vector = std::get_if<Vec3>(&value);
    return vector ? (*vector)[axis] : none;
}

Result<Value> idNamed(const Scene& scene, const Property& property, std::string_view text)
{
    if (text.empty())
        return Value(noId);
    if (text.front() == '#') // an element, or an item
        return valueFromText(property, text);
    Message complaint;
    for (int kind = 0; kind < int(kindCount); ++kind)
        if (property.pointsAt.contains(Kind(kind))) {
            const auto found = findNamed(scene, Kind(kind), text);
            if (found)
                return Value(*found);
            complaint = found.message();
        }
    return Failure(complaint);
}

// Calls visit(thing, place) for all that are there of `ids`, which ascend. Tables are walked along
// with them: to look each one up would take the window 80 ms for 600 000 links.
template <typename Visit>
void forEachThing(const Scene& scene, Kind kind, const std::vector<Id>& ids, Visit visit)
{
    const auto visitRow = [&](const auto& row, std::size_t place) { visit(ConstRef(&row), place); };
    forEachPart(scene, [&](Id, const Part& part) {
        if (kind == Kind::Particle)
            forEachRowAmong(part.particles, ids, visitRow);
        if (kind == Kind::Link)
            forEachRowAmong(part.links, ids, visitRow);
        if (kind == Kind::Panel)
            forEachRowAmong(part.panels, ids, visitRow);
    });
    for (std::size_t i = 0; !isElement(kind) && i < ids.size(); ++i)
        if (const auto thing = find(scene, ids[i]))
            visit(*thing, i);
}

std::vector<std::string_view> splitAt(char mark, std::string_view text)
{
    std::vector<std::string_view> parts;
    for (std::size_t end; (end = text.find(mark)) != text.npos; text.remove_prefix(end + 1))
        parts.push_back(text.substr(0, end));
    parts.push_back(text);
    return parts;
}

std::vector<std::vector<std::string_view>> cellsOf(std::string_view block)
{
    while (block.ends_with('\n') || block.ends_with('\r'))
        block.remove_suffix(1);
    std::vector<std::vector<std::string_view>> cells;
    for (std::string_view line : splitAt('\n', block)) {
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        cells.push_back(splitAt('\t', line));
    }
    return cells;
}

Message titleOf(const SheetColumn& column)
{
    if (!column.property)
        return Message::verbatim("id");
    const Message title = Message::word(column.property->label);
    return std::holds_alternative<Vec3>(column.property->initial)
               ? Message("%1 %2", title, std::string(1, "xyz"[column.axis]))
               : title;
}

Failure refusedAt(std::size_t line, const SheetColumn& column, const Message& why)
{
    return Failure("Line %1, %2: %3", line + 1, titleOf(column), why);
}

Message counted(std::size_t count, const Message& one, const Message& many)
{
    return count == 1 ? one : many.with(count);
}

Message rows(std::size_t count) { return counted(count, Message("1 row"), Message("%1 rows")); }

} // namespace

Kind kindOf(SheetOf sheet)
{
    switch (sheet) {
    case SheetOf::Particles:
        return Kind::Particle;
    case SheetOf::Links:
    case SheetOf::Lines:
        return Kind::Link;
    case SheetOf::Panels:
        return Kind::Panel;
    case SheetOf::Materials:
        break;
    }
    return Kind::Material;
}

std::vector<SheetColumn> sheetColumns(SheetOf sheet)
{
    std::vector<SheetColumn> columns{{}};
    for (const Property& property : propertiesOf(kindOf(sheet))) {
        const int axes = std::holds_alternative<Vec3>(property.initial) ? 3 : 1;
        for (int axis = 0; axis < axes; ++axis)
            columns.push_back({&property, axis});
    }
    return columns;
}

std::vector<Id> sheetRows(const Scene& scene, SheetOf sheet)
{
    std::vector<Id> ids;
    if (sheet == SheetOf::Materials)
        for (const Entry& entry : scene.items)
            if (std::holds_alternative<Material>(entry.item))
                ids.push_back(entry.id);
    forEachPart(scene, [&](Id, const Part& part) {
        if (sheet == SheetOf::Particles)
            for (const Particle& row : part.particles)
                ids.push_back(row.id);
        if (sheet == SheetOf::Panels)
            for (const Panel& row : part.panels)
                ids.push_back(row.id);
        if (sheet == SheetOf::Links || sheet == SheetOf::Lines)
            for (const Link& row : part.links)
                if (sheet == SheetOf::Links || row.role == LinkRole::Line)
                    ids.push_back(row.id);
    });
    if (!std::ranges::is_sorted(ids))
        std::ranges::sort(ids);
    return ids;
}

SheetKeys sheetKeys(const Scene& scene, std::vector<Id> ids, const SheetColumn& column)
{
    SheetKeys keys{std::move(ids), {}, {}};
    const std::size_t count = keys.ids.size();
    if (!column.property) {
        keys.numbers.reserve(count);
        for (const Id id : keys.ids)
            keys.numbers.push_back(std::uint32_t(id));
        return keys;
    }
    const Property& property = *column.property;
    const bool isId = std::holds_alternative<Id>(property.initial);
    const bool byNumber = isNumber(column) || (isId && isNameless(property));
    if (byNumber)
        keys.numbers.assign(count, none);
    else
        keys.words.resize(count);
    std::map<Id, std::string> names; // many rows point at few things
    forEachThing(scene, property.kind, keys.ids, [&](const ConstRef& thing, std::size_t place) {
        const Value value = property.get(thing);
        const Id* other = std::get_if<Id>(&value);
        if (byNumber) {
            keys.numbers[place] =
                other ? double(std::uint32_t(*other)) : numberIn(value, column.axis);
        } else if (other) {
            auto [name, isNew] = names.try_emplace(*other);
            if (isNew)
                name->second = nameOf(scene, *other);
            keys.words[place] = name->second;
        } else {
            keys.words[place] = textFromValue(value);
        }
    });
    return keys;
}

std::vector<Id> sorted(SheetKeys keys, SheetOrder order)
{
    std::vector<std::uint32_t> rows(keys.ids.size());
    std::iota(rows.begin(), rows.end(), 0u);
    const bool falls = order == SheetOrder::Falling;
    if (keys.words.empty()) {
        const auto end = std::stable_partition(rows.begin(), rows.end(), [&](std::uint32_t row) {
            return std::isfinite(keys.numbers[row]);
        });
        std::stable_sort(rows.begin(), end, [&](std::uint32_t a, std::uint32_t b) {
            return falls ? keys.numbers[a] > keys.numbers[b] : keys.numbers[a] < keys.numbers[b];
        });
    } else {
        const auto end = std::stable_partition(
            rows.begin(), rows.end(), [&](std::uint32_t row) { return !keys.words[row].empty(); });
        std::stable_sort(rows.begin(), end, [&](std::uint32_t a, std::uint32_t b) {
            return falls ? keys.words[a] > keys.words[b] : keys.words[a] < keys.words[b];
        });
    }
    std::vector<Id> ids;
    ids.reserve(rows.size());
    for (const std::uint32_t row : rows)
        ids.push_back(keys.ids[row]);
    return ids;
}

std::string cellText(const Scene& scene, const ConstRef& thing, const SheetColumn& column)
{
    if (!column.property)
        return {};
    const Value value = column.property->get(thing);
    if (const Vec3* vector = std::get_if<Vec3>(&value))
        return numberText((*vector)[column.axis]);
    if (const Id* id = std::get_if<Id>(&value))
        return nameOf(scene, *id);
    return textFromValue(value);
}

Result<Value> cellValue(const Scene& scene, Id thing, const SheetColumn& column,
                        const Value& before, std::string_view text)
{
    if (!column.property)
        return Failure{"An id stays as it is."};
    const Property& property = *column.property;
    const auto ref = find(scene, thing);
    const std::string_view unit = ref ? unitOf(scene, property, *ref) : property.unit;
    const bool isSwitch = std::holds_alternative<bool>(property.initial);
    if (property.optional && text.find_first_not_of(" \t") == text.npos)
        return Value(std::monostate());
    if (std::holds_alternative<Id>(property.initial))
        return idNamed(scene, property, text);
    if (!isNumber(column) || isSwitch) {
        const auto value = valueFromText(property, text, unit);
        return value ? value : Result<Value>(Failure("%1.", value.message()));
    }
    const Typed typed = typedNumber(text, unit);
    const auto refused = [&](const Message& reason) {
        return Failure("\"%1\" is no %2, it %3.", text, Message::word(property.label), reason);
    };
    if (!typed.number)
        return refused(typed.complaint);
    Value value = changed(before, *typed.number, column.axis);
    if (const auto reason = refusal(property, value))
        return refused(*reason);
    return value;
}

Result<Edit> pasted(const Scene& scene, const std::vector<Id>& ids,
                    const std::vector<SheetColumn>& columns, std::string_view block)
{
    const auto cells = cellsOf(block);
    const bool isOne = cells.size() == 1 && cells[0].size() == 1;
    const std::size_t lines = isOne ? ids.size() : cells.size();
    if (lines > ids.size())
        return Failure("There are %1 to paste and %2 to take them; begin further up.",
                       counted(cells.size(), Message("1 line"), Message("%1 lines")),
                       rows(ids.size()));

    Edit edit{Message("Paste %1", rows(lines)), {}};
    std::vector<SetValues> changes; // one for each property
    for (std::size_t line = 0; line < lines; ++line) {
        const auto& row = isOne ? cells[0] : cells[line];
        const std::size_t width = isOne ? columns.size() : row.size();
        if (width > columns.size())
            return Failure("Line %1 has %2 and there are %3 to take them; begin further left.",
                           line + 1, counted(width, Message("1 cell"), Message("%1 cells")),
                           counted(columns.size(), Message("1 column"), Message("%1 columns")));
        for (std::size_t k = 0; k < width; ++k) {
            const SheetColumn& column = columns[k];
            if (!column.property)
                return refusedAt(line, column, Message("An id stays as it is."));
            const auto thing = find(scene, ids[line]);
            if (!thing)
                return refusedAt(line, column, Message("What is there was removed."));
            auto at = std::ranges::find(changes, column.property, &SetValues::property);
            if (at == changes.end())
                at = changes.insert(at, SetValues{column.property, {}, {}});
            SetValues& change = *at;
            const bool isNext = change.targets.empty() || change.targets.back() != ids[line];
            const Value before =
                isNext ? column.property->get(*thing) : change.values.back(); // another axis
            auto value = cellValue(scene, ids[line], column, before, row[isOne ? 0 : k]);
            if (!value)
                return refusedAt(line, column, value.message());
            if (isNext) {
                change.targets.push_back(ids[line]);
                change.values.push_back(std::move(*value));
            } else {
                change.values.back() = std::move(*value);
            }
        }
    }
    edit.changes.assign(std::make_move_iterator(changes.begin()),
                        std::make_move_iterator(changes.end()));
    return weighed(scene, edit);
}

} // namespace ripstop
