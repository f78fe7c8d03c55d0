// What a study is for: rows of objectives, and the outcomes that a design must have. Constraints on
// measures are kept as the file has them.
#pragma once

#include "study/study.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QVBoxLayout;

namespace ripstop {

class GoalForm final : public QWidget
{
    Q_OBJECT

public:
    explicit GoalForm(QWidget* parent = nullptr);

    //   probes  of the scene, by their names
    void show(const Study& study, const QStringList& probes);
    using QWidget::show;
    void giveTo(Study& study) const; // what is shown

    void add(Objective objective);

signals:
    void edited();

private:
    void rebuild();
    void addRow(std::size_t place);

    std::vector<Objective> m_objectives;
    std::vector<Constraint> m_measured; // constraints on measures
    QStringList m_probes;
    QVBoxLayout* m_rows;
    std::vector<QWidget*> m_made; // rows that are shown
    QCheckBox* m_noTear;
    QCheckBox* m_accurate;
    QLabel* m_limits;         // the constraints on measures
    bool m_isShowing = false; // values come from the study and not from a person
};

} // namespace ripstop
