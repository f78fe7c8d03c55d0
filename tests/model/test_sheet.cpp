// A design as a table: rows, their order, what cells take.
//
// Stages: rows and columns of a scene and their sorting; then what cells read and show, blocks
// that are pasted, one value for all, names of items; and what is refused with which words.
#include "registered_test.h"
#include "select/sheet.h"

#include <QtTest>

#include <cmath>

namespace ripstop::test_sheet {

namespace {

// Ids: 1 part (2, 3, 4 particles of 30, 10 and 20 g; 5 a line, 6 a thread), 7 and 8 materials.
Scene small()
{
    Scene scene;
    Part part;
    part.name = "kite";
    part.particles = {{.id = Id{2}, .position = Vec3(1, 2, 3), .mass = 0.03},
                      {.id = Id{3}, .mass = 0.01},
                      {.id = Id{4}, .mass = 0.02, .pinned = true}};
    part.links = {{.id = Id{5}, .from = Id{2}, .to = Id{3}, .material = Id{8}},
                  {.id = Id{6}, .from = Id{3}, .to = Id{4}, .material = Id{7}}};
    part.links[1].role = LinkRole::Thread;
    part.links[1].tearLimit = 5.0;
    scene.items = {{Id{1}, part}, {Id{7}, Material{"silk"}}, {Id{8}, Material{"dyneema"}}};
    scene.nextId = Id{9};
    return scene;
}

SheetColumn column(SheetOf sheet, std::string_view key, int axis = 0)
{
    return {findProperty(kindOf(sheet), key), axis};
}

std::vector<Id> ids(std::initializer_list<std::uint32_t> numbers)
{
    std::vector<Id> list;
    for (const std::uint32_t number : numbers)
        list.push_back(Id{number});
    return list;
}

std::vector<Id> order(const Scene& scene, SheetOf sheet, std::string_view key,
                      SheetOrder direction = SheetOrder::Rising)
{
    return sorted(sheetKeys(scene, sheetRows(scene, sheet), column(sheet, key)), direction);
}

Value valueOf(const Scene& scene, Id id, std::string_view key)
{
    const ConstRef thing = *find(scene, id);
    return findProperty(kindOf(thing), key)->get(thing);
}

} // namespace

class TestSheet : public QObject
{
    Q_OBJECT

private slots:
    void rows()
    {
        const Scene scene = small();
        QVERIFY(sheetRows(scene, SheetOf::Particles) == ids({2, 3, 4}));
        QVERIFY(sheetRows(scene, SheetOf::Links) == ids({5, 6}));
        QVERIFY(sheetRows(scene, SheetOf::Lines) == ids({5})); // threads are none
        QVERIFY(sheetRows(scene, SheetOf::Materials) == ids({7, 8}));
        QVERIFY(sheetRows(scene, SheetOf::Panels).empty());
    }

    // Every property has its column, and vectors have three.
    void columns()
    {
        for (const SheetOf sheet : {SheetOf::Particles, SheetOf::Links, SheetOf::Lines,
                                    SheetOf::Panels, SheetOf::Materials}) {
            std::size_t expected = 1; // the id
            for (const Property& property : propertiesOf(kindOf(sheet)))
                expected += std::holds_alternative<Vec3>(property.initial) ? 3 : 1;
            QCOMPARE(sheetColumns(sheet).size(), expected);
        }
    }

    void sorting()
    {
        const Scene scene = small();
        QVERIFY(order(scene, SheetOf::Particles, "mass") == ids({3, 4, 2}));
        QVERIFY(order(scene, SheetOf::Particles, "mass", SheetOrder::Falling) == ids({2, 4, 3}));
        QVERIFY(order(scene, SheetOf::Particles, "pinned") == ids({2, 3, 4})); // equals by id
        QVERIFY(order(scene, SheetOf::Particles, "pinned", SheetOrder::Falling) == ids({4, 2, 3}));
        QVERIFY(order(scene, SheetOf::Links, "material") == ids({5, 6})); // dyneema, silk
        // what has none comes last, whatever the direction
        QVERIFY(order(scene, SheetOf::Links, "tearLimit") == ids({6, 5}));
        QVERIFY(order(scene, SheetOf::Links, "tearLimit", SheetOrder::Falling) == ids({6, 5}));
    }

    void cells()
    {
        const Scene scene = small();
        const auto text = [&](Id id, const SheetColumn& at) {
            return cellText(scene, *find(scene, id), at);
        };
        QCOMPARE(text(Id{2}, column(SheetOf::Particles, "mass")), std::string("0.03"));
        QCOMPARE(text(Id{2}, column(SheetOf::Particles, "position", 1)), std::string("2"));
        QCOMPARE(text(Id{5}, column(SheetOf::Links, "material")), std::string("dyneema"));
        QCOMPARE(text(Id{5}, column(SheetOf::Links, "from")), std::string("#2"));
        QCOMPARE(text(Id{5}, column(SheetOf::Links, "tearLimit")), std::string());
    }

    // A spreadsheet gives tabs, carriage returns, units, and decimals with a comma.
    void aBlockIsPasted()
    {
        Scene scene = small();
        const Scene before = scene;
        const std::vector<SheetColumn> columns{
            column(SheetOf::Particles, "position", 0), column(SheetOf::Particles, "position", 1),
            column(SheetOf::Particles, "position", 2), column(SheetOf::Particles, "mass")};
        const auto edit = pasted(scene, ids({2, 3, 4}), columns,
                                 "10 cm\t2\t3\t5 g\r\n0,5\t\u22121\t2*3\t+100 %\r\n");
        QVERIFY2(edit, edit ? "" : edit.message().english().c_str());
        const Edit inverse = apply(scene, *edit);
        QVERIFY(valueOf(scene, Id{2}, "position") == Value(Vec3(0.1, 2, 3)));
        QVERIFY(valueOf(scene, Id{3}, "position") == Value(Vec3(0.5, -1, 6)));
        QVERIFY(valueOf(scene, Id{2}, "mass") == Value(0.005));
        QVERIFY(valueOf(scene, Id{3}, "mass") == Value(0.02));
        QVERIFY(valueOf(scene, Id{4}, "mass") == Value(0.02)); // no line for it
        (void)apply(scene, inverse);
        QVERIFY(scene == before);
    }

    void oneCellGoesIntoAll()
    {
        Scene scene = small();
        const auto edit = pasted(scene, ids({2, 4}), {column(SheetOf::Particles, "mass")}, "*2\n");
        QVERIFY(edit);
        (void)apply(scene, *edit);
        QVERIFY(valueOf(scene, Id{2}, "mass") == Value(0.06));
        QVERIFY(valueOf(scene, Id{3}, "mass") == Value(0.01));
        QVERIFY(valueOf(scene, Id{4}, "mass") == Value(0.04));
    }

    void wordsNamesAndNothing()
    {
        Scene scene = small();
        const std::vector<SheetColumn> columns{column(SheetOf::Links, "material"),
                                               column(SheetOf::Links, "kind"),
                                               column(SheetOf::Links, "tearLimit")};
        const auto edit = pasted(scene, ids({5, 6}), columns, "silk\tspring\t3\n#8\trod\t\n");
        QVERIFY2(edit, edit ? "" : edit.message().english().c_str());
        (void)apply(scene, *edit);
        QVERIFY(valueOf(scene, Id{5}, "material") == Value(Id{7}));
        QVERIFY(valueOf(scene, Id{6}, "material") == Value(Id{8}));
        QVERIFY(valueOf(scene, Id{5}, "kind") == Value(std::string("spring")));
        QVERIFY(valueOf(scene, Id{6}, "tearLimit") == Value(std::monostate()));
    }

    // All or nothing, and the message names the place.
    void whatDoesNotFit_data()
    {
        QTest::addColumn<QString>("block");
        QTest::addColumn<QString>("says");
        QTest::newRow("a word") << "1 g\nheavy"
                                << "Line 2, Mass: \"heavy\"";
        QTest::newRow("a wrong unit") << "1 m"
                                      << "must be in kg";
        QTest::newRow("a negative mass") << "1 g\n2 g\n-3 g"
                                         << "Line 3, Mass";
        QTest::newRow("too many lines") << "1\n2\n3\n4"
                                        << "4 lines to paste and 3 rows";
        QTest::newRow("too many cells") << "1 g\tyes\t1\t2\t3"
                                        << "begin further left";
        QTest::newRow("a wrong switch") << "1 g\tperhaps"
                                        << "Line 1, Pinned";
    }
    void whatDoesNotFit()
    {
        QFETCH(QString, block);
        QFETCH(QString, says);
        const std::vector<SheetColumn> columns{column(SheetOf::Particles, "mass"),
                                               column(SheetOf::Particles, "pinned")};
        const auto edit = pasted(small(), ids({2, 3, 4}), columns, block.toStdString());
        QVERIFY(!edit);
        QVERIFY2(QString::fromStdString(edit.message().english()).contains(says),
                 edit.message().english().c_str());
    }

    void namesThatDoNotExist()
    {
        const auto edit = pasted(small(), ids({5}), {column(SheetOf::Links, "material")}, "slik");
        QVERIFY(!edit && edit.message().english().find("silk") != std::string::npos); // the nearest
        QVERIFY(!pasted(small(), ids({5}), {{}}, "7"));                               // ids stay
    }
};

const RegisteredTest registered("test_sheet", runPlain<TestSheet>);

} // namespace ripstop::test_sheet
#include "test_sheet.moc"
