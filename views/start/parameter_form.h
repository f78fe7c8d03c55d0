// The parameters of a builder or an operation as a form: one ParameterField for each row, under the
// headings of their groups. What does nothing beside the others (Parameter::needs) is folded away
// and keeps its value. The dialogs of builders and operations show the form. The table of
// parameters must outlive it. Only the window's thread uses it.
#pragma once

#include "builders/builder.h"

#include <QWidget>

#include <set>
#include <vector>

class QFormLayout;
class QLabel;

namespace ripstop {

class FoldButton;
class ParameterField;

class ParameterForm final : public QWidget
{
    Q_OBJECT

public:
    explicit ParameterForm(std::span<const Parameter> parameters, QWidget* parent = nullptr);

    Parameters values() const;
    QString refusal() const; // of the first field whose value cannot be taken; empty when all can
    void setValues(const Parameters& values); // fields left out keep their values
    void restoreDefaults();                   // nothing is said any more

    // What a person has set in this form, or what say() has set as theirs; setValues() takes over
    // what it sets.
    Parameters said() const;
    void say(const Parameters& values);

protected:
    // Enter in a field has taken its number, and is not for the buttons of a dialog.
    void keyPressEvent(QKeyEvent* event) override;

signals:
    void changed(); // by the user; setValues() and restoreDefaults() do not emit it

private:
    struct Group
    {
        QLabel* heading; // null for rows above the first one
        std::vector<ParameterField*> fields;
    };

    void addGroup(const std::vector<const Parameter*>& rows);
    void showWhatCounts();
    QString whyIdle(const Parameter& parameter) const;

    std::span<const Parameter> m_parameters;
    QFormLayout* m_form;
    std::vector<Group> m_groups;
    std::vector<ParameterField*> m_fields; // of all groups
    FoldButton* m_idle;
    std::set<std::string_view> m_said; // keys
};

} // namespace ripstop
