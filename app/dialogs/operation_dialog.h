// Asks for the parameters of an operation (shaping/operation.h) on what was selected when it
// opened.
//
// The design shows the outcome while the dialog is open, as a gesture in the history; accepted,
// that is one step of the history, and dismissed, none. An operation that refuses says why in the
// dialog, which can then not be accepted. The operation runs on the thread of the window; with
// more than 20000 selected particles the preview is off at first. Rows of the Design menu open it,
// modal.
#pragma once

#include "shaping/operation.h"

#include <QDialog>
#include <QTimer>

#include <vector>

class QCheckBox;
class QDialogButtonBox;
class QLabel;

namespace ripstop {

class Document;
class ParameterForm;
class Selection;

class OperationDialog final : public QDialog
{
    Q_OBJECT

public:
    OperationDialog(const Operation& operation, Document& document, Selection& selection,
                    QWidget* parent);

    void accept() override;
    void reject() override;

private:
    void layOut();
    void soon();    // shows the outcome when the hand pauses
    void preview(); // shows it now
    void takeBack();
    void say(const QString& text, bool isRefusal);
    Result<Shaped> shaped() const;

    const Operation& m_operation;
    Document& m_document;
    Selection& m_selection;
    const std::vector<Id> m_ids; // what was selected
    ParameterForm* m_form;
    QCheckBox* m_preview;
    QLabel* m_outcome;
    QDialogButtonBox* m_buttons;
    QTimer m_pause;
};

} // namespace ripstop
