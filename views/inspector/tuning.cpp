#include "inspector/tuning.h"

#include "document/document.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ripstop {
namespace {

using enum Tuning::Scale;

// clang-format off
constexpr std::array tunings{
    Tuning{Kind::Settings, "substeps",          Logarithmic, 1.0,  64.0},
    Tuning{Kind::Settings, "sweeps",            Logarithmic, 1.0,  256.0},
    Tuning{Kind::Settings, "airDensity",        Linear,      0.0,  2.0},
    Tuning{Kind::Settings, "viscosity",         Linear,      0.0,  5.0},
    Tuning{Kind::Material, "stiffness",         Logarithmic, 1.0,  1e5},
    Tuning{Kind::Material, "damping",           Logarithmic, 1e-3, 10.0},
    Tuning{Kind::Material, "compliance",        Logarithmic, 1e-8, 1e-2},
    Tuning{Kind::Material, "tearLimit",         Logarithmic, 1e-2, 1e3},
    Tuning{Kind::Material, "normalCoefficient", Linear,      0.0,  4.0},
    Tuning{Kind::Material, "skinFriction",      Linear,      0.0,  0.2},
    Tuning{Kind::Material, "porosity",          Linear,      0.0,  0.2},
    Tuning{Kind::Collider, "restitution",       Linear,      0.0,  1.0},
    Tuning{Kind::Collider, "thickness",         Linear,      0.0,  0.05},
    Tuning{Kind::Collider, "hillLength",        Logarithmic, 0.02, 2.0},
    Tuning{Kind::Collider, "friction",          Linear,      0.0,  1.5},
    Tuning{Kind::Wind,     "velocity",          Linear,      0.0,  25.0},
    Tuning{Kind::Wind,     "gustiness",         Linear,      0.0,  25.0},
};
// clang-format on

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

// Without the dust of binary sums.
double exact(double value) { return QString::number(value, 'g', 12).toDouble(); }

} // namespace

const Tuning* tuningOf(const Property& property)
{
    const auto found = std::find_if(tunings.begin(), tunings.end(), [&](const Tuning& t) {
        return t.kind == property.kind && t.key == property.key;
    });
    return found == tunings.end() ? nullptr : &*found;
}

double valueAt(const Tuning& tuning, double place)
{
    if (tuning.scale == Linear)
        return rounded(tuning.low + place * (tuning.high - tuning.low));
    const bool hasZero = tuning.low < 1.0;
    return hasZero && place <= 0.0
               ? 0.0
               : rounded(tuning.low * std::pow(tuning.high / tuning.low, place));
}

double placeOf(const Tuning& tuning, double value)
{
    if (tuning.scale == Linear)
        return std::clamp((value - tuning.low) / (tuning.high - tuning.low), 0.0, 1.0);
    if (value <= tuning.low)
        return 0.0;
    return std::min(std::log(value / tuning.low) / std::log(tuning.high / tuning.low), 1.0);
}

double scrubbed(const Property& property, double before, double distance)
{
    if (isWhole(property))
        return std::round(before + distance / 8.0);
    const Tuning* tuning = tuningOf(property);
    if (isNeverNegative(property) && property.range.high > 1.0 && before > 0.0)
        return rounded(before * std::exp2(distance / 100.0));
    if (isNeverNegative(property) && tuning && tuning->scale == Logarithmic)
        return distance > 0.0 ? valueAt(*tuning, distance / 500.0) : 0.0;
    const double step = tuning && property.range.high <= 1.0 ? 0.002 : 0.01;
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
        return before; // absent
    };
}

void Dragging::begin()
{
    m_before = m_subject.values(m_property);
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

void Dragging::cancel() { m_subject.drag(m_property, m_before, m_gesture); }

} // namespace ripstop
