#pragma once

#include "builders/builder.h"

#include <QWidget>

class QCheckBox;
class QLineEdit;

namespace ripstop {

// One parameter of a builder, as a person sets it: a switch, a count or a number with its unit.
// What cannot be read as a number is kept and marked, and has the value NaN.
class ParameterField final : public QWidget
{
    Q_OBJECT

public:
    explicit ParameterField(const Parameter& parameter, QWidget* parent = nullptr);

    const Parameter& parameter() const { return m_parameter; }
    double value() const; // in the unit of the parameter
    bool isInRange() const;
    void setValue(double value);

    static QString label(const Parameter& parameter); // "End mass"

signals:
    void changed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void mark();

    const Parameter& m_parameter; // of the static table of builders
    QCheckBox* m_switch = nullptr;
    QLineEdit* m_number = nullptr;
};

} // namespace ripstop
