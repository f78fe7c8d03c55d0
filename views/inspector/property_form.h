#pragma once

#include "inspector/field.h"
#include "inspector/scrub_label.h"

#include <QWidget>

class QGridLayout;
class QToolButton;

namespace ripstop {

// The properties of one kind, a row each: label, field, and a button that restores the default.
class PropertyForm final : public QWidget
{
    Q_OBJECT

public:
    explicit PropertyForm(Subject& subject, Kind kind, QWidget* parent = nullptr);

    void refresh(); // shows the values of the subject
    void leave();   // commits or reverts what is being typed
    QWidget* field(std::string_view key, int axis) const;

private:
    struct Row
    {
        const Property* property;
        ScrubLabel* label;
        QString tip;
        QToolButton* reset;
        Field field;
    };

    void addRow(QGridLayout& grid, const Property& property);

    Subject& m_subject;
    std::vector<Row> m_rows;
};

} // namespace ripstop
