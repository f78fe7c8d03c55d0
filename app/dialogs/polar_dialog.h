// Shows what the air law of a material does to a flat plate: a coefficient over the angle of
// attack in degrees, beside published curves.
//
// It only reads the document, and follows its edits, so that the window can stay open while a law
// is tuned. The curves are computed on the thread of the window, one point a degree. It deletes
// itself when it is closed; Dialogs::showPolar() opens it.
#pragma once

#include "scene/id.h"

#include <QDialog>

#include <vector>

class QComboBox;

namespace ripstop {

class Document;
class PolarChart;

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
