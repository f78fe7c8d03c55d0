// Shows in which ways what is selected gives way without a link growing longer: how many such
// modes there are, each one moving in the view, and the rods that would stop them
// (author/rigidity.h).
//
// It counts links as if they resisted both ways, and small motions only. It follows the design
// while it is open; adding the rods is one step of the history. Motion in the view is drawn on
// frames of its own and changes neither design nor run. All work is done on the thread of the
// window; Dialogs::showRigidity() opens it.
#pragma once

#include "author/rigidity.h"
#include "simulation/frame.h"

#include <QDialog>
#include <QTimer>

#include <optional>

class QCheckBox;
class QLabel;
class QListWidget;
class QPushButton;
class QTreeWidget;

namespace ripstop {

class Document;
class Selection;
class Viewport;

class RigidityDialog final : public QDialog
{
    Q_OBJECT

public:
    RigidityDialog(Document& document, Selection& selection, Viewport& viewport, QWidget* parent);

    void look(); // looks at what is selected now, or at all parts when nothing is selected
    int modes() const { return m_rigidity ? int(m_rigidity->modes.size()) : 0; }

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void layOut();
    void lookAgain(); // looks at those things anew, because the design has changed
    void say();
    void fillModes();
    void fillBraces();
    void showMode();
    void swing();
    void still();
    void selectMoving();
    void addBraces();

    Document& m_document;
    Selection& m_selection;
    Viewport& m_viewport;
    std::vector<Id> m_ids; // items that are looked at
    std::optional<Rigidity> m_rigidity;
    std::vector<Brace> m_braces;
    QLabel* m_verdict;
    QLabel* m_sums;
    QListWidget* m_modes;
    QTreeWidget* m_rods;
    QLabel* m_advice;
    QCheckBox* m_animate;
    QPushButton* m_select;
    QPushButton* m_add;
    QTimer m_clock;
    QTimer m_soon;
    std::shared_ptr<const Frame> m_design; // the frame that the mode moves
    double m_phase = 0.0;                  // radians
};

} // namespace ripstop
