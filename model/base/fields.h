// What a struct is made of, said once. All that walks over fields follows from that one list:
// equality, clearing, bytes (bytes.h), hashes, and what a test says differs.
//
//     template <>
//     inline constexpr auto fieldsOf<TearHold> =
//         fields<TearHold, &TearHold::link, &TearHold::ratio>;
//
// A list with a field too few, or one that names a field twice, does not compile. The order is that
// of the declarations, which is the order in which fields become bytes.
//
// What is special about a field stands beside it as marks, which are values of any small type:
//
//     field<&State::step, Hash::In>
//
// Whoever walks asks for the marks that concern it and says what a field without one has. Names
// come from the compiler and are for people.
#pragma once

#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

namespace ripstop {

// Whether two values of a struct are equal only when they are so in this field.
enum class Compared { Yes, No };

// The first version of some bytes, mostly of a file, that has the field.
struct Since
{
    int version = 1;
};

// The compiler tells what `member` is: "... [with auto member = &State::time; ..." or "...]".
template <auto member>
constexpr std::string_view memberName()
{
    std::string_view name = __PRETTY_FUNCTION__;
    name = name.substr(name.rfind("member = &"));
    name = name.substr(0, name.find_first_of(";,]"));
    return name.substr(name.rfind(':') + 1);
}

template <auto member, auto... marks>
struct StructField
{
    static constexpr auto pointer = member;

    static constexpr std::string_view name() { return memberName<member>(); }

    template <typename Struct>
    static constexpr auto& of(Struct& record)
    {
        return record.*member;
    }

    // The mark of this kind, or `otherwise` where the field has none.
    template <typename Mark>
    static constexpr Mark mark(Mark otherwise)
    {
        [[maybe_unused]] const auto take = [&](auto one) {
            if constexpr (std::is_same_v<decltype(one), Mark>)
                otherwise = one;
        };
        (take(marks), ...);
        return otherwise;
    }
};

template <auto member, auto... marks>
inline constexpr StructField<member, marks...> field;

template <auto member>
struct AsField
{
    using Type = StructField<member>;
};
template <auto field>
requires(!std::is_member_object_pointer_v<decltype(field)>) struct AsField<field>
{
    using Type = std::remove_const_t<decltype(field)>;
};

template <typename Struct, typename Listed>
using TypeIn = std::remove_reference_t<decltype(Listed::of(std::declval<Struct&>()))>;

template <typename Struct, typename... Fields>
concept BeginsWith = requires
{
    Struct{std::declval<TypeIn<Struct, Fields>>()...};
};

// An empty brace begins whatever comes after the last field of the list.
template <typename Struct, typename... Fields>
concept GoesOnAfter = requires
{
    Struct{std::declval<TypeIn<Struct, Fields>>()..., {}};
};

template <auto pointer>
struct Once
{};
template <typename... Fields>
struct EachOnce : Once<Fields::pointer>... // does not compile when a field is named twice
{};

// Whether these are all fields of the struct.
template <typename Struct, typename... Fields>
inline constexpr bool areAllFields =
    BeginsWith<Struct, Fields...> && !GoesOnAfter<Struct, Fields...>;

template <typename Struct, typename... Each>
struct FieldList
{
    static_assert(areAllFields<Struct, Each...>,
                  "this list names all fields of the struct, in the order of their declarations");
    static_assert(sizeof(EachOnce<Each...>) > 0);

    template <typename Visit>
    static constexpr void forEach([[maybe_unused]] Visit&& visit)
    {
        (visit(Each()), ...);
    }
};

// A list is made of pointers to members, and of fields with marks.
template <typename Struct, auto... members>
inline constexpr FieldList<Struct, typename AsField<members>::Type...> fields;

// The list of a struct, which a specialization beside the struct says; null for one without a list.
template <typename Struct>
inline constexpr auto fieldsOf = nullptr;

template <typename Struct>
concept HasFields = !std::is_same_v<std::remove_cv_t<decltype(fieldsOf<Struct>)>, std::nullptr_t>;

// Calls visit(field) for each field of the struct: field.of(record) is the value in a record.
template <HasFields Struct, typename Visit>
constexpr void forEachField(Visit&& visit)
{
    fieldsOf<Struct>.forEach(visit);
}

// Name of the first field that is compared and differs; empty when the two are equal.
template <HasFields Struct>
std::string_view differingField(const Struct& a, const Struct& b)
{
    std::string_view found;
    forEachField<Struct>([&](auto field) {
        if constexpr (field.mark(Compared::Yes) == Compared::Yes)
            if (found.empty() && !(field.of(a) == field.of(b)))
                found = field.name();
    });
    return found;
}

} // namespace ripstop
