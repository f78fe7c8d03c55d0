// How numbers are tuned by hand: by sliders, by dragging a label, by arrow keys.
//
// The functions at the top are pure: they say what a number becomes. Dragging applies such a change
// to all things of a subject, always from the values before the drag, so that rounding does not add
// up and one step of undo takes it all back.
#pragma once

#include "inspector/subject.h"
#include "scene/slider.h"

class QSlider;

namespace ripstop {

// A value after its label was dragged by `distance` pixels. Numbers that are above 0 and cannot be
// negative double every 100 pixels, whole numbers go by one every 8 pixels, and others by steps.
double scrubbed(const Property& property, double before, double distance);

// A value after arrow keys: it changes by a power of ten that is a tenth to a hundredth of itself,
// and a whole number by one.
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
    void moveTo(double size); // of a vector its length; it points where it last did
    void cancel();

private:
    Subject& m_subject;
    const Property& m_property;
    std::vector<Value> m_before;
    std::vector<Vec3> m_directions; // [things] of vectors
    int m_gesture = 0;
};

// The value that a slider takes when its handle is dragged to this position, where that is another
// one than the range says.
using Snap = std::function<std::optional<double>(int position)>;

// A slider over the subject's values of the property; `range` is asked at each move, so that it can
// be edited. One press to release is one step of undo, and so is a key. Keys do not snap, so that
// they go on past what a drag snaps to.
QSlider* makeSlider(Subject& subject, const Property& property, std::function<SliderRange()> range,
                    Snap snap = {});

// Shows the value of the first thing, and notes where vectors point, for when they are 0.
void showOn(QSlider& slider, const SliderRange& range, Subject& subject, const Property& property);

double magnitude(const Value& value); // of a vector its length; 0 for what is no number

} // namespace ripstop
