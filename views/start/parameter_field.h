// One parameter of a builder or an operation, as a person sets it: a switch, a choice, or a number
// with its unit and, in forms, a slider over its range.
//
// Another unit of the same measure may be typed behind the number ("12 cm"), and so may a product
// ("2 * 1.2"). A text that cannot be read is kept and marked, and has the value NaN; refusal() then
// says what is wanted, as the tool tip does. The Parameter must outlive the field: it is a row of a
// static table. Only the window's thread uses it.
#pragma once

#include "builders/builder.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QSlider;

namespace ripstop {

class ParameterField final : public QWidget
{
    Q_OBJECT

public:
    enum class Slider { Without, With };

    explicit ParameterField(const Parameter& parameter, Slider slider = Slider::Without,
                            QWidget* parent = nullptr);

    const Parameter& parameter() const { return m_parameter; }
    double value() const; // in the unit of the parameter
    bool isInRange() const;
    QString refusal() const; // a sentence, empty while the value is one that can be taken
    void setValue(double value);

    static QString englishLabel(const Parameter& parameter); // "End mass", to be translated
    static QString label(const Parameter& parameter);

signals:
    void changed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* numberRow(Slider slider);
    QSlider* newSlider();
    void show(double value); // in the number
    void mark();
    void showOnSlider();
    double sliderValue() const; // rounded to what a step of the slider can tell

    const Parameter& m_parameter; // of a static table
    QCheckBox* m_switch = nullptr;
    QComboBox* m_choice = nullptr;
    QLineEdit* m_number = nullptr;
    QLabel* m_unit = nullptr; // of a bare number
    QSlider* m_slider = nullptr;
    double m_settled = 0.0; // the number before that which is being typed
};

} // namespace ripstop
