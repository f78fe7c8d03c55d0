// Material from a test: a CSV file of force and elongation is shown with the line that is fitted to
// it, and becomes an own material.
//
// Sizes of the specimen, units and the range of the fit are typed, or the range is drawn over the
// plot; each change fits anew. What is wrong with the file or a field is said under the fields, and
// nothing can be saved then.
#pragma once

#include "materials/material_test.h"

#include <QDialog>

class QComboBox;
class QCustomPlot;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace ripstop {

class MaterialTestDialog final : public QDialog
{
    Q_OBJECT

public:
    explicit MaterialTestDialog(QWidget* parent = nullptr);

    void read(const QString& file); // of the test

signals:
    void saved(); // an own material, of which there is one more now

private:
    void makePlot();
    void layOut();
    QFormLayout* fields();
    void choose();
    void refresh();
    void fail(const QString& why);
    Result<SpecimenSize> size() const;
    Result<std::optional<ElongationRange>> range() const;
    void tell(const MaterialFit& fit, const SpecimenSize& size);
    void draw(const SpecimenSize& size);
    void save();

    QString m_file;
    std::string m_text; // of the file
    std::vector<TestPoint> m_points;
    std::optional<MaterialFit> m_fit;
    SpecimenSize m_size; // of that fit

    QPushButton* m_choose;
    QComboBox* m_specimen;
    QComboBox* m_direction;
    QLineEdit* m_length;
    QLineEdit* m_width;
    QLineEdit* m_forceUnit;
    QLineEdit* m_elongationUnit;
    QLineEdit* m_from;
    QLineEdit* m_to;
    QLabel* m_result;
    QLineEdit* m_label;
    QPushButton* m_save;
    QCustomPlot* m_plot;
};

} // namespace ripstop
