// A menu of fabrics, films, lines and spars above the form of a material, and where the numbers of
// the chosen one are from.
//
// Below the menu are steps to the next material of the library: lighter, heavier, softer, stiffer,
// weaker, stronger.
// Where its stiffness does nothing in the scene that is said, with links that make it count.
//
// A preset is chosen for all materials of the subject. What cannot be done is said in the place of
// the source, once; nothing is changed then. Own materials stand at the end of their kinds; they
// are read again whenever the menu opens.
#pragma once

#include "inspector/subject.h"
#include "materials/neighbours.h"
#include "materials/own_materials.h"

#include <QWidget>

#include <array>

class QAction;
class QLabel;
class QMenu;
class QToolButton;

namespace ripstop {

class UsageWatch;

class PresetChooser final : public QWidget
{
    Q_OBJECT

public:
    PresetChooser(Subject& subject, UsageWatch& usage, QWidget* parent = nullptr);

    void refresh(); // names the preset that the materials have

    // Gives the preset to all materials of the subject, as one edit.
    void apply(const Preset& preset);

    void step(MaterialStep step); // to the next material of the library, as one edit
    void saveAsOwn();             // asks for a name
    void fromTest();              // asks for a file of force and elongation
    void showSources();           // of the chosen preset, or hides them
    void readOwnAgain();          // the file may have changed
    QMenu& menu();                // of all presets, as it is when it opens

private:
    QWidget* makeSteps();
    void refreshSteps();
    void refreshIdle();
    void makeMenu();
    void fillMenu();
    const Preset* chosen() const; // that all materials have, or null

    const Property* idleNumber(); // by which materials are bought, and that can be made to count

    Subject& m_subject;
    UsageWatch& m_usage;
    QToolButton* m_button;
    QMenu* m_menu;
    std::array<QMenu*, presetKindCount> m_kinds{};
    QAction* m_problem = nullptr;                          // says why own materials are missing
    std::array<QToolButton*, materialStepCount> m_steps{}; // as MaterialStep
    QLabel* m_note;    // on the preset, or why it cannot be taken
    QLabel* m_sources; // of its numbers
    QLabel* m_idle;    // that its stiffness does nothing, and what to do about it
    QString m_warning; // to be shown once
    OwnMaterials m_own;
};

} // namespace ripstop
