// Selects by what things are: a condition such as "strain > 5 %", how many elements meet it now,
// and the list of properties that can be asked for.
//
// It stays open beside the window, counts again when the design changes, and follows the run a few
// times a second. What a condition may say is in select/condition.h. It lives on the thread of the
// window; Dialogs::showCondition() opens it.
#pragma once

#include "select/condition.h"
#include "simulation/frame.h"

#include <QDialog>
#include <QTimer>

#include <functional>
#include <memory>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace ripstop {

class Document;
class Selection;

class ConditionDialog final : public QDialog
{
    Q_OBJECT

public:
    // `frame` is the instant that measured quantities are those of.
    ConditionDialog(Document& document, Selection& selection,
                    std::function<std::shared_ptr<const Frame>()> frame, QWidget* parent);

    void setCondition(const QString& condition);
    QString verdict() const; // how many match, or what is wrong

protected:
    void showEvent(QShowEvent* event) override;

private:
    void fillKeys();
    void look();
    void lookAgain(); // looks when the frame has changed
    void select();
    Result<std::vector<Id>> found() const;

    Document& m_document;
    Selection& m_selection;
    std::function<std::shared_ptr<const Frame>()> m_frame;
    std::shared_ptr<const Frame> m_seen; // the frame that was counted
    QLineEdit* m_condition;
    QLabel* m_sign;
    QLabel* m_verdict;
    QComboBox* m_how;
    QTreeWidget* m_keys;
    QPushButton* m_select;
    QTimer m_soon;
    QTimer m_often;
};

} // namespace ripstop
