// One property of the tuning panel: its value to type, a slider below with its range, and what is
// to be known about it, such as that it does nothing.
//
// The row has a subject of its own, so it stays with its things whatever is selected. It only
// announces what a person wants of range and row; the panel and the shelf do it.
#pragma once

#include "inspector/field.h"
#include "inspector/mark_strip.h"
#include "materials/own_materials.h"
#include "scene/slider.h"

#include <QWidget>

class QLabel;
class QSlider;
class QToolButton;

namespace ripstop {

class Complaint;
class UsageWatch;
class ValueEdit;

class TuningRow final : public QWidget
{
    Q_OBJECT

public:
    TuningRow(Document& document, UsageWatch& usage, LastDirections& directions, Slider slider,
              QWidget* parent = nullptr);

    const Slider& slider() const { return m_slider; }
    void setRange(const SliderRange& range);
    void refresh(); // shows the values and what they are for

signals:
    void rangeEdited(const ripstop::SliderRange& range);
    void removed();
    void chosen(); // its things are wanted in the inspector
    void studyWanted();

private:
    QWidget* rangeLine();
    ValueEdit* endEdit(double SliderRange::*end, const QString& name);
    void editRange(SliderRange range);
    QString note();
    std::vector<SliderMark> marks() const; // of materials of the library, on the track

    Document& m_document;
    UsageWatch& m_usage;
    Subject m_subject;
    Slider m_slider;
    ScrubLabel* m_label;
    QLabel* m_note;
    Complaint* m_complaint;
    Field m_field;
    QSlider* m_bar = nullptr;     // of what has a range
    MarkStrip* m_marks = nullptr; // of a number by which materials are bought
    OwnMaterials m_own;           // which have marks too
    ValueEdit* m_low = nullptr;
    ValueEdit* m_high = nullptr;
    QToolButton* m_log = nullptr;
};

} // namespace ripstop
