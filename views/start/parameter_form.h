// The parameters of a builder or an operation as a form: one ParameterField for each row, under the
// headings of their groups. The dialogs of builders and operations show it. The table of parameters
// must outlive the form. Only the window's thread uses it.
#pragma once

#include "builders/builder.h"

#include <QWidget>

#include <vector>

namespace ripstop {

class ParameterField;

class ParameterForm final : public QWidget
{
    Q_OBJECT

public:
    explicit ParameterForm(std::span<const Parameter> parameters, QWidget* parent = nullptr);

    Parameters values() const;
    QString refusal() const; // of the first field whose value cannot be taken; empty when all can
    void setValues(const Parameters& values); // fields left out keep their values
    void restoreDefaults();

protected:
    // Enter in a field has taken its number, and is not for the buttons of a dialog.
    void keyPressEvent(QKeyEvent* event) override;

signals:
    void changed(); // by the user; setValues() and restoreDefaults() do not emit it

private:
    std::vector<ParameterField*> m_fields;
};

} // namespace ripstop
