// fillMenu() fills the submenu of each kind of preset, own materials last, each time it opens.
// apply() refuses where the scene has errors, makes the edit in the model (masses of particles
// follow where both densities are known) and pushes it. refresh() names the preset that all
// materials have and shows a warning, if there is one, and the note; where the numbers are from
// is unfolded by a link.
#include "inspector/preset_chooser.h"

#include "check/check.h"
#include "document/document.h"
#include "document/plain_text.h"
#include "document/spoken.h"
#include "document/words.h"
#include "inspector/material_step.h"
#include "inspector/material_test_dialog.h"
#include "inspector/own_material_dialog.h"
#include "inspector/remedies.h"
#include "inspector/tuning.h"
#include "inspector/usage_watch.h"
#include "materials/marks.h"
#include "materials/presets.h"
#include "scene/element_index.h"

#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <utility>

namespace ripstop {
namespace {

QLabel* smallPrint()
{
    auto* label = new QLabel;
    label->setWordWrap(true);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setTextInteractionFlags(Qt::TextBrowserInteraction);
    return label;
}

// What it bears, in the column of a menu that keys have: by it one looks for a stronger one.
QString strengthColumn(const Preset& preset)
{
    for (const Property* property :
         {&propertyOf<&Material::warpStrength>(), &propertyOf<&Material::lineStrength>(),
          &propertyOf<&Material::breakingMoment>()})
        if (const PresetNumber* number = findNumber(preset, *property))
            if (const double* strength = std::get_if<double>(&number->value))
                return QChar('\t') + spokenText(*strength, property->unit, 3);
    return {};
}

} // namespace

PresetChooser::PresetChooser(Subject& subject, UsageWatch& usage, QWidget* parent)
    : QWidget(parent)
    , m_subject(subject)
    , m_usage(usage)
    , m_button(new QToolButton)
    , m_menu(new QMenu(m_button))
    , m_note(smallPrint())
    , m_sources(smallPrint())
    , m_idle(smallPrint())
    , m_own(readOwnMaterials(ownMaterialsFile()))
{
    m_button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_button->setPopupMode(QToolButton::InstantPopup);
    // a long name must not make the page wider than a narrow dock
    m_button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_button->setToolTip(tr("Take the numbers of a fabric, a line or a spar that one can buy."));
    m_menu->setToolTipsVisible(true);
    m_button->setMenu(m_menu);
    connect(m_menu, &QMenu::aboutToShow, this, &PresetChooser::readOwnAgain);
    makeMenu();
    fillMenu();
    m_note->setTextFormat(Qt::RichText);
    m_sources->setTextFormat(Qt::PlainText);
    m_sources->hide();
    connect(m_note, &QLabel::linkActivated, this, &PresetChooser::showSources);

    auto* label = new QLabel(tr("Preset"));
    label->setBuddy(m_button);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 0);
    layout->setSpacing(3);
    layout->addWidget(label);
    layout->addWidget(m_button); // names of what is for sale take all the width
    layout->addWidget(makeSteps());
    layout->addWidget(m_note);
    layout->addWidget(m_sources);
    layout->addWidget(m_idle);
    m_idle->setTextFormat(Qt::RichText);
    connect(m_idle, &QLabel::linkActivated, this, [this](const QString& which) {
        const Property* property = idleNumber();
        const Remedies remedies =
            property ? m_usage.remedies(*property, m_subject.ids()) : Remedies();
        if (const auto i = which.toUInt(); i < remedies.size())
            m_warning = performRemedy(*remedies[i], *property, m_subject);
        refresh();
    });
}

QWidget* PresetChooser::makeSteps()
{
    auto* steps = new QWidget;
    auto* layout = new QGridLayout(steps); // by weight, by stiffness, by strength
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3);
    for (const MaterialStep step : allMaterialSteps) {
        auto* button = new QToolButton;
        button->setText(stepLabel(step));
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        connect(button, &QToolButton::clicked, this, [this, step] { this->step(step); });
        m_steps[std::size_t(step)] = button;
        layout->addWidget(button, int(step) / 2, int(step) % 2);
    }
    return steps;
}

void PresetChooser::step(MaterialStep step)
{
    const QString words = stepMaterials(m_subject.document(), m_subject.ids(), step, m_own.presets);
    m_warning = words;
    refresh();
}

void PresetChooser::refreshSteps()
{
    for (const MaterialStep step : allMaterialSteps) {
        QToolButton& button = *m_steps[std::size_t(step)];
        bool goes = false;
        button.setToolTip(shownAsIs(
            stepPreview(m_subject.document(), m_subject.ids(), step, m_own.presets, goes)));
        button.setEnabled(goes);
    }
}

const Property* PresetChooser::idleNumber()
{
    for (const Property* property : tradeNumbers())
        if (magnitude(Subject::common(*property, m_subject.refs()).value) > 0.0
            && !m_usage.remedies(*property, m_subject.ids()).empty())
            return property;
    return nullptr;
}

void PresetChooser::refreshIdle()
{
    const Property* property = idleNumber();
    m_idle->setVisible(property);
    if (property)
        m_idle->setText(tr("%1 does nothing now: %2. %3")
                            .arg(labelOf(*property),
                                 m_usage.whyIdle(*property, m_subject.ids()).toHtmlEscaped(),
                                 remedyLinks(m_usage.remedies(*property, m_subject.ids()))));
}

void PresetChooser::makeMenu()
{
    const std::array titles{tr("Fabrics"), tr("Films"), tr("Lines"), tr("Spars")}; // as PresetKind
    for (std::size_t kind = 0; kind < m_kinds.size(); ++kind) {
        m_kinds[kind] = m_menu->addMenu(titles[kind]);
        m_kinds[kind]->setToolTipsVisible(true);
    }
    m_menu->addSeparator();
    m_menu->addAction(tr("&Save as own material\u2026"), this, &PresetChooser::saveAsOwn);
    m_menu->addAction(tr("Material from a &test\u2026"), this, &PresetChooser::fromTest);
    m_problem = m_menu->addAction(tr("Own materials cannot be read"), this, [this] {
        m_warning = m_own.problem ? translated(m_own.problem->message) : QString();
        refresh();
    });
}

void PresetChooser::readOwnAgain()
{
    m_own = readOwnMaterials(ownMaterialsFile());
    fillMenu();
}

void PresetChooser::fillMenu()
{
    for (QMenu* menu : m_kinds)
        menu->clear();
    const Preset* current = chosen();
    const auto add = [&](const Preset& preset, const QString& text) {
        QAction* action = m_kinds[std::size_t(preset.kind)]->addAction(
            inMenu(text) + strengthColumn(preset), this, [this, &preset] { apply(preset); });
        action->setCheckable(&preset == current);
        action->setChecked(&preset == current);
        action->setToolTip(
            QStringLiteral("<qt>%1</qt>").arg(asHtml(QString::fromStdString(sourcesOf(preset)))));
    };
    for (const Preset& preset : allPresets())
        add(preset, translated(preset.label));
    for (const Preset& preset : m_own.presets)
        add(preset, tr("%1 (own)").arg(QString::fromStdString(preset.label)));
    m_problem->setVisible(m_own.problem.has_value());
    m_problem->setToolTip(
        shownAsIs(m_own.problem ? translated(m_own.problem->message) : QString()));
}

QMenu& PresetChooser::menu()
{
    readOwnAgain();
    return *m_menu;
}

const Preset* PresetChooser::chosen() const
{
    const Preset* common = nullptr;
    bool isFirst = true;
    for (const ConstRef& ref : m_subject.refs()) {
        const Preset* preset = presetOf(*std::get<const Material*>(ref), m_own.presets);
        if (!isFirst && preset != common)
            return nullptr;
        common = preset;
        isFirst = false;
    }
    return common;
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

void PresetChooser::saveAsOwn()
{
    const Material& material = *std::get<const Material*>(m_subject.refs().front());
    const Preset* like = presetOf(material, m_own.presets);
    Preset preset = presetFrom(material, like ? like->kind : likelyKind(material), {}, {}, like);
    preset.label = like && like->own ? like->label : material.name;
    auto* dialog = new OwnMaterialDialog(std::move(preset), window());
    connect(dialog, &QDialog::accepted, this, [this] {
        readOwnAgain();
        refresh();
    });
    dialog->open();
}

void PresetChooser::fromTest()
{
    auto* dialog = new MaterialTestDialog(window());
    connect(dialog, &MaterialTestDialog::saved, this, [this] {
        readOwnAgain();
        refresh();
    });
    dialog->open();
}

void PresetChooser::showSources() { m_sources->setVisible(!m_sources->isVisible()); }

void PresetChooser::refresh()
{
    const Preset* preset = chosen();
    const auto label = [&] {
        return preset->own ? tr("%1 (own)").arg(QString::fromStdString(preset->label))
                           : translated(preset->label);
    };
    m_button->setText(preset ? inMenu(label()) : tr("Choose\u2026"));
    refreshSteps();
    refreshIdle();
    QStringList notes{std::exchange(m_warning, {}).toHtmlEscaped()};
    if (preset) {
        notes << QString::fromStdString(preset->note).toHtmlEscaped();
        notes << QStringLiteral("<a href='#'>%1</a>").arg(tr("Where its numbers are from"));
        std::string sources = sourcesOf(*preset);
        sources.erase(0, preset->note.empty() ? 0 : preset->note.size() + 1);
        m_sources->setText(QString::fromStdString(sources));
    } else {
        m_sources->hide();
    }
    notes.removeAll({});
    m_note->setText(notes.join(' '));
    m_note->setVisible(!notes.isEmpty());
}

} // namespace ripstop
