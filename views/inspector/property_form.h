// The properties of one kind, a row each: label, field, a button that gives it a slider in the
// tuning panel or makes it count where it does nothing, and one that restores the default.
//
// The rows are made from the property table when the form is made and never change; refresh() shows
// values, and which rows there are to see. What differs from the default has a bold label. What
// does nothing at the moment is left out, and a last row says how many those are and shows them:
// they have a pale label then and say why in its tool tip. Of the settings, how the run is computed
// is folded away at the end. A search finds all of them. A choice with long texts stands below its
// label where it has no room beside the labels.
#pragma once

#include "inspector/field.h"
#include "inspector/scrub_label.h"

#include <QWidget>

class QGridLayout;
class QLabel;
class QToolButton;

namespace ripstop {

class FoldButton;
class SliderShelf;
class UsageWatch;

class PropertyForm final : public QWidget
{
    Q_OBJECT

public:
    PropertyForm(Subject& subject, UsageWatch& usage, SliderShelf& sliders, Kind kind,
                 QWidget* parent = nullptr);

    void refresh();                   // shows the values of the subject
    int filter(const QString& words); // shows the rows about these words and returns how many
    void leave();                     // commits or reverts what is being typed
    QWidget* field(std::string_view key, int axis) const;

private:
    struct Row
    {
        const Property* property;
        ScrubLabel* label;
        QString tip;
        QLabel* complaint;
        QToolButton* slider;
        QToolButton* remedy; // in the place of the slider, where one makes the value count
        QToolButton* reset;
        Field field;
        int place;              // row of the layout; the next two are for what stands below it
        bool isBelow = false;   // stands the field below the label
        bool isChanged = false; // differs from the default
        QString idle = {};      // why it does nothing now, or empty
    };

    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    FoldButton* foldButton(const char* name);
    bool fits(const Row& row) const; // what is searched for
    int showRows();                  // and returns how many fit
    void addRow(const Property& property);
    void placeChoices();
    int roomBesideLabels() const; // px
    void addMenu(const Row& row);
    void toggleSlider(const Property& property);
    QToolButton* remedyButton(const Property& property, QLabel& complaint);
    void refreshRemedy(const Row& row);

    Subject& m_subject;
    UsageWatch& m_usage;
    SliderShelf& m_sliders;
    QGridLayout* m_grid;
    std::vector<Row> m_rows;
    QString m_words;                // that are searched for
    FoldButton* m_idle;             // shows what does nothing now
    FoldButton* m_solver = nullptr; // shows how it is computed; of the settings
};

} // namespace ripstop
