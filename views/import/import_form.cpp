// Stages, in the order of the source: the rows of shape and fabric are made; units and materials
// are filled in, those of the scene before the presets; shape() and fabric() read the fields into
// what the import takes; and follow() writes what was found in the file back into the fields that
// nobody has touched. Fields are blocked while the program writes into them, because changed()
// would otherwise start the work again.
#include "import/import_form.h"

#include "document/plain_text.h"
#include "document/words.h"
#include "materials/own_materials.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace ripstop {
namespace {

constexpr const char* firstPreset = "ripstop_075"; // the default of ripstop-cli import, too
constexpr int mostOfName = 160;                    // px, of a material that a person named

QString unitLabel(std::string_view name)
{
    return name == "mm"   ? ImportForm::tr("Millimetres")
           : name == "cm" ? ImportForm::tr("Centimetres")
           : name == "m"  ? ImportForm::tr("Metres")
           : name == "in" ? ImportForm::tr("Inches")
                          : ImportForm::tr("Feet");
}

QDoubleSpinBox* number(double low, double high, int decimals, const QString& unit)
{
    auto* box = new QDoubleSpinBox;
    box->setRange(low, high);
    box->setDecimals(decimals);
    box->setSuffix(QChar(0x202f) + unit);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setKeyboardTracking(false); // work starts only when a number has been typed to its end
    return box;
}

void addRow(QFormLayout& form, const QString& label, QWidget* field, const QString& help)
{
    field->setToolTip(help);
    field->setAccessibleName(label);
    form.addRow(label, field);
}

} // namespace

ImportForm::ImportForm(const Scene& scene, QWidget* parent)
    : QWidget(parent)
    , m_name(new QLineEdit)
    , m_unit(new QComboBox)
    , m_size(number(1e-3, 1e4, 3, tr("m")))
    , m_up(new QComboBox)
    , m_weld(number(0.0, 1e6, 4, tr("mm")))
    , m_joined(new QLabel)
    , m_flip(new QCheckBox(tr("Turn the fabric over")))
    , m_parts(new QComboBox)
    , m_material(new QComboBox)
    , m_perMaterial(new QCheckBox(tr("One for each of the file")))
    , m_density(number(0.1, 1e5, 1, tr("g/m\u00b2")))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* shapeBox = new QGroupBox(tr("Shape"));
    m_shapeRows = new QFormLayout(shapeBox);
    addShapeRows(*m_shapeRows);
    layout->addWidget(shapeBox);
    auto* fabricBox = new QGroupBox(tr("Fabric"));
    addFabricRows(*new QFormLayout(fabricBox));
    layout->addWidget(fabricBox);
    layout->addStretch(1);
    fillUnits(false);
    fillMaterials(scene);
    for (QComboBox* box : {m_unit, m_up, m_parts, m_material, m_carrier, m_styles[0], m_styles[1],
                           m_styles[2]}) // texts of a file come later
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);

    connect(m_name, &QLineEdit::textEdited, this, &ImportForm::changed);
    connect(m_unit, &QComboBox::currentIndexChanged, this, [this] {
        m_shapeRows->setRowVisible(m_size, wantsSize());
        emit changed();
    });
    connect(m_size, &QDoubleSpinBox::valueChanged, this, &ImportForm::changed);
    connect(m_up, &QComboBox::currentIndexChanged, this, &ImportForm::changed);
    connect(m_weld, &QDoubleSpinBox::valueChanged, this, [this] {
        m_ownWeld = true;
        emit changed();
    });
    connect(m_flip, &QCheckBox::toggled, this, &ImportForm::changed);
    connect(m_parts, &QComboBox::currentIndexChanged, this, &ImportForm::changed);
    connect(m_perMaterial, &QCheckBox::toggled, this, [this] {
        m_ownPerMaterial = true;
        emit changed();
    });
    connect(m_density, &QDoubleSpinBox::valueChanged, this, &ImportForm::changed);
    connect(m_material, &QComboBox::currentIndexChanged, this, [this] {
        takeMaterial();
        emit changed();
    });
    for (std::size_t i = 0; i < m_styles.size(); ++i)
        connect(m_styles[i], &QComboBox::currentIndexChanged, this, [this, i] {
            m_ownStyle[i] = true;
            emit changed();
        });
}

void ImportForm::addShapeRows(QFormLayout& form)
{
    form.setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_name->setObjectName(QStringLiteral("name"));
    m_unit->setObjectName(QStringLiteral("unit"));
    m_size->setObjectName(QStringLiteral("size"));
    m_up->setObjectName(QStringLiteral("up"));
    m_weld->setObjectName(QStringLiteral("weld"));
    m_flip->setObjectName(QStringLiteral("flip"));
    m_parts->setObjectName(QStringLiteral("parts"));
    m_size->setValue(1.0);
    m_up->addItems({tr("X"), tr("Y, as in Ripstop"), tr("Z")});
    m_up->setCurrentIndex(int(UpAxis::Y));
    m_parts->addItems({tr("One part"), tr("One for each object")});
    m_joined->setForegroundRole(QPalette::PlaceholderText);
    m_flip->setToolTip(
        tr("Makes the front of every face its back. Air meets both sides alike, but a "
           "canopy holds its air behind the back."));

    addRow(form, tr("Name"), m_name, tr("What the part will be called."));
    addRow(form, tr("Unit of the file"), m_unit,
           tr("OBJ, STL, PLY and OFF do not say what one unit is; look at the size that results."));
    addRow(form, tr("Longest side"), m_size,
           tr("The mesh is scaled until the longest side of the box around it is this long."));
    form.setRowVisible(m_size, false);
    addRow(form, tr("Up in the file"), m_up,
           tr("Most mesh programs have z up. In Ripstop, y is up."));
    addRow(form, tr("Join vertices within"), m_weld,
           tr("Vertices nearer to each other than this become one particle, so that a sail does "
              "not burst at its seams."));
    form.addRow(QString(), m_joined);
    addRow(form, tr("Parts"), m_parts,
           tr("Whether each object of the file becomes a part of its own. In one part, objects "
              "become groups, and fabric is joined where they touch."));
    form.addRow(QString(), m_flip);
}

void ImportForm::addFabricRows(QFormLayout& form)
{
    form.setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_material->setObjectName(QStringLiteral("material"));
    m_density->setObjectName(QStringLiteral("density"));
    addRow(form, tr("Material"), m_material,
           tr("A fabric that one can buy, or a material of this scene."));
    m_perMaterial->setObjectName(QStringLiteral("perMaterial"));
    m_perMaterial->setToolTip(tr("Makes as many materials as the file has, with their names and "
                                 "colours and all the numbers of this one."));
    form.addRow(QString(), m_perMaterial);
    addRow(form, tr("Mass per area"), m_density,
           tr("Each triangle gives a third of its mass to each of its corners."));
    m_carrier = new QComboBox;
    m_carrier->setObjectName(QStringLiteral("pullCarrier"));
    m_carrier->addItems({tr("Threads"), tr("Panels")});
    m_carrier->setCurrentIndex(int(FabricKind::Panels));
    addRow(form, tr("Pull carried by"), m_carrier,
           tr("Panels are elastic triangles with warp, weft and shear: they wrinkle as cloth does, "
              "and the mesh makes no difference. Threads are links along edges and across faces: "
              "three times as fast, and true along the edges of the mesh only."));
    connect(m_carrier, &QComboBox::currentIndexChanged, this, [this] {
        m_ownCarrier = true;
        m_ownStyle = {};
        m_grain->setEnabled(m_carrier->currentIndex() == int(FabricKind::Panels));
        emit changed();
    });
    m_grain = number(-180.0, 180.0, 1, QStringLiteral("\u00b0"));
    m_grain->setObjectName(QStringLiteral("warp turn"));
    addRow(form, tr("Warp turned by"), m_grain,
           tr("From the way in which the texture of the mesh goes up; without a texture, from "
              "upright, or from x on what lies level. Of panels only: threads run along the edges "
              "of the mesh."));
    connect(m_grain, &QDoubleSpinBox::valueChanged, this, &ImportForm::changed);
    const char* const names[]{"structural", "shear", "bend"};
    const QString labels[]{tr("Along edges"), tr("Across faces"), tr("Over two edges")};
    const QString help[]{
        tr("Structural links: the threads of the fabric. Rods are stable however stiff the fabric "
           "is; springs can need many substeps."),
        tr("Shear links: both diagonals of quads, and between the corners across the edge of two "
           "triangles. Triangles resist shear without them."),
        tr("Bend links: from each particle to the next but one. The bending stiffness of a "
           "material does the same at every fineness of the mesh.")};
    for (std::size_t i = 0; i < m_styles.size(); ++i) {
        m_styles[i] = new QComboBox;
        m_styles[i]->setObjectName(QLatin1String(names[i]));
        // in the order of LinkStyle
        m_styles[i]->addItems({tr("No links"), tr("Springs"), tr("Rods")});
        addRow(form, labels[i], m_styles[i], help[i]);
    }
}

void ImportForm::fillUnits(bool isKnown)
{
    const QSignalBlocker quiet(m_unit);
    const bool wanted = m_unit->count() > 0 && wantsSize();
    m_unitIsKnown = isKnown;
    m_unit->clear();
    if (isKnown)
        m_unit->addItem(tr("As the file says"), 1.0);
    for (const LengthUnit& unit : lengthUnits())
        if (!isKnown)
            m_unit->addItem(unitLabel(unit.name), unit.metres);
    m_unit->addItem(tr("Scale to a size"), 0.0);
    m_unit->setCurrentIndex(wanted ? m_unit->count() - 1 : m_unit->findData(1.0));
}

void ImportForm::fillMaterials(const Scene& scene)
{
    const QSignalBlocker quiet(m_material);
    const auto nameOf = [this](const std::string& name) { // which may be of any length
        return fontMetrics().elidedText(text(name), Qt::ElideRight, mostOfName);
    };
    int chosen = 0;
    for (const Entry& entry : scene.items)
        if (const Material* material = std::get_if<Material>(&entry.item)) {
            m_choices.push_back({entry.id, *material});
            m_material->addItem(tr("%1 (of this scene)").arg(nameOf(material->name)));
            m_material->setItemData(m_material->count() - 1, shownAsIs(text(material->name)),
                                    Qt::ToolTipRole);
        }
    if (!m_choices.empty())
        m_material->insertSeparator(m_material->count());
    const std::vector<Preset> own = readOwnMaterials(ownMaterialsFile()).presets;
    std::vector<Preset> presets(allPresets().begin(), allPresets().end());
    presets.insert(presets.end(), own.begin(), own.end());
    for (const Preset& preset : presets) {
        if (!isSheet(preset.kind))
            continue;
        if (preset.name == firstPreset)
            chosen = m_material->count();
        m_material->addItem(preset.own ? tr("%1 (own)").arg(nameOf(preset.label))
                                       : translated(preset.label));
        m_material->setItemData(m_material->count() - 1, QString::fromStdString(sourcesOf(preset)),
                                Qt::ToolTipRole);
        m_choices.push_back({noId, materialFrom(preset)});
        m_material->setItemData(m_material->count() - 1, int(m_choices.size()) - 1);
    }
    // materials of the scene stand first, so that their row is also their index
    for (int i = 0; i < m_material->count(); ++i)
        if (!m_material->itemData(i).isValid())
            m_material->setItemData(i, i);
    m_material->setCurrentIndex(chosen);
    takeMaterial();
}

void ImportForm::takeMaterial()
{
    const Choice& choice = m_choices[std::size_t(m_material->currentData().toInt())];
    const QSignalBlocker quiet(m_density);
    const double told = choice.material.arealDensity.value_or(0.0);
    if (told > 0.0)
        m_density->setValue(1000.0 * told);
    // the density of a material of the scene is for the inspector to change
    m_density->setEnabled(choice.existing == noId || told == 0.0);
    m_perMaterial->setEnabled(mayColor());
}

bool ImportForm::mayColor() const
{
    return m_fileMaterials > 0
           && m_choices[std::size_t(m_material->currentData().toInt())].existing == noId;
}

bool ImportForm::wantsSize() const { return m_unit->currentData().toDouble() == 0.0; }

MeshShape ImportForm::shape() const
{
    MeshShape shape;
    if (wantsSize())
        shape.size = m_size->value();
    else
        shape.scale = m_unit->currentData().toDouble();
    shape.up = UpAxis(m_up->currentIndex());
    if (m_ownWeld)
        shape.weldTolerance = 1e-3 * m_weld->value();
    shape.isFlipped = m_flip->isChecked();
    shape.parts = m_parts->currentIndex() == 1 ? MeshParts::PerObject : MeshParts::One;
    return shape;
}

MeshFabric ImportForm::fabric() const
{
    const Choice& choice = m_choices[std::size_t(m_material->currentData().toInt())];
    MeshFabric fabric;
    fabric.existing = choice.existing;
    fabric.material = choice.material;
    fabric.density = 1e-3 * m_density->value();
    if (choice.existing == noId)
        fabric.material.arealDensity = fabric.density;
    if (m_ownCarrier)
        fabric.carrier = FabricKind(m_carrier->currentIndex());
    fabric.grain = m_grain->value();
    fabric.isPerFileMaterial = mayColor() && m_perMaterial->isChecked();
    std::optional<LinkStyle>* const styles[]{&fabric.structural, &fabric.shear, &fabric.bend};
    for (std::size_t i = 0; i < m_styles.size(); ++i)
        if (m_ownStyle[i])
            *styles[i] = LinkStyle(m_styles[i]->currentIndex());
    return fabric;
}

std::string ImportForm::name() const
{
    const QString typed = m_name->text().trimmed();
    return (typed.isEmpty() ? tr("mesh") : typed).toStdString();
}

void ImportForm::startFile(const QString& file)
{
    m_name->setText(QFileInfo(file).completeBaseName());
    m_ownWeld = false;
    m_ownPerMaterial = false;
    showWeld(false);
}

// Several in a file are wanted as they are; one alone has its picture in any case.
void ImportForm::choosePerMaterial()
{
    const bool isWanted = m_fileMaterials > 1;
    if (m_ownPerMaterial || m_perMaterial->isChecked() == isWanted)
        return;
    const QSignalBlocker quiet(m_perMaterial);
    m_perMaterial->setChecked(isWanted);
    emit changed();
}

// Nothing is known of the places of vertices before the file is read.
void ImportForm::showWeld(bool isKnown)
{
    m_weld->setEnabled(isKnown);
    m_weld->setSpecialValueText(isKnown || m_weld->value() > 0.0 ? QString() : QStringLiteral("–"));
}

void ImportForm::follow(const ImportOutcome& outcome)
{
    if (outcome.isRead) {
        if (m_unitIsKnown != outcome.unit.has_value())
            fillUnits(outcome.unit.has_value());
        m_up->setEnabled(!outcome.isUpright);
        const QSignalBlocker quiet(m_up);
        if (outcome.isUpright)
            m_up->setCurrentIndex(int(UpAxis::Y));
        m_fileMaterials = outcome.materials;
        m_perMaterial->setText(
            m_fileMaterials > 1 ? tr("One for each of %1 in the file")
                                      .arg(QLocale().toString(qulonglong(m_fileMaterials)))
            : m_fileMaterials == 1 ? tr("With the name and colour of that in the file")
                                   : tr("One for each of the file"));
        m_perMaterial->setEnabled(mayColor());
        choosePerMaterial();
        m_parts->setEnabled(outcome.objects > 1);
        m_parts->setItemText(1, outcome.objects > 1
                                    ? tr("One for each of %1 objects").arg(outcome.objects)
                                    : tr("One for each object"));
    }
    setEnabled(outcome.isRead);
    if (outcome.isRead)
        showWeld(true);
    if (!outcome.mesh) {
        m_joined->clear();
        return;
    }
    const auto joined = qulonglong(outcome.mesh->report.count(MeshFault::DuplicateVertices));
    m_joined->setText(joined == 0   ? tr("joins none")
                      : joined == 1 ? tr("joins 1 vertex")
                                    : tr("joins %1 vertices").arg(QLocale().toString(joined)));
    if (!m_ownWeld) {
        const QSignalBlocker quiet(m_weld);
        m_weld->setValue(1e3 * outcome.mesh->weldTolerance);
    }
    if (!m_ownCarrier) {
        const QSignalBlocker quiet(m_carrier);
        m_carrier->setCurrentIndex(int(outcome.carrier));
        m_grain->setEnabled(outcome.carrier == FabricKind::Panels);
    }
    const LinkStyle styles[]{outcome.weave.structural, outcome.weave.shear, outcome.weave.bend};
    for (std::size_t i = 0; i < m_styles.size(); ++i)
        if (!m_ownStyle[i]) {
            const QSignalBlocker quiet(m_styles[i]);
            m_styles[i]->setCurrentIndex(int(styles[i]));
        }
}

} // namespace ripstop
