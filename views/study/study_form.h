// What a study is: its variables, how the points come from them, and how long each flight is. The
// form edits a study of its own; who shows it writes the file.
#pragma once

#include "study/study.h"

#include <QWidget>

#include <functional>

class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QSpinBox;
class QVBoxLayout;

namespace ripstop {

class GoalForm;
class ValueEdit;
class VariableRow;

class StudyForm final : public QWidget
{
    Q_OBJECT

public:
    explicit StudyForm(QWidget* parent = nullptr);

    // Says the unit of what a variable sets.
    using UnitOf = std::function<QString(const StudyVariable&)>;

    //   probes  of the scene, by their names
    void setStudy(Study study, UnitOf unitOf, const QStringList& probes = {});
    const Study& study() const { return m_study; }

    GoalForm& goals() { return *m_goals; }

    void add(StudyVariable variable); // or new values for the one that has the same paths

signals:
    void edited();

private:
    void rebuild();
    void showPlan();
    void takePlan();
    void addSearch(QHBoxLayout& line, QSpinBox& box, const QString& words, int least,
                   const QString& tip);
    void change(const std::function<void()>& what);

    Study m_study;
    UnitOf m_unitOf;
    QVBoxLayout* m_variables;
    std::vector<VariableRow*> m_rows; // [variables]
    QLabel* m_hint;
    QComboBox* m_plan;
    QHBoxLayout* m_draw; // of plans that draw
    QSpinBox* m_count;
    QSpinBox* m_seed;
    QLabel* m_seedLabel;
    QHBoxLayout* m_search; // of an optimisation
    QHBoxLayout* m_last;   // its last stage
    QSpinBox* m_population;
    QSpinBox* m_generations;
    QSpinBox* m_polish;
    std::vector<QLabel*> m_searchLabels;
    GoalForm* m_goals;
    ValueEdit* m_seconds;
    QCheckBox* m_untilTear;
    QComboBox* m_keep;        // in the order of KeptRuns
    QSpinBox* m_keepCount;    // of the best
    bool m_isShowing = false; // values come from the study and not from a person
};

} // namespace ripstop
