// Makes the edit that brings a built scene into an open one:
// 1. What the wish leaves out goes: planes and winds, or controls, probes and plots.
// 2. The rest is shifted to its place, and names that are taken get a number.
// 3. pasted() of copy.h gives it fresh ids and makes the edit.
// 4. Settings of the design are added where the scene still has the first ones; substeps only
//    rise.
#include "shaping/insert.h"

#include "derived/collider_shape.h"
#include "shaping/copy.h"

#include <algorithm>
#include <set>

namespace ripstop {
namespace {

bool isSurrounding(const Item& item)
{
    const Collider* collider = std::get_if<Collider>(&item);
    return std::holds_alternative<Wind>(item)
           || (collider && collider->shape == ColliderShape::Plane);
}

// What one sees in the view and would move.
bool isBody(const Item& item)
{
    return std::holds_alternative<Part>(item)
           || (std::holds_alternative<Collider>(item) && !isSurrounding(item));
}

bool isInstrument(const Item& item)
{
    return std::holds_alternative<Control>(item) || std::holds_alternative<Probe>(item)
           || std::holds_alternative<Plot>(item);
}

Vec3 shiftOf(const InsertWish& wish, const Eigen::AlignedBox3d& there,
             const Eigen::AlignedBox3d& built)
{
    if (wish.at == PlaceAt::Shift)
        return wish.place;
    if (built.isEmpty())
        return Vec3::Zero();
    if (wish.at == PlaceAt::Point)
        return wish.place - built.center();
    if (wish.at == PlaceAt::Beside && !there.isEmpty()) {
        const double gap = 0.1 * std::max(built.sizes().x(), built.sizes().z());
        return (there.max().z() + gap - built.min().z()) * Vec3::UnitZ();
    }
    return Vec3::Zero();
}

void shift(Scene& scene, const Vec3& by)
{
    if (by.isZero())
        return;
    for (Entry& entry : scene.items) {
        if (Part* part = std::get_if<Part>(&entry.item)) {
            for (Particle& row : part->particles)
                row.position += by;
        } else if (Collider* collider = std::get_if<Collider>(&entry.item)) {
            if (!isSurrounding(entry.item))
                *collider = placed(*collider, shifted(by));
        } else if (Wind* wind = std::get_if<Wind>(&entry.item)) {
            wind->position += by;
        }
    }
}

// "sail", "sail 2", ...: the first that is free. A material that is there already keeps its name,
// and is found again by it.
void giveFreeNames(Scene& built, const Scene& scene)
{
    std::set<std::string> taken;
    for (const Entry& entry : scene.items)
        taken.insert(nameOf(entry.item));
    const auto isThere = [&](const Item& item) {
        return std::holds_alternative<Material>(item)
               && std::ranges::any_of(scene.items,
                                      [&](const Entry& other) { return other.item == item; });
    };
    for (Entry& entry : built.items) {
        if (isThere(entry.item))
            continue;
        std::visit(
            [&](auto& item) {
                const std::string base = item.name;
                for (int i = 2; !taken.insert(item.name).second; ++i)
                    item.name = base + " " + std::to_string(i);
            },
            entry.item);
    }
}

// Settings that the design was built with, where the scene has what every scene has at first.
void addSettings(Insertion& insertion, const Scene& scene, const Scene& built,
                 const InsertWish& wish)
{
    const bool isFirst = !std::ranges::any_of(
        scene.items, [](const Entry& entry) { return std::get_if<Part>(&entry.item); });
    const Settings usual;
    const auto set = [&](const Property& property, const Value& value) {
        insertion.edit.changes.emplace_back(SetValues{&property, {settingsId}, {value}});
    };
    for (const Property& property : propertiesOf(Kind::Settings)) {
        const Value wanted = property.get(&built.settings);
        const Value held = property.get(&scene.settings);
        if (wanted == held || wanted == property.get(&usual))
            continue;
        const bool isTitle = isOneOf<&Settings::title, &Settings::notes>(property);
        if (isOneOf<&Settings::substeps>(property)) {
            if (std::get<int>(wanted) <= std::get<int>(held))
                continue;
            insertion.substeps = std::get<int>(wanted);
            set(property, wanted);
        } else if (held == property.get(&usual) && wish.withSurroundings && (isFirst || !isTitle)) {
            set(property, wanted);
        }
    }
}

} // namespace

InsertGround groundOf(const Scene& scene)
{
    InsertGround ground;
    ground.scene.settings = scene.settings;
    ground.scene.nextId = scene.nextId;
    ground.box = boxOf(scene);
    for (const Entry& entry : scene.items)
        if (const Part* part = std::get_if<Part>(&entry.item)) {
            Part empty;
            empty.name = part->name;
            ground.scene.items.push_back({entry.id, std::move(empty)});
        } else {
            ground.scene.items.push_back(entry);
        }
    return ground;
}

bool hasSurroundings(const Scene& scene)
{
    return std::ranges::any_of(scene.items,
                               [](const Entry& entry) { return isSurrounding(entry.item); });
}

Insertion inserted(const InsertGround& ground, Scene built, const InsertWish& wish)
{
    std::erase_if(built.items, [&](const Entry& entry) {
        return (isSurrounding(entry.item) && !wish.withSurroundings)
               || (isInstrument(entry.item) && !wish.withInstruments);
    });
    shift(built, shiftOf(wish, ground.box, extentOf(built)));
    giveFreeNames(built, ground.scene);
    Copies copies = pasted(ground.scene, built);
    Insertion insertion{std::move(copies.edit), {}, 0};
    insertion.edit.label = Message("Insert %1", Message::word(wish.label));
    for (const Change& change : insertion.edit.changes)
        if (const auto* added = std::get_if<AddItem>(&change); added && isBody(added->entry.item))
            insertion.bodies.push_back(added->entry.id);
    addSettings(insertion, ground.scene, built, wish);
    return insertion;
}

Eigen::AlignedBox3d boxOf(const Scene& scene)
{
    Eigen::AlignedBox3d box;
    forEachPart(scene, [&](Id, const Part& part) {
        for (const Particle& row : part.particles)
            box.extend(row.position);
    });
    return box;
}

Eigen::AlignedBox3d extentOf(const Scene& scene)
{
    Eigen::AlignedBox3d box = boxOf(scene);
    if (!box.isEmpty())
        return box;
    for (const Entry& entry : scene.items) {
        const Collider* collider = std::get_if<Collider>(&entry.item);
        if (!collider || isSurrounding(entry.item))
            continue;
        // about its place, so that hills are put with their foot where others have their middle
        const ShapeRow& row = rowOf(collider->shape);
        const Eigen::AlignedBox3d own = row.bounds(solidOf(*collider));
        Vec3 half = own.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(0.5 * own.sizes());
        if (row.uses.turn)
            half = turnOf(*collider).cwiseAbs() * half;
        box.extend(Vec3(collider->position - half));
        box.extend(Vec3(collider->position + half));
    }
    return box;
}

} // namespace ripstop
