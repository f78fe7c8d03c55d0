// Stages: the constructor takes the actions of the three tools with their hints and lays out three
// rows (words, what is drawn, where it goes); each field writes into the settings at once, and a
// number that cannot be read or is out of range changes nothing. startOver() begins with the first
// part of a new scene, because ids mean other things there. refresh() shows the bar for the tool
// that is on, with the fields that this tool uses, and fills the lists of parts and materials anew
// from the scene.
#include "editor/draw_bar.h"

#include "actions/actions.h"
#include "document/document.h"
#include "icons/complaint.h"
#include "start/parameter_field.h"
#include "viewport/viewport.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>

namespace ripstop {
namespace {

// clang-format off
constexpr Parameter gridParameter{"grid", "m", 0.1, 0, 100, false, "Places snap to a grid of this step in the plane, unless Ctrl is held; 0 is none."};
constexpr Parameter massParameter{"mass", "kg", 0.01, 0, 1e3, false, "Of each new particle; of a whole line that has several segments, where its material does not say what it weighs."};
constexpr Parameter segmentsParameter{"segments", "", 1, 1, 1000, true, "Links between two clicks, with new particles along the way."};
// clang-format on

} // namespace

DrawBar::DrawBar(Document& document, Viewport& viewport, DrawSettings& settings,
                 const Actions& actions)
    : ViewBar(viewport, QStringLiteral("drawBar"))
    , m_document(document)
    , m_settings(settings)
    , m_hints{{actions["drawParticles"], tr("Draw particles"),
               tr("Click where they are to be: in the plane, on fabric. A right drag turns the "
                  "view.")},
              {actions["drawLinks"], tr("Draw links"),
               tr("Click from particle to particle, or where one is to be. The last one again, or "
                  "Esc, ends the line.")},
              {actions["drawPanels"], tr("Draw panels"),
               tr("Click the three corners. Esc begins again.")}}
    , m_title(new QLabel)
{
    layOut();
    startOver();
    for (const Hint& hint : m_hints)
        connect(hint.tool, &QAction::toggled, this, &DrawBar::refresh);
    connect(&document, &Document::replaced, this, &DrawBar::startOver);
    connect(&document, &Document::changed, this, &DrawBar::refresh);
}

// Ids mean other things in another scene, so the first part of the new one is drawn into.
void DrawBar::startOver()
{
    m_settings.part = m_settings.material = noId;
    forEachPart(m_document.scene(), [this](Id id, const Part&) {
        if (m_settings.part == noId)
            m_settings.part = id;
    });
    refresh();
}

void DrawBar::layOut()
{
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_hint->setForegroundRole(QPalette::PlaceholderText);

    m_part =
        chooser(tr("Part"),
                tr("Where new particles go. Links and panels go to the part of "
                   "their first particle."),
                {}, 0, [this](int row) { m_settings.part = Id(m_part->itemData(row).toUInt()); });
    m_material = chooser(tr("Material"), tr("Of new links and panels."), {}, 0, [this](int row) {
        m_settings.material = Id(m_material->itemData(row).toUInt());
    });
    auto* kind = chooser(tr("Kind"),
                         tr("Rods keep their length, lines only do not grow longer, springs pull "
                            "with a force."),
                         {tr("Rods"), tr("Lines"), tr("Springs")}, 0, [this](int row) {
                             m_settings.kind = row == 2 ? LinkKind::Spring : LinkKind::Rod;
                             m_settings.resists = row == 1 ? Resists::Tension : Resists::Both;
                         });
    auto* segments = field(segmentsParameter, m_settings.segments,
                           [this](double value) { m_settings.segments = int(value); });
    m_mass =
        field(massParameter, m_settings.mass, [this](double value) { m_settings.mass = value; });
    m_onLinks = {kind, segments};
    auto* plane = chooser(
        tr("Plane"),
        tr("Where places off the fabric lie: in a plane through the particle "
           "that was clicked last, or through the origin."),
        {tr("Facing plane"), tr("Level plane"), tr("Front plane"), tr("Side plane")},
        int(m_settings.plane), [this](int row) { m_settings.plane = DrawSettings::Plane(row); });
    auto* onMesh = new QCheckBox(tr("On fabric"));
    onMesh->setToolTip(tr("A click on a panel puts the particle there, and not in the plane."));
    onMesh->setChecked(m_settings.onMesh);
    connect(onMesh, &QCheckBox::toggled, this, [this](bool on) { m_settings.onMesh = on; });

    auto* words = new QHBoxLayout;
    words->addWidget(m_title);
    words->addWidget(m_hint, 1);
    auto* what = new QHBoxLayout;
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_part, m_material, kind, segments, m_mass})
        what->addWidget(widget);
    what->addStretch(1);
    auto* where = new QHBoxLayout;
    where->addWidget(plane);
    where->addWidget(
        field(gridParameter, m_settings.grid, [this](double value) { m_settings.grid = value; }));
    where->addWidget(onMesh);
    where->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 5, 8, 5);
    layout->setSpacing(4);
    layout->addLayout(words);
    layout->addLayout(what);
    layout->addLayout(where);
    layout->addWidget(m_complaint);
}

// The field stands behind its name.
QWidget* DrawBar::field(const Parameter& parameter, double value,
                        const std::function<void(double)>& take)
{
    ParameterField* number = numberField(parameter, value, take);
    auto* label = new QLabel(ParameterField::label(parameter));
    label->setBuddy(number);
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(label);
    layout->addWidget(number);
    return row;
}

template <typename T>
void DrawBar::fillItems(QComboBox& box, Id chosen, const QString& fresh)
{
    box.clear();
    box.addItem(fresh, 0U);
    for (const Entry& entry : m_document.scene().items)
        if (const T* item = std::get_if<T>(&entry.item))
            box.addItem(QString::fromStdString(item->name), std::uint32_t(entry.id));
    box.setCurrentIndex(std::max(box.findData(std::uint32_t(chosen)), 0));
}

void DrawBar::refresh()
{
    const auto used =
        std::ranges::find_if(m_hints, [](const Hint& hint) { return hint.tool->isChecked(); });
    setVisible(used != m_hints.end());
    if (used == m_hints.end())
        return;
    m_title->setText(used->title);
    m_hint->setText(used->words);
    fillItems<Part>(*m_part, m_settings.part, tr("(new part)"));
    fillItems<Material>(*m_material, m_settings.material, tr("(new material)"));
    for (QWidget* widget : m_onLinks)
        widget->setVisible(used == m_hints.begin() + 1);
    m_material->setVisible(used != m_hints.begin());
    settle();
}

} // namespace ripstop
