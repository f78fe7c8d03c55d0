// Colours of curves: sixteen that can be told apart and read on their background.
#include "plots/curve_color.h"
#include "views/run_with_widgets.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace ripstop::test_curve_color {

namespace {

// As in WCAG 2.1, "relative luminance" and "contrast ratio".
double luminance(const QColor& color)
{
    const auto linear = [](double c) {
        return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF())
           + 0.0722 * linear(color.blueF());
}

double contrast(const QColor& a, const QColor& b)
{
    const double first = luminance(a), second = luminance(b);
    return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

int distance(const QColor& a, const QColor& b) // of the channel that differs most
{
    return std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()),
                     std::abs(a.blue() - b.blue())});
}

} // namespace

class TestCurveColor : public QObject
{
    Q_OBJECT

private slots:
    void sixteenOfThem_data()
    {
        QTest::addColumn<QColor>("base");
        QTest::newRow("light") << QColor(Qt::white);
        QTest::newRow("dark") << QColor(0x1e, 0x22, 0x28);
    }

    void sixteenOfThem()
    {
        QFETCH(QColor, base);
        QPalette palette;
        palette.setColor(QPalette::Base, base);
        for (int i = 0; i < 16; ++i) {
            const QColor color = curveColor(i, palette);
            QVERIFY2(contrast(color, base) >= 3.0, qPrintable(QString::number(i)));
            for (int k = 0; k < i; ++k)
                QVERIFY2(distance(color, curveColor(k, palette)) >= 24,
                         qPrintable(QStringLiteral("%1 and %2").arg(i).arg(k)));
        }
    }
};

const RegisteredTest registered("test_curve_color", runWithView<TestCurveColor>);

} // namespace ripstop::test_curve_color
#include "test_curve_color.moc"
