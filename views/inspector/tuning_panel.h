// The properties that are tuned while the design flies, whatever is selected.
//
// A value that is set here is an edit like any other, so the next step obeys it, undo takes a drag
// back as one step, and saving writes it; nothing has to be carried over into the scene afterwards.
//
// Two sets of the values, A and B, are remembered while the window is open; one of them is in use.
// The list of sliders is that of the shelf (slider_shelf.h).
#pragma once

#include "scene/edit.h"
#include "scene/slider.h"

#include <QWidget>

#include <array>
#include <memory>

class QPushButton;
class QToolButton;
class QUndoCommand;
class QVBoxLayout;

namespace ripstop {

class DifferenceLabel;
class Document;
class Selection;
class SliderShelf;
class TuningRow;
class UsageWatch;

class TuningPanel final : public QWidget
{
    Q_OBJECT

public:
    TuningPanel(Document& document, Selection& selection, SliderShelf& sliders,
                QWidget* parent = nullptr);
    ~TuningPanel() override;

    void addUsual();   // sliders, of what has an effect in this design
    void switchSets(); // from A to B and back; what was tuned stays in the set that is left
    void keep();       // the present values are those that reset() goes back to
    void reset();

signals:
    void setsSwitched();

private:
    // The value that each slider had, by property and things.
    struct Held
    {
        const Property* property;
        std::vector<Id> ids;
        std::vector<Value> values; // [ids]
    };
    using Set = std::vector<Held>;
    struct Switch // an edit that has changed to the other set
    {
        int index; // of the history after it
        const QUndoCommand* command;
        int set; // that is tuned from then on
    };

    void rebuild();
    void refresh();
    Set captured() const;
    Edit restoring(const Set& set, const QString& label) const;
    void apply(const Set& set, const QString& label);
    void showSets();
    void followHistory(int index);
    QWidget* buildBar();
    QWidget* buildEmpty();

    Document& m_document;
    Selection& m_selection;
    SliderShelf& m_sliders;
    std::unique_ptr<UsageWatch> m_usage;
    std::vector<TuningRow*> m_rows; // owned by the layout
    std::array<Set, 2> m_sets;
    std::vector<Switch> m_switches; // that the history has, in its order
    int m_historyIndex = 0;         // that was seen last
    int m_active = 0;
    Set m_kept;
    QWidget* m_bar = nullptr;
    QWidget* m_empty = nullptr;
    QVBoxLayout* m_list = nullptr;
    std::array<QToolButton*, 2> m_letters{};
    DifferenceLabel* m_difference = nullptr;
    QPushButton* m_reset = nullptr;
};

} // namespace ripstop
