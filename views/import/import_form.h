// How a mesh is brought in, as a person sets it: its unit and axis, which vertices are joined, and
// what fabric is made of it. A field that nobody has touched follows the file: follow() shows what
// the import chose by itself. Lengths are in m except where a member says otherwise. Only the
// window's thread uses it.
#pragma once

#include "import/import_work.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace ripstop {

class ImportForm final : public QWidget
{
    Q_OBJECT

public:
    explicit ImportForm(const Scene& scene, QWidget* parent = nullptr);

    MeshShape shape() const;
    MeshFabric fabric() const;
    std::string name() const; // of the part

    // Takes a name from the file; the welding distance follows the file again.
    void startFile(const QString& file);
    void follow(const ImportOutcome& outcome); // shows what was chosen by itself

signals:
    void changed();

private:
    void addShapeRows(QFormLayout& form);
    void addFabricRows(QFormLayout& form);
    void fillUnits(bool isKnown);
    void fillMaterials(const Scene& scene);
    void takeMaterial();   // shows the density of the chosen material
    bool mayColor() const; // whether one material may be made for each material of the file
    bool wantsSize() const;
    void choosePerMaterial();
    void showWeld(bool isKnown);

    struct Choice // in the list of materials
    {
        Id existing;
        Material material;
    };

    QLineEdit* m_name;
    QComboBox* m_unit;
    QDoubleSpinBox* m_size; // m
    QComboBox* m_up;
    QDoubleSpinBox* m_weld; // mm
    QLabel* m_joined;
    QCheckBox* m_flip;
    QComboBox* m_parts;
    QComboBox* m_material;
    QCheckBox* m_perMaterial;
    QDoubleSpinBox* m_density;            // g/m^2
    QComboBox* m_carrier = nullptr;       // in the order of FabricKind
    QDoubleSpinBox* m_grain = nullptr;    // degrees
    std::array<QComboBox*, 3> m_styles{}; // structural, shear, bend

    std::vector<Choice> m_choices;
    bool m_ownWeld = false;           // typed, not by itself
    bool m_ownPerMaterial = false;    // chosen, not by itself
    bool m_ownCarrier = false;        // the same
    std::array<bool, 3> m_ownStyle{}; // the same
    bool m_unitIsKnown = false;
    std::size_t m_fileMaterials = 0; // that faces have
    QFormLayout* m_shapeRows = nullptr;
};

} // namespace ripstop
