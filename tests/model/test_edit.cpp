// Edits: every change has an inverse that gives the scene back.
//
// Stages: a table of edits is applied, undone and redone, one by one and many in a row; where
// items and rows go; then removals and what hangs on what is removed; gestures; and what an edit
// does at worst to a run.
#include "registered_test.h"
#include "scene/edit.h"

#include <QtTest>

Q_DECLARE_METATYPE(ripstop::Edit)

namespace ripstop::test_edit {

namespace {

// Two parts, a material, a group, a control and two probes that point at them. Ids in the order
// of the items, elements after them.
struct Sample
{
    Id fabric{1}, sail{2}, line{3}, corners{4}, pull{5}, tension{6}, height{7};
    Id a{11}, b{12}, c{13}, ab{14}, bc{15}, ca{16}, panel{17}; // of the sail
    Id hand{21}, knot{22}, rope{23}, bridle{24};               // of the line; b is tied to hand
    Scene scene;

    Sample()
    {
        Part sailPart{"sail"};
        sailPart.particles = {{a, {0, 0, 0}}, {b, {1, 0, 0}}, {c, {0, 1, 0}}};
        sailPart.links = {{ab, a, b, fabric}, {bc, b, c, fabric}, {ca, c, a, fabric}};
        sailPart.panels = {{panel, a, b, c, fabric}};
        Part linePart{"line"};
        linePart.particles = {{hand, {1, -1, 0}}, {knot, {1, -2, 0}}};
        linePart.links = {{rope, hand, knot}, {bridle, hand, b}};
        Control control{"pull"};
        control.targets = {hand, a};
        Probe tensionProbe{"tension", Quantity::Tension, rope};
        Probe heightProbe{"height", Quantity::Elevation, a, hand};
        scene.items = {{fabric, Material{"fabric"}},
                       {sail, sailPart},
                       {line, linePart},
                       {corners, Group{"corners", {a, b, panel}}},
                       {pull, control},
                       {tension, tensionProbe},
                       {height, heightProbe}};
        scene.nextId = Id{30};
    }

    const Part& part(Id id) const { return *findItem<Part>(scene, id); }
};

const Property* row(Kind kind, const char* key)
{
    const Property* found = findProperty(kind, key);
    Q_ASSERT(found);
    return found;
}

Edit one(Change change) { return {Message("test"), {std::move(change)}}; }

std::vector<Id> membersOf(const Scene& scene, Id group)
{
    return findItem<Group>(scene, group)->members;
}

} // namespace

class TestEdit : public QObject
{
    Q_OBJECT

private slots:
    void undoAndRedo_data()
    {
        const Sample s;
        const auto* mass = row(Kind::Particle, "mass");
        QTest::addColumn<Edit>("edit");

        QTest::newRow("nothing") << Edit{};
        QTest::newRow("one value") << one(SetValues{mass, {s.a}, {0.5}});
        QTest::newRow("one value for many") << one(SetValues{mass, {s.a, s.c, s.hand}, {0.5}});
        QTest::newRow("a value for each") << one(SetValues{mass, {s.c, s.a, s.b}, {0.1, 0.2, 0.3}});
        QTest::newRow("a setting") << one(SetValues{
            row(Kind::Settings, "solver"), {settingsId}, {std::string("averaged_jacobi")}});
        QTest::newRow("the same value twice") << Edit{
            Message("test"), {SetValues{mass, {s.a}, {0.5}}, SetValues{mass, {s.a}, {0.7}}}};
        QTest::newRow("an absent value")
            << one(SetValues{row(Kind::Link, "stiffness"), {s.ab}, {40.0}});
        QTest::newRow("a list of ids")
            << one(SetValues{row(Kind::Group, "members"), {s.corners}, {std::vector{s.c}}});
        QTest::newRow("item at the front") << one(AddItem{0, {Id{30}, Wind{"breeze"}}});
        QTest::newRow("item in the middle") << one(AddItem{3, {Id{30}, Wind{"breeze"}}});
        QTest::newRow("item at the end") << one(AddItem{7, {Id{30}, Wind{"breeze"}}});
        QTest::newRow("item beyond the end") << one(AddItem{99, {Id{30}, Wind{"breeze"}}});
        QTest::newRow("item away") << one(RemoveItem{s.fabric});
        QTest::newRow("part away") << one(RemoveItem{s.sail});
        QTest::newRow("rows") << one(
            AddRows{s.sail, {{Id{30}}}, {{Id{31}, Id{30}, s.a}}, {{Id{32}, s.a, s.b, Id{30}}}});
        QTest::newRow("rows between others")
            << one(AddRows{s.line, {{Id{25}}, {Id{18}}}, {{Id{19}, s.hand, Id{18}}}, {}});
        QTest::newRow("rows away") << one(RemoveRows{s.sail, {s.b}, {s.bc, s.ab}, {s.panel}});
        QTest::newRow("all rows away")
            << one(RemoveRows{s.line, {s.knot, s.hand}, {s.bridle, s.rope}, {}});
        QTest::newRow("part, then rows in it")
            << Edit{Message("test"),
                    {AddItem{7, {Id{30}, Part{"tail"}}}, AddRows{Id{30}, {{Id{31}}}, {}, {}},
                     SetValues{mass, {Id{31}}, {2.0}}}};
        QTest::newRow("removal of a particle") << removal(s.scene, {s.b});
        QTest::newRow("removal of everything")
            << removal(s.scene, {s.fabric, s.sail, s.line, s.corners, s.pull, s.tension, s.height});
    }

    // apply, apply the inverse, apply the inverse of that: the scene as it was and as it became.
    void undoAndRedo()
    {
        QFETCH(Edit, edit);
        Sample sample;
        Scene& scene = sample.scene;
        const Scene before = scene;

        const Edit undo = apply(scene, edit);
        const Scene after = scene;
        QCOMPARE(undo.label, edit.label);
        QCOMPARE(undo.changes.size(), edit.changes.size());

        const Edit redo = apply(scene, undo);
        // ids that were used stay used; the rest is as it was
        QVERIFY(scene.nextId == after.nextId);
        scene.nextId = before.nextId;
        QVERIFY(scene == before);

        scene.nextId = after.nextId;
        (void)apply(scene, redo);
        QVERIFY(scene == after);
    }

    void manyEditsUndoInReverse()
    {
        Sample sample;
        Scene& scene = sample.scene;
        const Scene before = scene;
        std::vector<Edit> history;
        history.push_back(apply(scene, removal(scene, {sample.b})));
        history.push_back(apply(scene, one(AddItem{2, {Id{30}, Wind{"breeze"}}})));
        history.push_back(apply(scene, one(AddRows{sample.sail, {{Id{31}}}, {}, {}})));
        history.push_back(apply(scene, removal(scene, {sample.sail})));
        while (!history.empty()) {
            (void)apply(scene, history.back());
            history.pop_back();
        }
        scene.nextId = before.nextId;
        QVERIFY(scene == before);
    }

    void setsWhatItSays()
    {
        Sample s;
        (void)apply(s.scene, one(SetValues{row(Kind::Particle, "mass"), {s.c, s.a}, {3.0, 1.0}}));
        QCOMPARE(s.part(s.sail).particles[0].mass, 1.0);
        QCOMPARE(s.part(s.sail).particles[1].mass, Particle().mass);
        QCOMPARE(s.part(s.sail).particles[2].mass, 3.0);
    }

    void itemsGoWhereTheyAreTold()
    {
        Sample s;
        (void)apply(s.scene, one(AddItem{1, {Id{30}, Wind{"breeze"}}}));
        QCOMPARE(s.scene.items.size(), std::size_t(8));
        QVERIFY(s.scene.items[0].id == s.fabric);
        QVERIFY(s.scene.items[1].id == Id{30});
        QVERIFY(s.scene.items[2].id == s.sail);
    }

    // The tables are searched by halves.
    void rowsStayInOrderOfId()
    {
        Sample s;
        (void)apply(s.scene, one(AddRows{s.sail, {{Id{40}}, {Id{5}}, {Id{12 + 8}}}, {}, {}}));
        std::vector<Id> ids;
        for (const Particle& row : s.part(s.sail).particles)
            ids.push_back(row.id);
        QVERIFY((ids == std::vector{Id{5}, s.a, s.b, s.c, Id{20}, Id{40}}));
    }

    void idsAreNeverUsedAgain()
    {
        Sample s;
        const auto add = [&] {
            const Id id = s.scene.nextId;
            return std::pair(id, apply(s.scene, one(AddItem{0, {id, Wind{}}})));
        };
        const auto [first, undo] = add();
        (void)apply(s.scene, undo);
        QVERIFY(!findItem(s.scene, first));
        const auto [second, undoSecond] = add();
        QVERIFY(second > first);

        const Id row = s.scene.nextId;
        const Edit undoRows = apply(s.scene, one(AddRows{s.sail, {{row}}, {}, {}}));
        (void)apply(s.scene, undoRows);
        QVERIFY(s.scene.nextId > row);
        QVERIFY(takeId(s.scene) > row);

        // a part brings the ids of its elements
        Part part;
        part.particles = {{Id{100}}};
        part.links = {{Id{101}}};
        part.panels = {{Id{102}}};
        (void)apply(s.scene, one(AddItem{0, {Id{90}, part}}));
        QVERIFY(s.scene.nextId == Id{103});
    }

    void removalOfAParticle()
    {
        Sample s;
        (void)apply(s.scene, removal(s.scene, {s.b}));
        const Part& sail = s.part(s.sail);
        QCOMPARE(sail.particles.size(), std::size_t(2));
        QCOMPARE(sail.links.size(), std::size_t(1)); // ca alone has both its ends
        QVERIFY(sail.links[0].id == s.ca);
        QVERIFY(sail.panels.empty());
        // the link of another part that was tied to it
        QCOMPARE(s.part(s.line).links.size(), std::size_t(1));
        QVERIFY(s.part(s.line).links[0].id == s.rope);
        // the group loses the particle, and the panel that went with it
        QVERIFY(membersOf(s.scene, s.corners) == std::vector{s.a});
    }

    void removalOfAPart()
    {
        Sample s;
        (void)apply(s.scene, removal(s.scene, {s.line}));
        QVERIFY(!findItem(s.scene, s.line));
        QVERIFY(findItem<Control>(s.scene, s.pull)->targets == std::vector{s.a});
        QVERIFY(findItem<Probe>(s.scene, s.tension)->target == noId);
        QVERIFY(findItem<Probe>(s.scene, s.height)->target == s.a);
        QVERIFY(findItem<Probe>(s.scene, s.height)->from == noId);
        QCOMPARE(s.part(s.sail).links.size(), std::size_t(3));
    }

    void removalOfAMaterial()
    {
        Sample s;
        (void)apply(s.scene, removal(s.scene, {s.fabric}));
        for (const Link& link : s.part(s.sail).links)
            QVERIFY(link.material == noId);
        QVERIFY(s.part(s.sail).panels[0].material == noId);
        QCOMPARE(s.part(s.sail).links.size(), std::size_t(3));
    }

    void removalOfALink()
    {
        Sample s;
        (void)apply(s.scene, removal(s.scene, {s.rope}));
        QCOMPARE(s.part(s.line).particles.size(), std::size_t(2));
        QCOMPARE(s.part(s.line).links.size(), std::size_t(1));
        QVERIFY(findItem<Probe>(s.scene, s.tension)->target == noId);
    }

    void removalOfNothing()
    {
        const Sample s;
        QVERIFY(removal(s.scene, {}).changes.empty());
        QVERIFY(removal(s.scene, {Id{999}}).changes.empty());
        QVERIFY(removal(s.scene, {settingsId}).changes.empty());
    }

    // Nothing that is left may point at what is gone.
    void removalLeavesNothingDangling()
    {
        const Sample sample;
        for (std::uint32_t id = 1; id < 25; ++id) {
            Scene scene = sample.scene;
            (void)apply(scene, removal(scene, {Id{id}}));
            const auto check = [&](const ConstRef& ref) {
                for (const Property& p : propertiesOf(kindOf(ref))) {
                    const Value value = p.get(ref);
                    std::vector<Id> ids;
                    if (const Id* single = std::get_if<Id>(&value))
                        ids = {*single};
                    else if (const auto* list = std::get_if<std::vector<Id>>(&value))
                        ids = *list;
                    for (const Id target : ids)
                        QVERIFY2(target == noId || find(scene, target),
                                 qPrintable(QString("%1 -> %2").arg(id).arg(quint32(target))));
                }
            };
            for (const Entry& entry : scene.items)
                std::visit([&](const auto& item) { check(&item); }, entry.item);
            forEachPart(scene, [&](Id, const Part& part) {
                for (const Link& link : part.links)
                    check(&link);
                for (const Panel& panel : part.panels)
                    check(&panel);
            });
        }
    }

    void stepsOfOneGesture()
    {
        const Sample s;
        const auto* mass = row(Kind::Particle, "mass");
        const auto* pinned = row(Kind::Particle, "pinned");
        const Edit first = one(SetValues{mass, {s.a, s.b}, {0.5}});
        const Edit later = one(SetValues{mass, {s.a, s.b}, {0.1, 0.2}});
        const Edit fewer = one(SetValues{mass, {s.a}, {0.5}});
        const Edit other = one(SetValues{pinned, {s.a, s.b}, {true}});
        const Edit longer{Message("test"), {first.changes[0], first.changes[0]}};
        const Edit item = one(AddItem{0, {Id{30}, Wind{}}});
        QVERIFY(sameTargets(first, first));
        QVERIFY(sameTargets(first, later));
        QVERIFY(!sameTargets(first, fewer));
        QVERIFY(!sameTargets(first, other));
        QVERIFY(!sameTargets(first, longer));
        QVERIFY(!sameTargets(longer, first));
        QVERIFY(!sameTargets(item, item));
    }

    void worstEffects()
    {
        const Sample s;
        const SetValues name{row(Kind::Part, "name"), {s.sail}, {std::string("wing")}};
        const SetValues position{row(Kind::Particle, "position"), {s.a}, {Vec3(1.0, 2.0, 3.0)}};
        const SetValues mass{row(Kind::Particle, "mass"), {s.a}, {0.5}};
        QVERIFY(worstEffect(Edit{}) == Effect::DisplayOnly);
        QVERIFY(worstEffect(one(name)) == Effect::DisplayOnly);
        QVERIFY(worstEffect(one(position)) == Effect::OnReset);
        QVERIFY(worstEffect({Message("test"), {position, name}}) == Effect::OnReset);
        QVERIFY(worstEffect({Message("test"), {position, mass, name}}) == Effect::Recompile);
        QVERIFY(worstEffect(one(RemoveItem{s.sail})) == Effect::Recompile);
        QVERIFY(worstEffect(one(AddRows{s.sail, {}, {}, {}})) == Effect::Recompile);
    }

    void findsAnythingById()
    {
        Sample s;
        const auto kindAt = [&](Id id) { return kindOf(*find(std::as_const(s.scene), id)); };
        QVERIFY(kindAt(settingsId) == Kind::Settings);
        QVERIFY(kindAt(s.fabric) == Kind::Material);
        QVERIFY(kindAt(s.sail) == Kind::Part);
        QVERIFY(kindAt(s.b) == Kind::Particle);
        QVERIFY(kindAt(s.bridle) == Kind::Link);
        QVERIFY(kindAt(s.panel) == Kind::Panel);
        QVERIFY(!find(s.scene, Id{999}));
        QVERIFY(!find(s.scene, noId));
        QVERIFY(!findItem<Group>(s.scene, s.sail));
        QVERIFY(!findItem(s.scene, s.a)); // an element is no item
    }
};

const RegisteredTest registered("test_edit", runPlain<TestEdit>);

} // namespace ripstop::test_edit
#include "test_edit.moc"
