// One variable of a study in the form: what it sets, and the values that it goes through.
//
// A range has its ends, how many steps, and whether they are even or by even factors; other
// variables a list of values as they are typed. A distribution that a file brought is told and left
// as it is. Belongs to the window's thread.
#pragma once

#include "study/study.h"

#include <QWidget>

class QGridLayout;
class QLabel;
class QSpinBox;
class QToolButton;

namespace ripstop {

class Complaint;
class ValueEdit;

class VariableRow final : public QWidget
{
    Q_OBJECT

public:
    //   unit  of the property, or empty
    VariableRow(StudyVariable variable, QString unit, QWidget* parent = nullptr);

    const StudyVariable& variable() const { return m_variable; }

    void showCount(bool isShown); // of values, which a plan that draws between them has not

signals:
    void edited();
    void removed();

private:
    void addRange(QGridLayout& grid);
    void addList(QGridLayout& grid);
    ValueEdit* endEdit(const QString& name);
    void takeRange();
    void takeList(const QString& typed);

    StudyVariable m_variable;
    QString m_unit;
    ValueEdit* m_from = nullptr;
    ValueEdit* m_to = nullptr;
    ValueEdit* m_list = nullptr;
    QLabel* m_times = nullptr; // before the count
    QSpinBox* m_count = nullptr;
    QToolButton* m_log = nullptr;
    Complaint* m_complaint;
};

} // namespace ripstop
