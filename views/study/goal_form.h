// What a study is for: rows of objectives, rows of limits on measures, and the outcomes that a
// design must have.
#pragma once

#include "study/study.h"

#include <QWidget>

#include <functional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QToolButton;
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
    void add(Constraint limit); // on a measure

signals:
    void edited();

private:
    void rebuild();
    struct Row // the fields that objectives and limits share
    {
        QComboBox* kind;
        QDoubleSpinBox* number;
        QComboBox* probe;
        QComboBox* reduction;
        QToolButton* remove;
    };

    Row makeRow(QComboBox* kind, const QString& numberName, double number, const Measure& measure,
                const QString& removal);
    void connectRow(const Row& row, const std::function<void()>& take,
                    const std::function<void()>& remove);
    void addObjective(std::size_t place);
    void addLimit(std::size_t place);
    Measure firstMeasure() const;

    std::vector<Objective> m_objectives;
    std::vector<Constraint> m_limits; // constraints on measures
    QStringList m_probes;
    QVBoxLayout* m_rows;
    std::vector<QWidget*> m_made; // rows that are shown
    QCheckBox* m_noTear;
    QCheckBox* m_accurate;
    bool m_isShowing = false; // values come from the study and not from a person
};

} // namespace ripstop
