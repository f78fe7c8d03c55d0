// The range of the colours: close to the values, and calm.
#include "look/steady_range.h"
#include "registered_test.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace ripstop::test_steady_range {

class TestSteadyRange : public QObject
{
    Q_OBJECT

private slots:
    // Whatever the values, at most a third of the colours is unused and nothing is out of range.
    void isSnug()
    {
        for (double largest = 1.001e-3; largest < 2e3; largest *= 1.07) {
            SteadyRange range;
            range.take(std::vector{0.0, 0.3 * largest, largest}, false);
            QCOMPARE(range.range().low, 0.0);
            QVERIFY(range.range().high >= largest);
            QVERIFY(range.range().high <= 1.5 * largest);
        }
    }

    // Of few values none is let go, of many the largest of each two hundred.
    void letsFewGo()
    {
        SteadyRange few;
        std::vector<double> values(50, 1.0);
        values.back() = 9.0;
        few.take(values, false);
        QCOMPARE(few.range().high, 10.0);

        SteadyRange many;
        values.assign(400, 1.0);
        values[17] = values[200] = 50.0;
        many.take(values, false);
        QCOMPARE(many.range().high, 1.0);
    }

    // The share that may lie beyond is said by who asks, and is a share of the values that are
    // there: of 100 that are not zero two lie above the 98th. With none beyond, the peak is in.
    void letsAShareLieBeyond()
    {
        std::vector<double> values(1000, 0.0);
        for (int i = 0; i < 100; ++i)
            values[std::size_t(7 * i)] = i < 98 ? 1.0 : 50.0;
        SteadyRange most, all;
        most.take(values, false, 0.02);
        QCOMPARE(most.range().high, 1.0);
        all.take(values, false, 0.0);
        QCOMPARE(all.range().high, 50.0);
        values[0] = 50.0; // a third one
        most.take(values, false, 0.02);
        QCOMPARE(most.range().high, 50.0);
    }

    // What is pressed as well as pulled is seen on both sides of zero.
    void becomesSymmetric()
    {
        SteadyRange range;
        range.take(std::vector{-0.05, 1.0}, true); // hardly
        QCOMPARE(range.range(), (ValueRange{0.0, 1.0}));
        range.take(std::vector{-0.5, 1.0}, true);
        QCOMPARE(range.range(), (ValueRange{-1.0, 1.0}));
        range.take(std::vector{-2.9, 1.0}, true);
        QCOMPARE(range.range(), (ValueRange{-3.0, 3.0}));
    }

    // It widens at once and narrows late; values that swing by a third move nothing.
    void isCalm()
    {
        SteadyRange range;
        range.take(std::vector{9.0}, false);
        for (int frame = 0; frame < 1000; ++frame) {
            range.take(std::vector{frame % 2 ? 9.0 : 6.1}, false);
            QCOMPARE(range.range().high, 10.0);
        }
        for (int frame = 0; frame < 100; ++frame)
            range.take(std::vector{1.4}, false);
        QCOMPARE(range.range().high, 10.0);
        for (int frame = 0; frame < 100; ++frame)
            range.take(std::vector{1.4}, false);
        QCOMPARE(range.range().high, 1.5);
        range.take(std::vector{1.6}, false);
        QCOMPARE(range.range().high, 2.0);
    }

    // A slow machine shows few frames; two seconds of the run are as long for it.
    void isCalmForTwoSeconds()
    {
        SteadyRange range;
        range.take(std::vector{9.0}, false);
        for (int frame = 0; frame < 19; ++frame) // 10 frames a second
            range.take(std::vector{1.4}, false, SteadyRange::fewest, 0.1);
        QCOMPARE(range.range().high, 10.0);
        for (int frame = 0; frame < 3; ++frame)
            range.take(std::vector{1.4}, false, SteadyRange::fewest, 0.1);
        QCOMPARE(range.range().high, 1.5);
    }

    // Noise of a network at rest is nothing to paint.
    void ignoresNoise()
    {
        SteadyRange range;
        range.take(std::vector{1e-12, -1e-12}, true);
        QCOMPARE(range.range(), (ValueRange{0.0, 1.0}));
    }
};

const RegisteredTest registered("test_steady_range", runPlain<TestSteadyRange>);

} // namespace ripstop::test_steady_range
#include "test_steady_range.moc"
