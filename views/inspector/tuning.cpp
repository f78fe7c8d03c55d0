// scrubbed() and stepped() choose how a number reacts by its type and range: whole numbers by ones,
// numbers that are never negative by factors, others by steps; results are rounded to what a person
// would type.
//
// numberTransform() makes a change of one double into a change of any value of numbers.
// makeSlider() makes a slider whose press, move and release are one gesture; vectors keep their
// direction and change their length, and have the last direction again on the way back from 0.
// Dragging keeps the values before, and each move is an edit from these.
#include "inspector/tuning.h"

#include "document/document.h"
#include "document/words.h"

#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>
#include <memory>

namespace ripstop {
namespace {

constexpr int sliderSteps = 400;

bool isNeverNegative(const Property& property) { return property.range.low >= 0.0; }

bool isWhole(const Property& property) { return std::holds_alternative<int>(property.initial); }

// Three digits are enough for a number that a hand drags.
double rounded(double value)
{
    if (value == 0.0 || !std::isfinite(value))
        return value;
    const double grid = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
    // through text, so that 0.3 is the 0.3 that people type
    return QString::number(std::round(value / grid) * grid, 'g', 3).toDouble();
}

// Removes the dust of binary sums, so that 0.1 + 0.2 is 0.3.
double exact(double value) { return QString::number(value, 'g', 12).toDouble(); }

// A vector that points into the direction, which is not 0 and has any length.
Vec3 ofLength(double length, const Vec3& direction)
{
    if (length == 0.0)
        return Vec3::Zero(); // without the -0 that a product has
    return direction * (length / direction.norm());
}

} // namespace

double scrubbed(const Property& property, double before, double distance)
{
    if (isWhole(property))
        return std::round(before + distance / 8.0);
    const auto range = property.usual;
    if (isNeverNegative(property) && property.range.high > 1.0 && before > 0.0)
        return rounded(before * std::exp2(distance / 100.0));
    if (isNeverNegative(property) && range && range->logarithmic)
        return distance > 0.0 ? valueAt(*range, distance / 500.0) : 0.0;
    const double step = range && property.range.high <= 1.0 ? 0.002 : 0.01;
    return exact(before + std::round(distance) * step);
}

double stepped(const Property& property, double before, int steps)
{
    if (isWhole(property))
        return before + steps;
    const double size =
        before == 0.0 ? 0.1 : std::pow(10.0, std::floor(std::log10(std::abs(before))) - 1.0);
    return exact(before + steps * size);
}

double clamped(const Property& property, double value)
{
    const Range& range = property.range;
    const double low = range.openLow ? std::nextafter(range.low, range.high) : range.low;
    return std::clamp(value, low, range.high);
}

Transform numberTransform(const Property& property, int axis, std::function<double(double)> change)
{
    return [&property, axis, change = std::move(change)](const Value& before) -> Value {
        if (const double* real = std::get_if<double>(&before))
            return clamped(property, change(*real));
        if (const int* whole = std::get_if<int>(&before))
            return int(std::lround(clamped(property, change(*whole))));
        if (const Vec3* vector = std::get_if<Vec3>(&before)) {
            Vec3 result = *vector;
            result[axis] = change(result[axis]);
            return result;
        }
        return before; // an absent number stays absent
    };
}

double magnitude(const Value& value)
{
    if (const Vec3* vector = std::get_if<Vec3>(&value))
        return vector->norm();
    if (const int* whole = std::get_if<int>(&value))
        return *whole;
    const double* real = std::get_if<double>(&value);
    return real ? *real : 0.0;
}

QSlider* makeSlider(Subject& subject, const Property& property, std::function<SliderRange()> range,
                    Snap snap)
{
    auto* bar = new QSlider(Qt::Horizontal);
    bar->setRange(0, sliderSteps);
    bar->setPageStep(sliderSteps / 20);
    bar->setSingleStep(sliderSteps / 100);
    bar->setFocusPolicy(Qt::TabFocus);
    bar->setAccessibleName(words("%1 slider").arg(labelOf(property)));
    bar->setToolTip(words("Drag to tune %1 while it flies.").arg(labelOf(property).toLower()));

    const auto dragging = std::make_shared<Dragging>(subject, property);
    QObject::connect(bar, &QSlider::sliderPressed, bar, [=] { dragging->begin(); });
    QObject::connect(bar, &QSlider::valueChanged, bar, [=](int position) {
        if (!bar->isSliderDown())
            dragging->begin(); // a key or a click beside the handle
        const auto snapped = snap && bar->isSliderDown() ? snap(position) : std::nullopt;
        dragging->moveTo(snapped ? *snapped : valueAt(range(), double(position) / sliderSteps));
    });
    return bar;
}

void showOn(QSlider& slider, const SliderRange& range, Subject& subject, const Property& property)
{
    subject.noteDirections(property);
    if (slider.isSliderDown())
        return;
    const auto first = find(subject.document().scene(), subject.ids().front());
    if (!first)
        return;
    const QSignalBlocker quiet(&slider);
    slider.setValue(
        int(std::lround(placeOf(range, magnitude(property.get(*first))) * sliderSteps)));
}

void Dragging::begin()
{
    m_before = m_subject.values(m_property);
    m_subject.noteDirections(m_property);
    m_directions = m_subject.directions(m_property);
    m_gesture = m_subject.document().beginGesture();
}

void Dragging::move(const Transform& fromBefore)
{
    std::vector<Value> values;
    values.reserve(m_before.size());
    for (const Value& value : m_before)
        values.push_back(fromBefore(value));
    m_subject.drag(m_property, std::move(values), m_gesture);
}

void Dragging::moveTo(double size)
{
    std::vector<Value> values;
    values.reserve(m_before.size());
    for (std::size_t i = 0; i < m_before.size(); ++i) {
        const Value& before = m_before[i];
        if (std::holds_alternative<Vec3>(before))
            values.push_back(ofLength(size, m_directions[i]));
        else if (std::holds_alternative<std::monostate>(before))
            values.push_back(clamped(m_property, size)); // it no longer follows the material
        else
            values.push_back(
                numberTransform(m_property, 0, [size](double) { return size; })(before));
    }
    m_subject.drag(m_property, std::move(values), m_gesture);
}

void Dragging::cancel() { m_subject.drag(m_property, m_before, m_gesture); }

} // namespace ripstop
