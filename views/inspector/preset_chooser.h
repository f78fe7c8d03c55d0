// A menu of fabrics, films, lines and spars above the form of a material, and where the numbers of
// the chosen one are from.
//
// A preset is chosen for all materials of the subject. What cannot be done is said in the place of
// the source, once; nothing is changed then. Own materials stand at the end of their kinds; they
// are read again whenever the menu opens.
#pragma once

#include "inspector/subject.h"
#include "materials/own_materials.h"

#include <QWidget>

#include <array>

class QAction;
class QLabel;
class QMenu;
class QToolButton;

namespace ripstop {

class PresetChooser final : public QWidget
{
    Q_OBJECT

public:
    explicit PresetChooser(Subject& subject, QWidget* parent = nullptr);

    void refresh(); // names the preset that the materials have

    // Gives the preset to all materials of the subject, as one edit.
    void apply(const Preset& preset);

    void saveAsOwn();    // asks for a name
    void fromTest();     // asks for a file of force and elongation
    void showSources();  // of the chosen preset, or hides them
    void readOwnAgain(); // the file may have changed

private:
    void makeMenu();
    void fillMenu();
    const Preset* chosen() const; // that all materials have, or null

    Subject& m_subject;
    QToolButton* m_button;
    QMenu* m_menu;
    std::array<QMenu*, presetKindCount> m_kinds{};
    QAction* m_problem = nullptr; // says why own materials are missing
    QLabel* m_note;               // on the preset, or why it cannot be taken
    QLabel* m_sources;            // of its numbers
    QString m_warning;            // to be shown once
    OwnMaterials m_own;
};

} // namespace ripstop
