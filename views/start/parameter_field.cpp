#include "start/parameter_field.h"

#include "document/words.h"
#include "scene/typed_number.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

bool isSwitch(const Parameter& parameter)
{
    return parameter.whole && parameter.low == 0.0 && parameter.high == 1.0;
}

QString text(std::string_view words)
{
    return QString::fromUtf8(words.data(), qsizetype(words.size()));
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
    return QStringLiteral("<p>%1</p><p>%2<br>%3</p>")
        .arg(text(parameter.help).toHtmlEscaped(),
             isSwitch(parameter)
                 ? ParameterField::tr("At first %1.")
                       .arg(parameter.initial > 0.0 ? ParameterField::tr("on")
                                                    : ParameterField::tr("off"))
                 : ParameterField::tr("%1; at first %2%3.")
                       .arg(range(parameter), compactNumber(parameter.initial), unit),
             ParameterField::tr("On the command line: %1").arg(text(parameter.key)));
}

} // namespace

QString ParameterField::label(const Parameter& parameter) { return choiceLabel(parameter.key); }

ParameterField::ParameterField(const Parameter& parameter, QWidget* parent)
    : QWidget(parent)
    , m_parameter(parameter)
{
    setToolTip(help(parameter));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    if (isSwitch(parameter)) {
        m_switch = new QCheckBox;
        m_switch->setAccessibleName(label(parameter));
        layout->addWidget(m_switch);
        setFocusProxy(m_switch);
        connect(m_switch, &QCheckBox::toggled, this, &ParameterField::changed);
    } else {
        m_number = new QLineEdit;
        m_number->setAccessibleName(label(parameter));
        m_number->setAlignment(Qt::AlignRight);
        m_number->installEventFilter(this);
        auto* unit = new QLabel(text(parameter.unit));
        unit->setForegroundRole(QPalette::PlaceholderText);
        unit->setMinimumWidth(unit->fontMetrics().horizontalAdvance(QStringLiteral("kg/m\u00b2")));
        layout->addWidget(m_number, 1);
        layout->addWidget(unit);
        setFocusProxy(m_number);
        connect(m_number, &QLineEdit::textEdited, this, [this] {
            mark();
            emit changed();
        });
    }
    setValue(parameter.initial);
}

double ParameterField::value() const
{
    if (m_switch)
        return m_switch->isChecked() ? 1.0 : 0.0;
    const Typed typed = typedValue(m_number->text().toStdString(), m_parameter.unit);
    return typed.number ? typed.number->number : std::numeric_limits<double>::quiet_NaN();
}

void ParameterField::setValue(double value)
{
    if (m_switch) {
        m_switch->setChecked(value > 0.0);
        return;
    }
    m_number->setText(compactNumber(value));
    mark();
}

bool ParameterField::isInRange() const
{
    const double number = value();
    return number >= m_parameter.low && number <= m_parameter.high
           && (!m_parameter.whole || number == std::floor(number));
}

void ParameterField::mark()
{
    QPalette colors;
    if (!isInRange()) {
        const bool dark = palette().color(QPalette::Base).lightness() < 128;
        colors.setColor(QPalette::Text, dark ? QColor(0xff, 0x8a, 0x80) : QColor(0xb3, 0x26, 0x1e));
    }
    m_number->setPalette(colors);
}

// The arrow keys count up and down: by one, or by a tenth of the number's own size.
bool ParameterField::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress) {
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
