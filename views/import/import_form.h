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

// How a mesh is brought in, as a person sets it: its unit and axis, what is joined, and what fabric
// is made of it. What nobody has touched follows the file.
class ImportForm final : public QWidget
{
    Q_OBJECT

public:
    explicit ImportForm(const Scene& scene, QWidget* parent = nullptr);

    MeshShape shape() const;
    MeshFabric fabric() const;
    std::string name() const; // of the part

    void startFile(const QString& file);       // a name from it; the rest stays
    void follow(const ImportOutcome& outcome); // shows what was chosen by itself

signals:
    void changed();

private:
    void addShapeRows(QFormLayout& form);
    void addFabricRows(QFormLayout& form);
    void fillUnits(bool isKnown);
    void fillMaterials(const Scene& scene);
    void takeMaterial();   // density and so on, of the chosen one
    bool mayColor() const; // there may be one material for each of the file
    bool wantsSize() const;

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
    std::array<QComboBox*, 3> m_styles{}; // structural, shear, bend

    std::vector<Choice> m_choices;
    bool m_ownWeld = false;           // typed, not by itself
    std::array<bool, 3> m_ownStyle{}; // chosen, not by itself
    bool m_unitIsKnown = false;
    std::size_t m_fileMaterials = 0; // that faces have
    QFormLayout* m_shapeRows = nullptr;
};

} // namespace ripstop
