// Stages: wordsOf() gives title, unit and help of each tool; layOut() makes the three numbers and
// the four lists of choices. refresh() follows the tool: it writes the numbers of a drag, but
// leaves what is being typed alone. take() reads all three numbers, has the tool apply them as one
// change, and gives the focus back to the view so that its keys work again.
#include "editor/transform_bar.h"

#include "document/words.h"
#include "scene/typed_number.h"
#include "viewport/viewport.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

struct Words
{
    QString title;
    QString unit;
    QString help;
};

Words wordsOf(Shaping shaping)
{
    switch (shaping) {
    case Shaping::Move:
        return {TransformBar::tr("Move"), QStringLiteral("m"),
                TransformBar::tr("How far along %1, in metres. Enter applies it.")};
    case Shaping::Turn:
        return {TransformBar::tr("Rotate"), QStringLiteral("\u00b0"),
                TransformBar::tr("Angle about %1, in degrees. Enter applies it.")};
    case Shaping::Scale:
        return {TransformBar::tr("Scale"), QStringLiteral("\u00d7"),
                TransformBar::tr("Factor along %1; 1 changes nothing. Enter applies it.")};
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
        for (int axis = 0; axis < 3; ++axis)
            m_numbers[std::size_t(axis)]->setText(numberText(m_tool.numbers()[axis]));
    m_shown = shaping;
    m_wasDragging = m_tool.isDragging();
    m_row->setVisible(!waits);
    m_hint->setVisible(waits);
    setVisible(shown);
    if (shown)
        settle();
}

void TransformBar::take()
{
    Vec3 numbers = m_tool.numbers(); // where a field cannot be read, its number stays as it is
    const std::string unit =
        m_tool.shaping() == Shaping::Scale ? std::string() : m_unit->text().toStdString();
    for (int axis = 0; axis < 3; ++axis)
        if (const Typed typed =
                typedNumber(m_numbers[std::size_t(axis)]->text().toStdString(), unit);
            typed.number)
            numbers[axis] = typed.number->appliedTo(numbers[axis]);
    m_tool.shape(numbers);
    for (int axis = 0; axis < 3; ++axis)
        m_numbers[std::size_t(axis)]->setText(numberText(m_tool.numbers()[axis]));
}

} // namespace ripstop
