#pragma once

#include "scene/id.h"

#include <QDialog>

#include <vector>

class QComboBox;

namespace ripstop {

class Document;
class PolarChart;

// What the air law of a material does to a flat plate, beside published curves. Follows the edits
// of the document, so that the window can stay open while a law is tuned.
class PolarDialog final : public QDialog
{
    Q_OBJECT

public:
    // `material` is shown first; the first one of the scene when it is none.
    PolarDialog(const Document& document, Id material, QWidget* parent);

    void show(Id material);
    using QDialog::show;

private:
    void fillMaterials(Id chosen);
    void draw();
    Id chosen() const;

    const Document& m_document;
    std::vector<Id> m_ids; // of the materials in the list
    QComboBox* m_material;
    QComboBox* m_quantity;
    PolarChart* m_chart;
};

} // namespace ripstop
