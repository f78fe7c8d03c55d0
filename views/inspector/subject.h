// The things whose properties a form shows, and the way in which its fields write to them.
//
// Fields know neither selection nor document: they read what the things have in common and hand in
// a Transform, which is applied to the value of each thing. Everything that is written goes through
// edit() or drag(), so it is undoable and masses follow densities. It belongs to the thread of the
// window.
#pragma once

#include "document/census.h"
#include "inspector/last_directions.h"
#include "scene/edit.h"
#include "scene/typed_number.h"

#include <QObject>
#include <QString>

#include <functional>

namespace ripstop {

class Document;

// Makes the new value of a thing from the one that it has now.
using Transform = std::function<Value(const Value&)>;

Transform setTo(Value value);
Transform transformOf(TypedNumber typed, int axis = 0); // of a number, or of one axis of a vector

// The value of a property of several things. Numbers that are read as the same are the same: 40
// links of a line have rest lengths that differ in the last bits only.
struct Common
{
    Value value;                 // the value of the first thing
    std::array<bool, 3> mixed{}; // by axis of a vector; all others use the first
    bool isDefault = true;       // all things have the default
};

// Whether the fields show both with the same digits, but for a half of the last one.
bool readAlike(double a, double b);

// The things whose properties a form shows, and the way in which its fields write to them.
class Subject final : public QObject
{
    Q_OBJECT

public:
    Subject(Document& document, LastDirections& directions);

    void set(Kind kind, std::vector<Id> ids); // all exist and are of this kind

    Document& document() const { return m_document; }
    Kind kind() const { return m_kind; }
    const std::vector<Id>& ids() const { return m_ids; }

    std::vector<ConstRef> refs() const;                        // [ids] until the scene changes
    std::vector<Value> values(const Property& property) const; // [ids]
    static Common common(const Property& property, const std::vector<ConstRef>& refs);

    // Where the vectors of the things point, or last did where they are 0; none is 0. [ids]
    std::vector<Vec3> directions(const Property& property) const;
    void noteDirections(const Property& property); // as the things have them now

    // Why the property of some thing cannot become this, as half a sentence, or nothing.
    std::optional<QString> refusal(const Property& property, const Transform& transform) const;

    // One undoable edit of all things; nothing when it would change nothing.
    void edit(const Property& property, const Transform& transform);

    // One step of a gesture; `values` has one for each thing.
    void drag(const Property& property, std::vector<Value> values, int gesture);

    // The next selection becomes the value of `property`, instead of being shown.
    void pick(const Property& property);
    void cancelPick();
    const Property* picking() const { return m_picking; }

signals:
    void pickingChanged();

private:
    Edit settingOf(const Property& property, std::vector<Value> values) const;

    Document& m_document;
    LastDirections& m_directions;
    Kind m_kind = Kind::Settings;
    std::vector<Id> m_ids;
    const Property* m_picking = nullptr;
};

} // namespace ripstop
