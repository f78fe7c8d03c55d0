#pragma once

#include "author/condition.h"
#include "run/frame.h"

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

// Selects by what things are: a condition, how many meet it now, and what can be asked. It stays
// open beside the window, and counts along while a simulation runs.
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
    void lookAgain(); // when the instant has changed
    void select();
    Result<std::vector<Id>> found() const;

    Document& m_document;
    Selection& m_selection;
    std::function<std::shared_ptr<const Frame>()> m_frame;
    std::shared_ptr<const Frame> m_seen; // that the count is of
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
