// Stages, in the order of the source: where a value stands on its slider and back, rounding to what
// a slider can tell, the texts of the help; then the field itself, which is made as a switch, a
// choice or a number by what the table says of the parameter; reading and setting its value; and
// last the marks of values out of range and the arrow keys. Wide ranges are logarithmic on the
// slider, because equal steps would leave no room for small values.
#include "start/parameter_field.h"

#include "document/number_line.h"
#include "document/spoken.h"
#include "document/words.h"
#include "icons/complaint.h"
#include "scene/typed_number.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

constexpr int sliderSteps = 1000;
constexpr double wide = 20.0; // a range that spans more than this is shown by its logarithm

bool isSwitch(const Parameter& parameter)
{
    return parameter.whole && parameter.low == 0.0 && parameter.high == 1.0
           && parameter.choices.empty();
}

// The share of its slider, from 0 to 1, at which a value stands, and the way back. Wide ranges are
// logarithmic; those from zero rise with the cube, so that small values have room, too.
double shareOf(const Parameter& parameter, double value)
{
    const double low = parameter.low;
    const double high = parameter.high;
    if (low > 0.0 && high > wide * low)
        return std::log(value / low) / std::log(high / low);
    const double share = (value - low) / (high - low);
    return low == 0.0 && high > wide * parameter.atFirst() ? std::cbrt(share) : share;
}

double valueAt(const Parameter& parameter, double share)
{
    const double low = parameter.low;
    const double high = parameter.high;
    if (low > 0.0 && high > wide * low)
        return low * std::pow(high / low, share);
    if (low == 0.0 && high > wide * parameter.atFirst())
        share = share * share * share;
    return low + share * (high - low);
}

// Rounds to two significant digits, as finely as a hand can set a slider.
double rounded(const Parameter& parameter, double value)
{
    if (parameter.whole)
        return std::round(value);
    const double size = value != 0.0 ? std::abs(value) : parameter.high - parameter.low;
    const double step = std::pow(10.0, std::floor(std::log10(size)) - 1.0);
    return std::round(value / step) * step;
}

QString range(const Parameter& parameter)
{
    const QString unit = parameter.unit.empty() ? QString() : QChar(' ') + text(parameter.unit);
    return ParameterField::tr("%1 to %2%3")
        .arg(compactNumber(parameter.low), compactNumber(parameter.high), unit);
}

// What the parameter is, what it may be, and what it is called on the command line.
QString help(const Parameter& parameter)
{
    const QString unit = parameter.unit.empty() ? QString() : QChar(' ') + text(parameter.unit);
    QString limits = ParameterField::tr("%1; at first %2%3.")
                         .arg(range(parameter), compactNumber(parameter.atFirst()), unit);
    if (isSwitch(parameter))
        limits = ParameterField::tr("At first %1.")
                     .arg(parameter.atFirst() > 0.0 ? ParameterField::tr("on")
                                                    : ParameterField::tr("off"));
    else if (!parameter.choices.empty())
        limits = ParameterField::tr("At first %1.")
                     .arg(choiceLabel(parameter.choices[std::size_t(parameter.atFirst())]));
    return QStringLiteral("<p>%1</p><p>%2<br>%3</p>")
        .arg(translated(parameter.help).toHtmlEscaped(), limits,
             ParameterField::tr("On the command line: %1").arg(text(parameter.key)));
}

// "kg/m²"
QString unitText(const Parameter& parameter)
{
    return text(parameter.unit).replace(QStringLiteral("^2"), QStringLiteral("\u00b2"));
}

} // namespace

// Files and the command line have short keys; some are no words that kite builders would know by.
QString ParameterField::englishLabel(const Parameter& parameter)
{
    if (parameter.key == "tow")
        return QStringLiteral("Tow point");
    if (parameter.key == "vortex")
        return QStringLiteral("Lift from the shape");
    return ripstop::englishLabel(parameter.key);
}

QString ParameterField::label(const Parameter& parameter)
{
    return translated(englishLabel(parameter).toStdString());
}

ParameterField::ParameterField(const Parameter& parameter, Slider slider, QWidget* parent)
    : QWidget(parent)
    , m_parameter(parameter)
{
    setToolTip(help(parameter));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    QWidget* field = nullptr;
    if (isSwitch(parameter)) {
        field = m_switch = new QCheckBox;
        connect(m_switch, &QCheckBox::toggled, this, &ParameterField::changed);
    } else if (!parameter.choices.empty()) {
        field = m_choice = new QComboBox;
        for (const std::string_view choice : parameter.choices)
            m_choice->addItem(choiceLabel(choice));
        connect(m_choice, &QComboBox::currentIndexChanged, this, &ParameterField::changed);
    } else {
        field = numberRow(slider);
    }
    layout->addWidget(field, 1);
    QWidget* focused = m_number ? m_number : field;
    focused->setAccessibleName(label(parameter));
    setFocusProxy(focused);
    setValue(parameter.atFirst());
}

QWidget* ParameterField::numberRow(Slider slider)
{
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    m_number = new NumberLine;
    m_number->setAlignment(Qt::AlignRight);
    if (slider == Slider::With)
        m_number->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("0000.0000 m")));
    m_number->installEventFilter(this);
    auto* unit = m_unit = new QLabel(unitText(m_parameter));
    unit->setForegroundRole(QPalette::PlaceholderText);
    if (slider == Slider::With || !m_parameter.unit.empty()) // numbers of a form end alike
        unit->setMinimumWidth(unit->fontMetrics().horizontalAdvance(QStringLiteral("kg/m\u00b2")));
    if (slider == Slider::With)
        layout->addWidget(newSlider(), 1);
    layout->addWidget(m_number, slider == Slider::With ? 0 : 1);
    layout->addWidget(unit);
    connect(m_number, &QLineEdit::textEdited, this, [this] {
        mark();
        showOnSlider();
        emit changed();
    });
    connect(m_number, &QLineEdit::editingFinished, this, [this] { // "80 kg" stands before a "kg"
        if (isInRange())
            m_settled = value();
        bool isPlain = false;
        (void)QLocale().toDouble(m_number->text(), &isPlain);
        if (!isPlain && refusal().isEmpty())
            show(value());
    });
    return row;
}

QSlider* ParameterField::newSlider()
{
    m_slider = new QSlider(Qt::Horizontal);
    m_slider->setRange(0, sliderSteps);
    m_slider->setFocusPolicy(Qt::NoFocus); // the arrow keys of the number do the same
    m_slider->setAccessibleName(label(m_parameter));
    m_slider->setMinimumWidth(60);
    m_slider->installEventFilter(this);
    connect(m_slider, &QSlider::valueChanged, this, [this] {
        show(sliderValue());
        emit changed();
    });
    return m_slider;
}

// Reads what typedValue() can read: "2.4", "240 cm", "2 * 1.2".
double ParameterField::value() const
{
    if (m_switch)
        return m_switch->isChecked() ? 1.0 : 0.0;
    if (m_choice)
        return m_choice->currentIndex();
    const Typed typed = typedValue(m_number->text().toStdString(), m_parameter.unit);
    return typed.number ? typed.number->number : std::numeric_limits<double>::quiet_NaN();
}

void ParameterField::setValue(double value)
{
    if (m_switch) {
        m_switch->setChecked(value > 0.0);
    } else if (m_choice) {
        m_choice->setCurrentIndex(int(value));
    } else {
        show(value);
        showOnSlider();
    }
}

bool ParameterField::isInRange() const
{
    const double number = value();
    return number >= m_parameter.low && number <= m_parameter.high
           && (!m_parameter.whole || number == std::floor(number));
}

QString ParameterField::refusal() const
{
    if (isInRange())
        return {};
    const QString kind = m_parameter.whole ? tr("a whole number") : tr("a number");
    return tr("%1 must be %2 from %3.").arg(label(m_parameter), kind, range(m_parameter));
}

// As the inspector shows it: 0.55 mm, with its own unit where that of the field would hide it.
void ParameterField::show(double value)
{
    m_settled = value;
    m_number->setText(spokenInField(value, m_parameter.unit).number);
    mark();
}

void ParameterField::mark()
{
    const QString typed = m_number->text();
    bool isNumber = false;
    (void)QLocale().toDouble(typed, &isNumber); // 1e-3 has a letter, too
    const bool hasUnit = !isNumber && std::any_of(typed.begin(), typed.end(), [](QChar sign) {
        return sign.isLetter() || sign == QChar('%');
    });
    m_unit->setText(hasUnit ? QString() : unitText(m_parameter));
    QPalette colors;
    const QString wrong = refusal();
    if (!wrong.isEmpty())
        colors.setColor(QPalette::Text, wrongColor(colors));
    m_number->setPalette(colors);
    setToolTip(wrong.isEmpty() ? help(m_parameter)
                               : QStringLiteral("<p><b>%1</b></p>").arg(wrong.toHtmlEscaped())
                                     + help(m_parameter));
}

// The first digits of a number that is refused are no number that was meant.
void ParameterField::showOnSlider()
{
    if (!m_slider)
        return;
    const double shown = isInRange() ? value() : m_settled;
    const QSignalBlocker quiet(m_slider);
    m_slider->setValue(int(std::lround(sliderSteps * shareOf(m_parameter, shown))));
}

double ParameterField::sliderValue() const
{
    const double value = valueAt(m_parameter, double(m_slider->value()) / sliderSteps);
    return std::clamp(rounded(m_parameter, value), m_parameter.low, m_parameter.high);
}

// The arrow keys count up and down: by one, or by one in the second digit of the number. The wheel
// scrolls the form and must not move a slider that it passes on the way.
bool ParameterField::eventFilter(QObject* watched, QEvent* event)
{
    if (m_slider && watched == m_slider && event->type() == QEvent::Wheel) {
        event->ignore();
        return true;
    }
    if (watched == m_number && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const double now = value();
        if ((key == Qt::Key_Up || key == Qt::Key_Down) && !std::isnan(now)) {
            const double size = std::abs(now) > 0.0 ? std::abs(now) : std::abs(m_parameter.high);
            const double step =
                m_parameter.whole ? 1.0 : std::pow(10.0, std::floor(std::log10(size)) - 1.0);
            const double next = now + (key == Qt::Key_Up ? step : -step);
            setValue(std::clamp(std::round(next / step) * step, m_parameter.low, m_parameter.high));
            emit changed();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace ripstop
