// The authored quantities of a scene, as data.
//
// One row describes one quantity completely. The file format, the inspector, the check of what a
// user typed, the command line's --set and the property manual all walk this table: a new
// quantity is a field in items.h, a row in property.cpp and its use.
//
// Whoever needs one particular property names it by its field, propertyOf<&Particle::mass>(), and
// asks for the others by what the table says of them: keys are for files, paths and people.
#pragma once

#include "base/result.h"
#include "scene/scene.h"

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ripstop {

enum class Kind {
    Settings,
    Particle,
    Link,
    Panel,
    Part,
    Material,
    Group,
    Collider,
    Wind,
    Control,
    Probe,
    Plot
};
inline constexpr int kindCount = 12;

// "settings", "particle", ...: the name in files and paths. The label is the same word on screen.
std::string_view kindName(Kind kind);
std::string_view kindPlural(Kind kind); // "particles": the tables of a part, the lists in a file
std::optional<Kind> kindFromName(std::string_view name);
bool isElement(Kind kind); // particle, link or panel

// One thing that has properties. The order is that of Kind.
using Ref = std::variant<Settings*, Particle*, Link*, Panel*, Part*, Material*, Group*, Collider*,
                         Wind*, Control*, Probe*, Plot*>;
using ConstRef = std::variant<const Settings*, const Particle*, const Link*, const Panel*,
                              const Part*, const Material*, const Group*, const Collider*,
                              const Wind*, const Control*, const Probe*, const Plot*>;

constexpr Kind kindOf(const ConstRef& ref) { return Kind(ref.index()); }
ConstRef asConst(const Ref& ref);

// The thing with this id anywhere in the scene; nothing when there is none.
std::optional<Ref> find(Scene& scene, Id id);
std::optional<ConstRef> find(const Scene& scene, Id id);

// A choice is held as its name. Nothing (monostate) means that an optional value is absent and
// comes from the material.
using Value = std::variant<std::monostate, bool, int, double, std::string, Vec3, Id,
                           std::vector<Id>, NumberRows>;

// What a change means to a simulation that is already running.
enum class Effect { DisplayOnly, Recompile, OnReset };

struct Range
{
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool openLow = false; // `low` itself is not allowed
};

// A set of enumerators, as bits.
template <typename Enum>
class SetOf
{
public:
    constexpr SetOf() = default;
    constexpr SetOf(std::initializer_list<Enum> members)
    {
        for (const Enum member : members)
            m_bits |= 1u << unsigned(member);
    }
    constexpr bool contains(Enum member) const { return (m_bits >> unsigned(member)) & 1u; }
    constexpr bool empty() const { return m_bits == 0; }

private:
    unsigned m_bits = 0;
};

using Kinds = SetOf<Kind>; // that an id may point at

// The field that a row is about, as something to compare: the place of the field in an example of
// its owner.
struct MemberPlace
{
    Kind kind;
    const void* place;

    friend constexpr bool operator==(const MemberPlace& a, const MemberPlace& b)
    {
        return a.kind == b.kind && a.place == b.place;
    }
};

template <typename T>
struct MemberOf;
template <typename Owner_, typename Field_>
struct MemberOf<Field_ Owner_::*>
{
    using Owner = Owner_;
    using Field = Field_;
};

template <typename Owner>
inline const Owner exampleOf{};
template <typename Owner>
inline constexpr Kind kindOfType = kindOf(ConstRef(static_cast<const Owner*>(nullptr)));
template <auto member>
inline constexpr MemberPlace memberPlace{
    kindOfType<typename MemberOf<decltype(member)>::Owner>,
    &(exampleOf<typename MemberOf<decltype(member)>::Owner>.*member)};

// What the value of a property stands for, beyond its type.
enum class Meaning {
    Plain,
    Name,  // what its thing is called; forms insist on one
    Color, // a text as #rrggbb
    Shown, // a switch: whether the view draws the thing
    Path,  // times and places, as collider_path.h reads them
    File,  // its name, beside the scene file
    Keys,  // a key sequence as Qt writes it
    Notes, // a text of many lines
    Polar, // rows of angles that rise from 0 to 90 degrees, lift and drag
    Times  // rows of times that rise, s, and what is then
};

// What a change of a property touches beside its number, and what its value is worth.
enum class Trait {
    Structure, // who is joined to whom and by what, or which states there are (of gusts, of the
               // air in a canopy): another value means a new system
    Looks,     // how things are drawn; what has DisplayOnly as its effect has this in any case
    Counts,    // how many things ask for what (usage.h)
    Solving,   // how a run is computed, which the automatic solver sees to
    Own,       // the thing's own, such as a name or a place: no default is worth going back to
    Noted      // by the program for itself: forms do not offer it
};
using Traits = SetOf<Trait>;

// The stretch of values that a slider covers. Fields take any value that the property allows. A
// vector is tuned by its length.
struct SliderRange
{
    double low = 0.0;
    double high = 1.0;
    bool logarithmic = false; // `low` is above 0; below 1, zero is at the left end

    friend bool operator==(const SliderRange&, const SliderRange&) = default;
};

struct Circumstances; // of a thing: usage.h

// A condition under which a value counts, and why it is idle where that does not hold.
struct Need
{
    std::optional<Kind> kind; // of the thing that is asked, or any
    bool (*holds)(const ConstRef& thing, const Circumstances& around);
    const char* otherwise; // half a sentence: "the particle is pinned"
};

// The conditions of one property, in the order in which they are asked. A property that always
// counts has none.
class NeedList
{
public:
    constexpr NeedList() = default;
    constexpr NeedList(std::initializer_list<Need> needs)
    {
        for (const Need& need : needs)
            m_needs[m_count++] = need;
    }
    constexpr const Need* begin() const { return m_needs.data(); }
    constexpr const Need* end() const { return m_needs.data() + m_count; }

private:
    std::array<Need, 5> m_needs{};
    std::size_t m_count = 0;
};

// What is said of a quantity where it is not the usual.
struct PropertyDetails
{
    Range range = {};
    Kinds pointsAt = {}; // for ids
    int columns = 0;     // numbers in each row, for tables
    Meaning meaning = Meaning::Plain;
    Traits traits = {};
    std::optional<SliderRange> usual = std::nullopt; // that a form shows without being asked
};

struct Property : PropertyDetails
{
    Kind kind;
    MemberPlace place;
    std::string_view key;   // name in files and paths; never renamed
    std::string_view label; // name on screen
    std::string_view unit;  // SI; empty when dimensionless
    Effect effect;
    std::string_view help; // one sentence
    NeedList needs;
    std::span<const std::string_view> choices; // for choices
    Value initial;                             // the default; its type is the type of the property
    bool optional;                             // may be absent
    Value (*get)(const ConstRef&);
    void (*set)(const Ref&, const Value&); // a value that refusal() has let through
};

std::span<const Property> allProperties();
std::span<const Property> propertiesOf(Kind kind);
const Property* findProperty(Kind kind, std::string_view key); // null when there is none
const Property* findProperty(Kind kind, Meaning meaning);      // the first of this meaning, or null
const Property& propertyAt(const MemberPlace& place);          // of a field that has a row

// The row of a field: propertyOf<&Particle::mass>().
template <auto member>
const Property& propertyOf()
{
    return propertyAt(memberPlace<member>);
}

// Whether the row is that of one of these fields.
template <auto... members>
bool isOneOf(const Property& property)
{
    return ((property.place == memberPlace<members>) || ...);
}

// The property of the material that a link takes where it has no value of its own; null for a
// property that the material does not have, or that is always the link's own.
const Property* ofMaterial(const Property& property);

bool isResettable(const Property& property); // has a default worth going back to
bool changesLooks(const Property& property); // of things in the view, or what tells of them

// Why the property cannot have this value, as half a sentence ("must be above 0"), or nothing.
// Dangling ids are found by check.h, which sees the whole scene.
std::optional<Message> refusal(const Property& property, const Value& value);

// Values as people type them: "0.5", "true", "verlet", "1, 0, -2", "17", or "0, 1; 2, 3" for a
// table of two rows. An empty text is the absence of an optional value.
Result<Value> valueFromText(const Property& property, std::string_view text);
std::string textFromValue(const Value& value);

// The candidate that is nearest to a misspelt word, or an empty view when none is near.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

} // namespace ripstop
