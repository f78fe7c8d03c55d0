// The models behind trees and tables keep Qt's contract while a scene is edited at random: every
// change is announced before anyone can ask, also through the filter of the search.
//
// Stages: the outline and its filter under edits of items, undo, other searches and other scenes;
// then the table under edits of elements and other limits. The seeds are fixed.
#include "document/document.h"
#include "document/selection.h"
#include "outline/detail.h"
#include "outline/new_item.h"
#include "outline/outline_filter.h"
#include "outline/outline_model.h"
#include "table/sheet_model.h"
#include "views/run_with_widgets.h"
#include "views/small_scenes.h"

#include "scene/property.h"

#include <QAbstractItemModelTester>

#include <random>

namespace ripstop::test_models {

namespace {

constexpr int edits = 400;

struct Desk
{
    Document document;
    Selection selection{document};
    std::mt19937 random;

    explicit Desk(unsigned seed)
        : random(seed)
    {}

    std::size_t upTo(std::size_t end)
    {
        return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
    }
    const std::vector<Entry>& items() const { return document.scene().items; }

    void open(const char* name)
    {
        if (document.open(QStringLiteral(SCENES_DIR "/") + name + ".ripstop.json"))
            qFatal("no %s", name);
    }

    void addItem()
    {
        const Kind kind = addableKinds[upTo(addableKinds.size())];
        Entry entry = newItem(document.scene(), kind, {});
        document.push({Message("Add"), {AddItem{upTo(items().size() + 1), std::move(entry)}}});
    }
    void removeItem()
    {
        if (!items().empty())
            document.push(removal(document.scene(), {items()[upTo(items().size())].id}));
    }
    void rename()
    {
        if (items().empty())
            return;
        const Entry& entry = items()[upTo(items().size())];
        const Kind kind = kindOf(*find(document.scene(), entry.id));
        if (const Property* name = findProperty(kind, Meaning::Name))
            document.push({Message("Rename"),
                           {SetValues{name, {entry.id}, {"n" + std::to_string(upTo(30))}}}});
    }
    void removeElements()
    {
        std::vector<Id> ids;
        forEachPart(document.scene(), [&](Id, const Part& part) {
            if (!part.particles.empty())
                ids.push_back(part.particles[upTo(part.particles.size())].id);
        });
        if (!ids.empty())
            document.push(removal(document.scene(), ids));
    }
    void editAtRandom()
    {
        switch (upTo(8)) {
        case 0:
        case 1:
            return addItem();
        case 2:
            return removeItem();
        case 3:
            return rename();
        case 4:
            return removeElements();
        case 5:
            return document.history().undo();
        case 6:
            return document.history().redo();
        default:
            for (int i = 0; i < 5; ++i)
                document.history().undo();
        }
    }
};

// Asks for all that a view would.
int readAll(const QAbstractItemModel& model, const QModelIndex& parent = {})
{
    int read = 0;
    for (int row = 0; row < model.rowCount(parent); ++row) {
        for (int column = 0; column < model.columnCount(parent); ++column) {
            const QModelIndex index = model.index(row, column, parent);
            for (const int role : {Qt::DisplayRole, Qt::ToolTipRole, Qt::DecorationRole})
                (void)model.data(index, role);
            (void)model.flags(index);
            ++read;
        }
        read += readAll(model, model.index(row, 0, parent));
    }
    return read;
}

} // namespace

class TestModels : public QObject
{
    Q_OBJECT

private slots:
    // A wind of 8 m/s at 20 ft has gusts of 1.5 m/s: the outline names what it is and no speed.
    void gustsAreNamedByTheirTurbulence()
    {
        Wind wind;
        wind.velocity = Vec3(8, 0, 0);
        QCOMPARE(itemDetail({}, wind), QString("8\u00a0m/s"));
        wind.kind = WindKind::Gusts;
        for (const auto& [speed, name] :
             {std::pair(7.7, "light"), {15.4, "moderate"}, {23.2, "severe"}}) {
            wind.gustiness = speed;
            QCOMPARE(itemDetail({}, wind), QString(name));
        }
    }

    // #17 is the thing with this id, or the table of a part that has an element of this id.
    void numbersAreFound()
    {
        Desk desk(1);
        desk.document.replace(oneOfEverything());
        OutlineModel model(desk.document, desk.selection, nullptr);
        OutlineFilter filter(model, nullptr);
        const auto found = [&](const char* text) {
            filter.search(text);
            QStringList names;
            QModelIndex at = filter.index(0, 0);
            for (; at.isValid(); at = filter.index(0, 0, at)) {
                names << at.data().toString();
                if (filter.rowCount(at.parent()) != 1)
                    names << "and others";
            }
            return names;
        };
        QCOMPARE(found("#6"), (QStringList{"Parts", "sail", "Links"}));
        QCOMPARE(found(" #9 "), (QStringList{"Materials", "thread"}));
        QCOMPARE(found("#77"), QStringList()); // there is none
        filter.search({});
        const int all = readAll(filter);
        filter.search("#"); // a number is about to come
        QCOMPARE(readAll(filter), all);
    }

    void outline_data()
    {
        QTest::addColumn<unsigned>("seed");
        QTest::addColumn<QString>("search");
        for (unsigned seed = 1; seed <= 3; ++seed)
            for (const char* search : {"", "n1", "line", "no such thing"})
                QTest::addRow("%u %s", seed, search) << seed << QString(search);
    }
    void outline()
    {
        QFETCH(unsigned, seed);
        QFETCH(QString, search);
        using Tester = QAbstractItemModelTester;
        Desk desk(seed);
        desk.open("delta_kite");
        OutlineModel model(desk.document, desk.selection, nullptr);
        OutlineFilter filter(model, nullptr);
        const Tester ofModel(&model, Tester::FailureReportingMode::QtTest);
        const Tester ofFilter(&filter, Tester::FailureReportingMode::QtTest);
        filter.search(search);
        for (int i = 0; i < edits; ++i) {
            desk.editAtRandom();
            if (i % 60 == 20)
                filter.search(i % 120 == 20 ? QString() : search);
            if (i % 150 == 149)
                desk.open(i % 300 == 149 ? "cloth" : "delta_kite");
            if (i % 10 == 0)
                (void)readAll(filter);
            if (QTest::currentTestFailed())
                return;
        }
        filter.search({});
        QVERIFY(readAll(filter) > 0);
        // nothing is missing and nothing is left over
        std::size_t things = 0;
        for (int row = 0; row < model.rowCount(); ++row)
            if (const QModelIndex section = model.index(row, 0);
                model.node(section).sort == OutlineModel::Node::Sort::Section)
                things += std::size_t(model.rowCount(section));
        QCOMPARE(things, desk.items().size());
    }

    void table_data()
    {
        QTest::addColumn<unsigned>("seed");
        QTest::addColumn<int>("sheet");
        for (const int sheet : {int(SheetOf::Particles), int(SheetOf::Links), int(SheetOf::Panels)})
            QTest::addRow("sheet %d", sheet) << unsigned(sheet + 7) << sheet;
    }
    void table()
    {
        QFETCH(unsigned, seed);
        QFETCH(int, sheet);
        using Tester = QAbstractItemModelTester;
        Desk desk(seed);
        desk.open("delta_kite");
        SheetModel model(desk.document);
        const Tester tester(&model, Tester::FailureReportingMode::QtTest);
        model.show(SheetOf(sheet));
        model.limitTo(std::nullopt);
        for (int i = 0; i < edits / 4; ++i) {
            desk.editAtRandom();
            model.reload();
            if (i % 20 == 5)
                model.limitTo(std::vector<Id>());
            if (i % 20 == 10)
                model.limitTo(std::nullopt);
            if (i % 25 == 24)
                model.sort(int(desk.upTo(model.columns().size())), Qt::DescendingOrder);
            QTRY_VERIFY(!model.isSorting());
            if (i % 10 == 0)
                (void)readAll(model);
            if (QTest::currentTestFailed())
                return;
        }
    }
};

const RegisteredTest registered("test_models", runWithWidgets<TestModels>);

} // namespace ripstop::test_models
#include "test_models.moc"
