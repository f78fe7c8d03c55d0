// How numbers are tuned by hand: by sliders, by dragging a label, by arrow keys.
#pragma once

#include "inspector/subject.h"

namespace ripstop {

// The stretch of values that a slider covers. Fields take any value that the property allows.
struct Tuning
{
    enum class Scale { Linear, Logarithmic }; // logarithmic has its zero at the left end
    Kind kind;
    std::string_view key;
    Scale scale;
    double low;
    double high;
};

// Null for properties without a slider. A vector is tuned by its length.
const Tuning* tuningOf(const Property& property);

double valueAt(const Tuning& tuning, double place); // place 0..1
double placeOf(const Tuning& tuning, double value);

// A value after its label was dragged by `distance` px: numbers that cannot be negative double
// every 100 px, others move by steps.
double scrubbed(const Property& property, double before, double distance);

// A value after arrow keys: by a tenth to a hundredth of itself, to a round number.
double stepped(const Property& property, double before, int steps);

// Keeps a number within the range of the property.
double clamped(const Property& property, double value);

// Changes one number of a value (`axis` of a vector) by a function of doubles, within the range.
Transform numberTransform(const Property& property, int axis, std::function<double(double)> change);

// One drag over all things of a subject; undone in one step.
class Dragging
{
public:
    Dragging(Subject& subject, const Property& property)
        : m_subject(subject)
        , m_property(property)
    {}
    void begin();
    void move(const Transform& fromBefore);
    void cancel();

private:
    Subject& m_subject;
    const Property& m_property;
    std::vector<Value> m_before;
    int m_gesture = 0;
};

} // namespace ripstop
