// A chart of the coefficients of a plate against its angle of attack, from 0 to 90 degrees: the air
// law at hand as a full line, published curves dashed. The dialog of polars shows it. It is a
// widget: only the window's thread uses it.
#pragma once

#include <QString>
#include <QWidget>

#include <vector>

class QCustomPlot;

namespace ripstop {

class PolarChart final : public QWidget
{
    Q_OBJECT

public:
    struct Curve
    {
        QString name;
        std::vector<double> degrees;
        std::vector<double> value; // [degrees] 1
        bool published = false;
    };

    explicit PolarChart(QWidget* parent = nullptr);

    // Replaces what was shown; `quantity` names the value axis.
    void show(const QString& quantity, const std::vector<Curve>& curves);
    using QWidget::show;

    int curveCount() const; // for tests

    QSize sizeHint() const override { return {760, 560}; }

protected:
    void changeEvent(QEvent* event) override;

private:
    QCustomPlot* m_plot;
};

} // namespace ripstop
