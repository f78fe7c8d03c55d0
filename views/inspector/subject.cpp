// refs() finds the things again for each question, as an edit may have moved them. common() walks
// over their values and stops when everything is known to differ.
//
// edit() and drag() make one edit for all things: values that are all alike are stored once, and
// weighed() adds the masses that follow from a new density. pick() only notes the property; the
// inspector does the rest.
#include "inspector/subject.h"

#include "derived/thread_fabric.h"
#include "document/document.h"
#include "document/edit_words.h"
#include "document/words.h"
#include "scene/weigh.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

bool isSame(const Value& a, const Value& b)
{
    const double* first = std::get_if<double>(&a);
    const double* second = std::get_if<double>(&b);
    return first && second ? readAlike(*first, *second) : a == b;
}

} // namespace

Transform setTo(Value value)
{
    return [value = std::move(value)](const Value&) { return value; };
}

Transform transformOf(TypedNumber typed, int axis)
{
    return [typed, axis](const Value& before) { return changed(before, typed, axis); };
}

Subject::Subject(Document& document, LastDirections& directions)
    : m_document(document)
    , m_directions(directions)
    , m_ids{settingsId}
{}

void Subject::set(Kind kind, std::vector<Id> ids)
{
    m_kind = kind;
    m_ids = std::move(ids);
}

std::vector<ConstRef> Subject::refs() const
{
    std::vector<ConstRef> result;
    const Census all = census(m_document.scene(), m_ids);
    for (const Census::Found& found : all[m_kind])
        result.push_back(found.ref);
    return result;
}

std::vector<Value> Subject::values(const Property& property) const
{
    std::vector<Value> result;
    for (const ConstRef& ref : refs())
        result.push_back(property.get(ref));
    return result;
}

std::vector<Vec3> Subject::directions(const Property& property) const
{
    std::vector<Vec3> result;
    result.reserve(m_ids.size());
    for (const Id id : m_ids)
        result.push_back(m_directions.of(property, id));
    return result;
}

void Subject::noteDirections(const Property& property)
{
    if (!std::holds_alternative<Vec3>(property.initial))
        return;
    for (const Id id : m_ids)
        if (const auto ref = find(m_document.scene(), id))
            m_directions.note(property, id, property.get(*ref));
}

bool readAlike(double a, double b)
{
    constexpr double halfOfLastDigit = 5e-7; // of six that fields have
    return a == b || std::abs(a - b) <= halfOfLastDigit * std::max(std::abs(a), std::abs(b));
}

Common Subject::common(const Property& property, const std::vector<ConstRef>& refs)
{
    Common common;
    if (refs.empty())
        return common;
    common.value = property.get(refs.front());
    common.isDefault = common.value == property.initial;
    const Vec3* first = std::get_if<Vec3>(&common.value);
    for (std::size_t i = 1; i < refs.size(); ++i) {
        const Value value = property.get(refs[i]);
        common.isDefault = common.isDefault && value == property.initial;
        if (first)
            for (int axis = 0; axis < 3; ++axis)
                common.mixed[std::size_t(axis)] |=
                    !readAlike((*first)[axis], std::get<Vec3>(value)[axis]);
        else
            common.mixed[0] = common.mixed[0] || !isSame(common.value, value);
        if (!common.isDefault && common.mixed[0]
            && (!first || (common.mixed[1] && common.mixed[2])))
            break;
    }
    return common;
}

std::optional<QString> Subject::refusal(const Property& property, const Transform& transform) const
{
    for (const Value& value : values(property))
        if (const auto reason = ripstop::refusal(property, transform(value)))
            return translated(*reason);
    return std::nullopt;
}

Edit Subject::settingOf(const Property& property, std::vector<Value> values) const
{
    const bool same = std::all_of(values.begin(), values.end(),
                                  [&](const Value& value) { return value == values.front(); });
    if (same)
        values.resize(1);
    const Edit edit =
        threaded(m_document.scene(), {settingLabel(m_document.scene(), property, m_ids, values),
                                      {SetValues{&property, m_ids, std::move(values)}}});
    // weighed() fails where a particle would be left without mass; then only the value itself is
    // set.
    const Result<Edit> withMasses = weighed(m_document.scene(), edit);
    return withMasses ? *withMasses : edit;
}

void Subject::edit(const Property& property, const Transform& transform)
{
    const std::vector<Value> before = values(property);
    std::vector<Value> after;
    after.reserve(before.size());
    for (const Value& value : before)
        after.push_back(transform(value));
    if (after != before)
        m_document.push(settingOf(property, std::move(after)));
}

void Subject::drag(const Property& property, std::vector<Value> values, int gesture)
{
    if (!values.empty() && values.size() == m_ids.size())
        m_document.drag(settingOf(property, std::move(values)), gesture);
}

void Subject::pick(const Property& property)
{
    m_picking = &property;
    emit pickingChanged();
}

void Subject::cancelPick()
{
    m_picking = nullptr;
    emit pickingChanged();
}

} // namespace ripstop
