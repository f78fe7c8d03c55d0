// The name follows from the label. refresh() looks whether there is one of that name and says on
// the button what it does; save() gives the source to the numbers that have none and closes when
// the file is written.
#include "inspector/own_material_dialog.h"

#include "document/words.h"
#include "materials/own_materials.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ripstop {

OwnMaterialDialog::OwnMaterialDialog(Preset preset, QWidget* parent)
    : QDialog(parent)
    , m_preset(std::move(preset))
    , m_label(new QLineEdit(QString::fromStdString(m_preset.label)))
    , m_kind(new QComboBox)
    , m_source(new QLineEdit)
    , m_name(new QLabel)
    , m_save(new QPushButton)
{
    setWindowTitle(tr("Save as own material"));
    setAttribute(Qt::WA_DeleteOnClose);
    layOut();
    connect(m_label, &QLineEdit::textChanged, this, &OwnMaterialDialog::refresh);
    connect(m_save, &QPushButton::clicked, this, &OwnMaterialDialog::save);
    refresh();
    m_label->selectAll();
}

void OwnMaterialDialog::layOut()
{
    m_kind->addItems({tr("Fabric"), tr("Film"), tr("Line"), tr("Spar")}); // as PresetKind
    m_kind->setCurrentIndex(int(m_preset.kind));
    m_source->setPlaceholderText(tr("who says so, or how it was found"));
    m_name->setTextFormat(Qt::PlainText);
    m_name->setWordWrap(true);
    m_name->setTextInteractionFlags(Qt::TextSelectableByMouse);

    auto* form = new QFormLayout;
    form->addRow(tr("&Called"), m_label);
    form->addRow(tr("&What it is"), m_kind);
    form->addRow(tr("S&ource"), m_source);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    buttons->addButton(m_save, QDialogButtonBox::AcceptRole);
    m_save->setDefault(true);
    // the button box would close it whether or not the file was written
    disconnect(buttons, &QDialogButtonBox::accepted, this, nullptr);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_name);
    layout->addWidget(buttons);
    setMinimumWidth(420);
}

void OwnMaterialDialog::refresh()
{
    m_preset.label = m_label->text().trimmed().toStdString();
    m_preset.name = materialNameOf(m_preset.label);
    const std::filesystem::path file = ownMaterialsFile();
    const std::vector<Preset> own = readOwnMaterials(file).presets;
    m_replaces = std::ranges::find(own, m_preset.name, &Preset::name) != own.end();
    m_save->setText(m_replaces ? tr("&Replace") : tr("&Save"));
    m_save->setEnabled(!m_preset.name.empty());
    m_name->setText(m_preset.name.empty() ? tr("Its name needs a letter from a to z or a digit.")
                                          : tr("As %1 in %2")
                                                .arg(QString::fromStdString(m_preset.name),
                                                     QString::fromStdString(file.string())));
}

void OwnMaterialDialog::save()
{
    m_preset.kind = PresetKind(m_kind->currentIndex());
    const std::string source = m_source->text().trimmed().toStdString();
    Preset preset = m_preset;
    for (PresetNumber& number : preset.values)
        if (number.source.empty())
            number.source = source.empty() ? "Saved from a scene" : source;
    const auto failure = saveOwnMaterial(ownMaterialsFile(), preset,
                                         m_replaces ? SameName::Replaced : SameName::Refused);
    if (failure)
        return m_name->setText(translated(failure->message));
    accept();
}

} // namespace ripstop
