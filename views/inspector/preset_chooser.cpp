// fillMenu() makes a submenu for each kind of preset. apply() refuses where the scene has errors,
// makes the edit in the model (masses of particles follow where both densities are known) and
// pushes it. refresh() names the preset that all materials have and shows a warning, if there is
// one, and the source.
#include "inspector/preset_chooser.h"

#include "document/document.h"
#include "document/words.h"
#include "materials/presets.h"
#include "scene/check.h"
#include "scene/element_index.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

namespace ripstop {
namespace {

// The preset that all these materials have, or null.
const Preset* presetOf(const std::vector<ConstRef>& refs)
{
    const auto& first = *std::get<const Material*>(refs.front());
    const Preset* preset = presetOf(first);
    return std::ranges::all_of(refs,
                               [&](const ConstRef& ref) {
                                   return presetOf(*std::get<const Material*>(ref)) == preset;
                               })
               ? preset
               : nullptr;
}

} // namespace

PresetChooser::PresetChooser(Subject& subject, QWidget* parent)
    : QWidget(parent)
    , m_subject(subject)
    , m_button(new QToolButton)
    , m_note(new QLabel)
{
    m_button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_button->setPopupMode(QToolButton::InstantPopup);
    m_button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_button->setToolTip(tr("Take the numbers of a fabric, a line or a spar that one can buy."));
    fillMenu();
    m_note->setWordWrap(true);
    m_note->setForegroundRole(QPalette::PlaceholderText);

    auto* label = new QLabel(tr("Preset"));
    label->setBuddy(m_button);
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(m_button, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 0);
    layout->setSpacing(3);
    layout->addLayout(row);
    layout->addWidget(m_note);
}

void PresetChooser::fillMenu()
{
    auto* menu = new QMenu(m_button);
    menu->setToolTipsVisible(true);
    const std::array titles{tr("Fabrics"), tr("Films"), tr("Lines"), tr("Spars")}; // as PresetKind
    std::array<QMenu*, presetKindCount> menus{};
    for (std::size_t kind = 0; kind < menus.size(); ++kind) {
        menus[kind] = menu->addMenu(titles[kind]);
        menus[kind]->setToolTipsVisible(true);
    }
    for (const Preset& preset : allPresets()) {
        QAction* action = menus[std::size_t(preset.kind)]->addAction(
            translated(preset.label), this, [this, &preset] { apply(preset); });
        action->setToolTip(QStringLiteral("<qt>%1</qt>")
                               .arg(QString::fromStdString(sourcesOf(preset)).toHtmlEscaped()));
    }
    m_button->setMenu(menu);
}

void PresetChooser::apply(const Preset& preset)
{
    const Scene& scene = m_subject.document().scene();
    if (const auto problem = firstError(scene, ElementIndex(scene))) {
        m_warning = translated(problem->message);
        return refresh();
    }
    Result<PresetEdit> made = presetEdit(scene, preset, m_subject.ids());
    if (!made) {
        m_warning = translated(made.message());
        return refresh();
    }
    const bool isWeighed = made->notWeighed.empty();
    m_subject.document().push(std::move(made->edit));
    if (!isWeighed)
        m_warning = tr("Particles keep their mass, because the density of before or of the preset "
                       "is not known.");
    refresh();
}

void PresetChooser::refresh()
{
    const Preset* preset = presetOf(m_subject.refs());
    m_button->setText(preset ? translated(preset->label) : tr("Choose\u2026"));
    QStringList notes{std::exchange(m_warning, {}),
                      preset ? QString::fromStdString(preset->note) : QString()};
    notes.removeAll({});
    m_note->setText(notes.join(' '));
    m_note->setVisible(!notes.isEmpty());
}

} // namespace ripstop
