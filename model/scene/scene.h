// The scene: what the author made, before anything is computed from it.
// It is a plain value that can be copied, compared and saved; what the items and elements in it
// are stands in items.h. Every number in it is authored and none is derived. It has no lock: each
// thread works on a scene of its own or on one that nobody changes.
#pragma once

#include "scene/items.h"

#include <map>
#include <string>
#include <vector>

namespace ripstop {

struct Entry
{
    Id id{};
    Item item;

    friend bool operator==(const Entry&, const Entry&) = default;
};

// An item of a type that this version does not know. It does nothing, and stands here to be written
// back by the next save: as it was, behind the same item.
struct UnknownItem
{
    Id id{};
    Id after{};       // the known item before it; noId: it is before the first
    std::string type; // as the file calls it
    std::string text; // its JSON object

    friend bool operator==(const UnknownItem&, const UnknownItem&) = default;
};

// The folder that the files of a scene are seen from: that of the scene file, or the working
// directory when there is none. Where a scene lies is not part of what it is.
struct Folder
{
    std::string path;

    friend bool operator==(const Folder&, const Folder&) { return true; }
};

// Only apply() (edit.h), the file reader and the builders write to a scene.
struct Scene
{
    Settings settings;
    std::vector<Entry> items;              // in the author's order
    std::vector<UnknownItem> unknownItems; // likewise
    Id nextId{1};                          // above every id ever used
    std::map<Id, std::string> unknown;     // JSON objects with the keys that this version does not
                                           // know, kept for the next save; noId for the file itself
    Folder folder;                         // not saved

    friend bool operator==(const Scene&, const Scene&) = default;
};

// A fresh id; the only way to make one.
Id takeId(Scene& scene);

// The item with this id; null when there is none, or when it is of another type. It reads the list
// of items from the start, which is short.
const Item* findItem(const Scene& scene, Id id);
Item* findItem(Scene& scene, Id id);
template <typename T>
const T* findItem(const Scene& scene, Id id)
{
    const Item* item = findItem(scene, id);
    return item ? std::get_if<T>(item) : nullptr;
}

// The row with this id, or null. `rows` are in ascending order of id.
template <typename Row>
Row* findRow(std::vector<Row>& rows, Id id);
template <typename Row>
const Row* findRow(const std::vector<Row>& rows, Id id)
{
    return findRow(const_cast<std::vector<Row>&>(rows), id);
}

bool isPanel(const Scene& scene, Id element); // of any part

// The name of an item of any kind.
const std::string& nameOf(const Item& item);

// Calls visit(id, part) for each part in the author's order.
template <typename Visit>
void forEachPart(const Scene& scene, Visit visit)
{
    for (const Entry& entry : scene.items)
        if (const Part* part = std::get_if<Part>(&entry.item))
            visit(entry.id, *part);
}

} // namespace ripstop
