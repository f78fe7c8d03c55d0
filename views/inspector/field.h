// The fields of a form: one editor for each type of value.
//
// makeField() chooses by the type of the value and by what the property means, never by its key. A
// field writes to all things of its subject at once and shows the value that they have in common.
// The widget has no parent yet: whoever puts it into a layout owns it, and the subject, the
// property and the label of the place must outlive it. Forms and rows of the tuning panel make
// them, in the thread of the window.
#pragma once

#include "inspector/subject.h"

class QWidget;

namespace ripstop {

class ScrubLabel;

// What a field is made for.
struct FieldPlace
{
    Subject& subject;
    const Property& property;
    ScrubLabel& label;                            // a number is also changed by dragging it
    std::function<void(const QString&)> complain; // what is wrong with what is being typed
    bool slides = true;                           // with a slider below what is often tuned
};

struct Field
{
    QWidget* widget = nullptr;
    std::array<QWidget*, 3> focus{};            // what is typed into, by axis of a vector
    std::function<void(const Common&)> refresh; // shows the value of all things
};

Field makeField(const FieldPlace& place);

// One function for each type; makeField() chooses.
Field numberField(const FieldPlace& place); // also numbers that may be absent
Field vectorField(const FieldPlace& place);
Field flagField(const FieldPlace& place);
Field choiceField(const FieldPlace& place);
Field textField(const FieldPlace& place);
Field rowsField(const FieldPlace& place);
Field notesField(const FieldPlace& place);
Field colorField(const FieldPlace& place);
Field fileField(const FieldPlace& place); // of a collider
Field idField(const FieldPlace& place);   // an id or a list of ids

inline QString mixedText() { return QStringLiteral("\u2014"); } // shown where values differ

} // namespace ripstop
