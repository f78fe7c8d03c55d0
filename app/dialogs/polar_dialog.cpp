// Stages: the constructor makes the two lists and the chart and follows the document, but draws
// anew only after edits that can touch a material. fillMaterials() keeps the chosen material by
// its id, since rows move when materials come and go. draw() computes the polar of the material
// and reads those of the references at the same angles.
#include "dialogs/polar_dialog.h"

#include "document/document.h"
#include "plots/polar_chart.h"
#include "run/material_polar.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace ripstop {
namespace {

constexpr double step = 1.0; // degrees between points

struct Coefficient
{
    const char* name;
    double PolarRow::*value;
};

constexpr std::array quantities{
    Coefficient{QT_TRANSLATE_NOOP("PolarDialog", "Normal force coefficient"), &PolarRow::normal},
    Coefficient{QT_TRANSLATE_NOOP("PolarDialog", "Lift coefficient"), &PolarRow::lift},
    Coefficient{QT_TRANSLATE_NOOP("PolarDialog", "Drag coefficient"), &PolarRow::drag},
};

PolarChart::Curve curveOf(const QString& name, const std::vector<PolarRow>& rows,
                          double PolarRow::*value, bool published)
{
    PolarChart::Curve curve{name, {}, {}, published};
    for (const PolarRow& row : rows) {
        curve.degrees.push_back(row.degrees);
        curve.value.push_back(row.*value);
    }
    return curve;
}

bool changesMaterials(const Edit& edit)
{
    return std::ranges::any_of(edit.changes, [](const Change& change) {
        if (const auto* set = std::get_if<SetValues>(&change))
            return set->property->kind == Kind::Material;
        return std::holds_alternative<AddItem>(change)
               || std::holds_alternative<RemoveItem>(change);
    });
}

} // namespace

PolarDialog::PolarDialog(const Document& document, Id material, QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_material(new QComboBox)
    , m_quantity(new QComboBox)
    , m_chart(new PolarChart)
{
    setWindowTitle(tr("Polar of an air law"));
    setAttribute(Qt::WA_DeleteOnClose);
    for (const Coefficient& quantity : quantities)
        m_quantity->addItem(tr(quantity.name));

    auto* choices = new QHBoxLayout;
    for (const auto& [text, box] :
         {std::pair(tr("&Material"), m_material), std::pair(tr("&Coefficient"), m_quantity)}) {
        auto* label = new QLabel(text);
        label->setBuddy(box);
        choices->addWidget(label);
        choices->addWidget(box, 1);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(choices);
    layout->addWidget(m_chart, 1);
    layout->addWidget(buttons);

    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_material, &QComboBox::activated, this, &PolarDialog::draw);
    connect(m_quantity, &QComboBox::activated, this, &PolarDialog::draw);
    connect(&document, &Document::changed, this, [this](const Edit& edit) {
        if (changesMaterials(edit))
            show(chosen());
    });
    connect(&document, &Document::replaced, this, [this] { show(noId); });
    show(material);
}

void PolarDialog::show(Id material)
{
    fillMaterials(material);
    draw();
}

void PolarDialog::fillMaterials(Id chosen)
{
    const QSignalBlocker quiet(m_material);
    m_material->clear();
    m_ids.clear();
    for (const Entry& entry : m_document.scene().items)
        if (const Material* material = std::get_if<Material>(&entry.item)) {
            m_material->addItem(QString::fromStdString(material->name));
            m_ids.push_back(entry.id);
            if (entry.id == chosen)
                m_material->setCurrentIndex(m_material->count() - 1);
        }
}

Id PolarDialog::chosen() const
{
    return m_ids.empty() ? noId : m_ids[std::size_t(m_material->currentIndex())];
}

void PolarDialog::draw()
{
    const Coefficient& quantity = quantities[std::size_t(std::max(0, m_quantity->currentIndex()))];
    std::vector<PolarChart::Curve> curves;
    if (const Material* material = findItem<Material>(m_document.scene(), chosen()))
        curves.push_back(curveOf(QString::fromStdString(material->name),
                                 platePolar(*material, step), quantity.value, false));
    for (const PolarReference& reference : polarReferences()) {
        std::vector<PolarRow> rows;
        for (double degrees = 0.0; degrees <= reference.last; degrees += step)
            rows.push_back(rowOf(reference, degrees));
        curves.push_back(
            curveOf(QString::fromUtf8(reference.name.data()), rows, quantity.value, true));
    }
    m_chart->show(tr(quantity.name), curves);
}

} // namespace ripstop
