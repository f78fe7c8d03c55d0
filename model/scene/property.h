// The authored quantities of a scene, as data.
//
// One row describes one quantity completely. The file format, the inspector, the check of what a
// user typed, the command line's --set and the property manual all walk this table: a new
// quantity is a field in items.h, a row here and its use.
#pragma once

#include "base/result.h"
#include "scene/scene.h"

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

inline Kind kindOf(const ConstRef& ref) { return Kind(ref.index()); }
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

// The kinds that an id may point at, as a set.
class Kinds
{
public:
    constexpr Kinds() = default;
    constexpr Kinds(std::initializer_list<Kind> kinds)
    {
        for (const Kind kind : kinds)
            m_bits |= 1u << unsigned(kind);
    }
    constexpr bool contains(Kind kind) const { return (m_bits >> unsigned(kind)) & 1u; }
    constexpr bool empty() const { return m_bits == 0; }

private:
    unsigned m_bits = 0;
};

struct Property
{
    Kind kind;
    std::string_view key;   // name in files and paths; never renamed
    std::string_view label; // name on screen
    std::string_view unit;  // SI; empty when dimensionless
    Effect effect;
    std::string_view help; // one sentence
    Range range;
    Kinds pointsAt;                            // for ids
    std::span<const std::string_view> choices; // for choices
    Value initial;                             // the default; its type is the type of the property
    bool optional;                             // may be absent
    int columns;                               // numbers in each row, for tables
    Value (*get)(const ConstRef&);
    void (*set)(const Ref&, const Value&); // a value that refusal() has let through
};

std::span<const Property> allProperties();
std::span<const Property> propertiesOf(Kind kind);
const Property* findProperty(Kind kind, std::string_view key); // null when there is none

// Why the property cannot have this value, as half a sentence ("must be above 0"), or nothing.
// Dangling ids are found by check.h, which sees the whole scene.
std::optional<Message> refusal(const Property& property, const Value& value);

// Values as people type them: "0.5", "true", "verlet", "1, 0, -2", "17", "0, 1; 2, 3" for a
// table of two rows. An empty text is the
// absence of an optional value.
Result<Value> valueFromText(const Property& property, std::string_view text);
std::string textFromValue(const Value& value);

// The candidate that is nearest to a misspelt word, or an empty view when none is near.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

} // namespace ripstop
