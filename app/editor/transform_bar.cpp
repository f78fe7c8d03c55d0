// Stages: wordsOf() gives title, unit and help of each tool; layOut() makes the three numbers and
// the four lists of choices. refresh() follows the tool: it writes the numbers of a drag, but
// leaves what is being typed alone. take() reads all three numbers and has the tool apply them as
// one change; where one of them is wrong it says so and changes nothing.
#include "editor/transform_bar.h"

#include "document/words.h"
#include "icons/complaint.h"
#include "scene/typed_number.h"
#include "viewport/viewport.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ripstop {
namespace {

struct Words
{
    QString title;
    QString unit;
    QString help;
    double low, high; // of what can be typed
};

constexpr double farthest = 1e6; // m, degrees, or times; what is beyond is a slip of the hand

Words wordsOf(Shaping shaping)
{
    switch (shaping) {
    case Shaping::Move:
        return {TransformBar::tr("Move"), QStringLiteral("m"),
                TransformBar::tr("How far along %1, in metres. Enter applies it."), -farthest,
                farthest};
    case Shaping::Turn:
        return {TransformBar::tr("Rotate"), QStringLiteral("\u00b0"),
                TransformBar::tr("Angle about %1, in degrees. Enter applies it."), -farthest,
                farthest};
    case Shaping::Scale:
        return {TransformBar::tr("Scale"), QStringLiteral("\u00d7"),
                TransformBar::tr("Factor along %1; 1 changes nothing. Enter applies it."),
                1.0 / farthest, farthest};
    case Shaping::None:
        break;
    }
    return {};
}

QString numberText(double value)
{
    const double rounded = std::round(value * 1e4) / 1e4;
    return compactNumber(rounded == 0.0 ? 0.0 : rounded); // zero has no minus sign
}

} // namespace

TransformBar::TransformBar(Viewport& viewport)
    : ViewBar(viewport, QStringLiteral("transformBar"))
    , m_tool(viewport.transformTool())
    , m_title(new QLabel)
    , m_unit(new QLabel)
    , m_row(new QWidget)
{
    layOut();
    connect(&m_tool, &TransformTool::changed, this, &TransformBar::refresh);
}

void TransformBar::layOut()
{
    auto* numbers = new QHBoxLayout;
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    numbers->addWidget(m_title);
    for (int axis = 0; axis < 3; ++axis) {
        auto* field = new QLineEdit;
        m_numbers[std::size_t(axis)] = field;
        const QString name = QString(QChar('x' + axis));
        field->setObjectName(name);
        field->setAccessibleName(name);
        field->setAlignment(Qt::AlignRight);
        field->setFixedWidth(field->fontMetrics().horizontalAdvance(QStringLiteral("−0.00000")));
        auto* label = new QLabel(name);
        label->setBuddy(field);
        numbers->addWidget(label);
        numbers->addWidget(field);
        connect(field, &QLineEdit::returnPressed, this, &TransformBar::take);
        connect(field, &QLineEdit::textEdited, this, [this] { complain({}); });
    }
    numbers->addWidget(m_unit);
    auto* choices = new QHBoxLayout;
    numbers->addWidget(
        chooser(tr("Pivot"),
                tr("What it turns and scales about: it stays where it is. \"A particle…\" waits "
                   "for a click on one."),
                {tr("Centre of mass"), tr("Median"), tr("Middle of the box"), tr("A particle…")},
                int(m_tool.pivot()), [this](int chosen) { m_tool.setPivot(Pivot(chosen)); }));
    choices->addWidget(chooser(
        tr("Axes"),
        tr("What x, y and z are: the axes of the world; the selection's own, x along it and "
           "z across it; or right, up and towards you in the view."),
        {tr("World axes"), tr("Own axes"), tr("View axes")}, int(m_tool.axes()),
        [this](int chosen) { m_tool.setAxes(Axes(chosen)); }));
    choices->addWidget(chooser(
        tr("Rest lengths"),
        tr("What becomes of the rest lengths of links: they stay, so that what is pulled apart is "
           "under load, or they become the new distances, so that the design is free of load."),
        {tr("Keep lengths"), tr("Rebind lengths")}, int(m_tool.restLengths()),
        [this](int chosen) { m_tool.setRestLengths(RestLengths(chosen)); }));
    choices->addWidget(chooser(tr("Snap"), tr("What a drag snaps to while Ctrl is held."),
                               {tr("Ctrl: grid"), tr("Ctrl: particle")}, int(m_tool.snap()),
                               [this](int chosen) { m_tool.setSnap(Snap(chosen)); }));
    auto* rows = new QVBoxLayout(m_row);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(4);
    rows->addLayout(numbers);
    rows->addLayout(choices);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 5, 8, 5);
    layout->addWidget(m_row);
    m_hint->setText(TransformTool::wayToDesign());
    layout->addWidget(m_hint);
    layout->addWidget(m_complaint);
}

void TransformBar::refresh()
{
    const Shaping shaping = m_tool.shaping();
    const bool shown = shaping != Shaping::None && (m_tool.acts() || !m_tool.isAtDesign());
    const bool waits = !m_tool.isAtDesign();
    if (shaping != m_shown) {
        const Words words = wordsOf(shaping);
        m_title->setText(words.title);
        m_unit->setText(words.unit);
        for (int axis = 0; axis < 3 && shaping != Shaping::None; ++axis)
            m_numbers[std::size_t(axis)]->setToolTip(words.help.arg(QChar('x' + axis)));
    }
    // what is being typed stays until a drag has numbers of its own
    if (shaping != m_shown || m_tool.isDragging() || m_wasDragging)
        showNumbers();
    m_shown = shaping;
    m_wasDragging = m_tool.isDragging();
    m_row->setVisible(!waits);
    m_hint->setVisible(waits);
    setVisible(shown);
    if (shown)
        settle();
}

void TransformBar::showNumbers()
{
    for (int axis = 0; axis < 3; ++axis)
        m_numbers[std::size_t(axis)]->setText(numberText(m_tool.numbers()[axis]));
    m_wrong.clear();
}

void TransformBar::complain(const QString& wrong)
{
    if (std::exchange(m_wrong, wrong) != wrong)
        settle();
}

void TransformBar::take()
{
    const Words words = wordsOf(m_tool.shaping());
    const std::string unit =
        m_tool.shaping() == Shaping::Scale ? std::string() : words.unit.toStdString();
    Vec3 numbers = m_tool.numbers();
    for (int axis = 0; axis < 3; ++axis) {
        const Typed typed = typedNumber(m_numbers[std::size_t(axis)]->text().toStdString(), unit);
        if (!typed.number)
            return complain(tr("The number %1.").arg(translated(typed.complaint)));
        numbers[axis] = typed.number->appliedTo(numbers[axis]);
        if (!(numbers[axis] >= words.low && numbers[axis] <= words.high))
            return complain(
                tr("The number must be from %1 to %2 %3.")
                    .arg(compactNumber(words.low), compactNumber(words.high), words.unit));
    }
    m_tool.shape(numbers);
    showNumbers();
    settle();
}

} // namespace ripstop
