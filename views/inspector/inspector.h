// The form of what is selected, one or thousands of the same kind, made from the property table.
//
// With nothing selected it shows the settings. When several kinds are selected, tabs choose one of
// them. Every commit is one undoable edit of all things that are shown. Above the form stand what
// the things are, what they amount to and whether targets are met; below, one form per kind is made
// when it is first needed and kept.
#pragma once

#include "inspector/slider_shelf.h"
#include "inspector/subject.h"
#include "inspector/usage_watch.h"

#include <QWidget>

#include <array>
#include <optional>

class QLabel;
class QLineEdit;
class QMenu;
class QStackedWidget;
class QTabBar;

namespace ripstop {

class Document;
class PresetChooser;
class PropertyForm;
class TargetRows;
class Selection;

class Inspector final : public QWidget
{
    Q_OBJECT

public:
    Inspector(Document& document, Selection& selection, QWidget* parent = nullptr);
    ~Inspector() override;

    // The field of a property in the form that is open, to focus it; null when there is none.
    // `axis` is that of a vector.
    QWidget* field(std::string_view key, int axis = 0) const;

    SliderShelf& sliders() { return m_sliders; }
    void startSearch();  // the keyboard goes to the search of properties
    QMenu* presetMenu(); // null while no materials are shown

private:
    void changeEvent(QEvent* event) override;
    void showSelection();
    void showKind(Kind kind);
    void leaveForm();
    void refresh();
    void refreshHeader();
    void filter();
    void showPicking();
    bool takePick();
    QWidget* underPresets(PropertyForm* form); // of materials
    void keyPressEvent(QKeyEvent* event) override;

    Document& m_document;
    Selection& m_selection;
    SliderShelf m_sliders;
    Subject m_subject;
    UsageWatch m_usage;
    QLabel* m_icon;
    std::optional<Kind> m_iconKind; // the kind that the icon shows
    QLabel* m_title;
    QLabel* m_totals;
    TargetRows* m_targets;
    QLabel* m_banner; // while a field waits for something to be picked
    QTabBar* m_kinds; // when several kinds are selected
    QLineEdit* m_search;
    QLabel* m_noMatch; // while nothing is found
    QStackedWidget* m_pages;
    std::array<PropertyForm*, kindCount> m_forms{}; // made when first needed
    std::array<QWidget*, kindCount> m_areas{};      // the scroll areas of the forms
    PresetChooser* m_presets = nullptr;             // above the form of materials
};

} // namespace ripstop
