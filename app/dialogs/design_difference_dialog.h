// What the open design and another one differ in: a list of sentences, the most important first
// (author/scene_difference.h), and the other one as a ghost in the view.
//
// The other one is the design as its file has it, until one chooses another scene or recording. A
// row selects what it tells of. The list follows edits while it is open. It belongs to the thread
// of the window; Dialogs::showDifferences() opens it.
#pragma once

#include "author/scene_difference.h"

#include <QDialog>
#include <QTimer>

class QCheckBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace ripstop {

class Document;
class Selection;
class Viewport;

class DesignDifferenceDialog final : public QDialog
{
    Q_OBJECT

public:
    DesignDifferenceDialog(Document& document, Selection& selection, Viewport& viewport,
                           QWidget* parent);

    // False when the file holds no design; the dialog says why then.
    bool compareWith(const QString& file);
    void compareWithSaved(); // with what the file of the open design has

    const std::vector<SceneDifference>& differences() const { return m_differences; }
    QString verdict() const;

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void layOut();
    void choose();
    void look(); // compares anew, because one of the two has changed
    void say();
    void showGhost();
    void select(int row);
    void selectAll();

    Document& m_document;
    Selection& m_selection;
    Viewport& m_viewport;
    QString m_file; // of the other one; empty where there is none yet
    Scene m_other;
    std::vector<SceneDifference> m_differences;
    QLabel* m_with;
    QLabel* m_verdict;
    QListWidget* m_list;
    QCheckBox* m_ghost;
    QPushButton* m_saved;
    QPushButton* m_select;
    QTimer m_soon;
};

} // namespace ripstop
