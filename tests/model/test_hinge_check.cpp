// A corner of a spar that turns as on a hinge is named, and no corner that something holds.
#include "check/check.h"
#include "model/chain.h"
#include "registered_test.h"

#include <QtTest>

#include <cmath>
#include <numbers>

namespace ripstop::test_hinge_check {

namespace {

// A spar of two links that turns by so many degrees; its first particle is pinned.
Chain bentSpar(double turn)
{
    Material tube;
    tube.name = "tube";
    tube.flexuralRigidity = 10.0;
    const double angle = turn * std::numbers::pi / 180.0;
    return Chain({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1 + std::cos(angle), std::sin(angle), 0)}, 1,
                 0.1, tube);
}

QString told(const Chain& chain)
{
    for (const Finding& found : problemsOf(chain.scene))
        if (const auto words = QString::fromStdString(found.message.english());
            words.contains("as on a hinge"))
            return words;
    return {};
}

} // namespace

class TestHingeCheck : public QObject
{
    Q_OBJECT

private slots:
    void sharpCornerIsNamed()
    {
        QCOMPARE(told(bentSpar(59.0)), QString());
        const QString words = told(bentSpar(61.0));
        QVERIFY2(words.contains("a spar of tube turns by 61 degrees"), qPrintable(words));
        QVERIFY(!told(bentSpar(150.0)).isEmpty());
    }

    void whatIsHeldIsNot()
    {
        const auto tie = [](Chain& chain, std::size_t from, std::size_t to) {
            Link link = chain.row().links.front();
            link.id = takeId(chain.scene);
            link.from = chain.row().particles[from].id;
            link.to = chain.row().particles[to].id;
            chain.row().links.push_back(link);
        };
        Chain braced = bentSpar(90.0);
        tie(braced, 0, 2);
        QCOMPARE(told(braced), QString());

        Chain rigged = bentSpar(90.0);
        const Id mast = takeId(rigged.scene);
        rigged.row().particles.push_back(
            {.id = mast, .position = Vec3(1, 0, 1), .mass = 0.1, .pinned = true});
        tie(rigged, 1, 3);
        QCOMPARE(told(rigged), QString());

        Chain pinned = bentSpar(90.0);
        pinned.row().particles[1].pinned = true;
        QCOMPARE(told(pinned), QString());

        Chain cord = bentSpar(90.0);
        cord.stuff().flexuralRigidity = 0.0;
        QCOMPARE(told(cord), QString());
    }

    // Links without a length have no direction to turn from.
    void nothingOfLinksWithoutLength()
    {
        Chain chain = bentSpar(90.0);
        chain.row().particles[2].position = chain.row().particles[1].position;
        QCOMPARE(told(chain), QString());
    }
};

const RegisteredTest registered("test_hinge_check", runPlain<TestHingeCheck>);

} // namespace ripstop::test_hinge_check
#include "test_hinge_check.moc"
