#pragma once

#include "builders/builder.h"

#include <QWidget>

#include <vector>

namespace ripstop {

class ParameterField;

// The parameters of a builder or an operation, one row each, under the headings of their groups.
class ParameterForm final : public QWidget
{
    Q_OBJECT

public:
    explicit ParameterForm(std::span<const Parameter> parameters, QWidget* parent = nullptr);

    Parameters values() const;
    QString refusal() const; // of the first field that cannot be taken, empty when all can
    void setValues(const Parameters& values); // those left out keep theirs
    void restoreDefaults();

signals:
    void changed();

private:
    std::vector<ParameterField*> m_fields;
};

} // namespace ripstop
