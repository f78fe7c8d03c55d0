// Stages: layOut() makes the row of fields over the hint; each writes into the brush at once, and a
// number that cannot be read or is out of range changes nothing. choose() hears that the tool is
// switched and keeps the colours of the view; showPainted() switches to those of what is painted.
// startOver() begins with a brush that fits another scene. refresh() shows the bar with the field
// of the number that counts, or says why there is nothing to paint.
#include "editor/brush_bar.h"

#include "actions/actions.h"
#include "document/document.h"
#include "icons/complaint.h"
#include "start/parameter_field.h"
#include "tools/brush_tool.h"
#include "viewport/viewport.h"

#include <QAction>
#include <QActionGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>

namespace ripstop {
namespace {

// clang-format off
constexpr std::array<Parameter, paintedCount> valueParameters{{
    {"strength", "", 0.5, 0.001, 1000, false, QT_TRANSLATE_NOOP("BrushBar", "How many times as strong as its material the fabric is to be: below 1 where it is worn, above where it is reinforced; 1 takes the paint off.")},
    {"stiffness", "", 2, 0.001, 1000, false, QT_TRANSLATE_NOOP("BrushBar", "How many times as stiff as its material the fabric is to be: above 1 where cloth lies double, below where it is worn; 1 takes the paint off.")},
    {"angle", "deg", 0, -180, 180, false, QT_TRANSLATE_NOOP("BrushBar", "How far the warp is turned from the way that the picture on the fabric goes up, counterclockwise as one sees the front of the panels.")}}};
constexpr Parameter radiusParameter{"radius", "m", 0.1, Brush::narrowest, Brush::widest, false, QT_TRANSLATE_NOOP("BrushBar", "How far the brush reaches from the cursor; [ and ], or Ctrl and the wheel, change it.")};
constexpr std::array<const char*, paintedCount> paintedColors{"byStrength", "byStiffness", "byGrain"};
// clang-format on

} // namespace

BrushBar::BrushBar(Document& document, Viewport& viewport, const Actions& actions)
    : ViewBar(viewport, QStringLiteral("brushBar"))
    , m_document(document)
    , m_brush(viewport.brush())
    , m_actions(actions)
    , m_tool(actions["toolBrush"])
    , m_title(new QLabel(tr("Paint")))
{
    layOut();
    startOver();
    connect(m_tool, &QAction::toggled, this, &BrushBar::choose);
    connect(&document, &Document::replaced, this, &BrushBar::startOver);
    connect(&document, &Document::changed, this, [this] {
        if (isVisible())
            refresh();
    });
}

void BrushBar::startOver()
{
    m_brush.radius = fittingRadius(m_document.scene());
    refresh();
}

void BrushBar::layOut()
{
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_hint->setTextFormat(Qt::PlainText);
    m_hint->setForegroundRole(QPalette::PlaceholderText);

    auto* what =
        chooser(tr("Painted"), tr("What the brush paints."),
                {tr("Strength"), tr("Stiffness"), tr("Grain")}, int(m_brush.what), [this](int row) {
                    m_brush.what = Painted(row);
                    showPainted();
                    refresh();
                });
    auto* falloff = chooser(
        tr("Falloff"), tr("Soft: less and less towards the edge of the brush. Hard: all alike."),
        {tr("Soft"), tr("Hard")}, int(m_brush.falloff),
        [this](int row) { m_brush.falloff = Falloff(row); });
    auto* mirrors = new QCheckBox(tr("Mirror"));
    mirrors->setToolTip(
        tr("Paint the other side of the part as well: across the plane that it is most nearly its "
           "own mirror image at. A second ring shows where that is."));
    mirrors->setChecked(m_brush.mirrors);
    connect(mirrors, &QCheckBox::toggled, this, [this](bool on) { m_brush.mirrors = on; });
    for (std::size_t i = 0; i < paintedCount; ++i)
        m_values.push_back(numberField(valueParameters[i], m_brush.values[i],
                                       [this, i](double value) { m_brush.values[i] = value; }));
    m_radius = numberField(radiusParameter, m_brush.radius,
                           [this](double value) { m_brush.radius = value; });

    auto* row = new QHBoxLayout;
    row->addWidget(m_title);
    row->addWidget(what);
    for (QWidget* value : m_values)
        row->addWidget(value);
    auto* radius = new QLabel(ParameterField::label(radiusParameter));
    radius->setBuddy(m_radius);
    row->addWidget(radius);
    row->addWidget(m_radius);
    row->addWidget(falloff);
    row->addWidget(mirrors);
    row->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 5, 8, 5);
    layout->setSpacing(4);
    layout->addLayout(row);
    layout->addWidget(m_hint);
    layout->addWidget(m_complaint);
}

void BrushBar::choose(bool isOn)
{
    QAction* const grain = m_actions["grain"];
    if (isOn) {
        m_before = m_actions["byMaterial"]->actionGroup()->checkedAction();
        m_grainBefore = grain->isChecked();
        showPainted();
    } else {
        if (m_before)
            m_before->trigger();
        if (grain->isChecked() != m_grainBefore)
            grain->trigger();
    }
    refresh();
}

void BrushBar::showPainted()
{
    m_actions[paintedColors[std::size_t(m_brush.what)]]->trigger();
    QAction* const grain = m_actions["grain"];
    if (grain->isChecked() != (m_grainBefore || m_brush.what == Painted::Grain))
        grain->trigger();
}

void BrushBar::refresh()
{
    setVisible(m_tool->isChecked());
    if (!m_tool->isChecked())
        return;
    for (std::size_t i = 0; i < paintedCount; ++i)
        m_values[i]->setVisible(i == std::size_t(m_brush.what));
    if (m_radius->value() != m_brush.radius)
        m_radius->setValue(m_brush.radius);
    const QString nothing = whyNothingToPaint(m_document.scene(), m_brush);
    m_hint->setText(nothing.isEmpty()
                        ? tr("Drag over the fabric. Ctrl and the wheel, or [ and ], change the "
                             "radius. Esc gives a stroke up.")
                        : nothing);
    settle();
}

} // namespace ripstop
