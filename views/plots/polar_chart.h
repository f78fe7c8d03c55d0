#pragma once

#include <QString>
#include <QWidget>

#include <vector>

class QCustomPlot;

namespace ripstop {

// Coefficients of a plate against its angle of attack: the law at hand as a full line, published
// curves dashed.
class PolarChart final : public QWidget
{
    Q_OBJECT

public:
    struct Curve
    {
        QString name;
        std::vector<double> degrees;
        std::vector<double> value; // 1
        bool published = false;
    };

    explicit PolarChart(QWidget* parent = nullptr);

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
