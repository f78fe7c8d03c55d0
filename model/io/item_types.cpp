#include "io/item_types.h"

#include <array>
#include <utility>

namespace ripstop {
namespace {

// The item variant lists its types in the order of Kind.
constexpr int firstItem = int(Kind::Part);
static_assert(std::variant_size_v<Item> == kindCount - firstItem);

template <std::size_t... index>
Item itemOf(std::size_t wanted, std::index_sequence<index...>)
{
    Item item;
    ((wanted == index ? void(item.emplace<index>()) : void()), ...);
    return item;
}

} // namespace

std::span<const std::string_view> itemTypes()
{
    static const auto names = [] {
        std::array<std::string_view, kindCount - firstItem> all;
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = kindName(Kind(firstItem + int(i)));
        return all;
    }();
    return names;
}

std::string itemTypeList()
{
    std::string list;
    for (const std::string_view name : itemTypes())
        list += (list.empty() ? "" : ", ") + std::string(name);
    return list;
}

std::optional<Kind> itemKind(std::string_view type)
{
    const std::optional<Kind> kind = kindFromName(type);
    return kind && int(*kind) >= firstItem ? kind : std::nullopt;
}

Item itemOf(Kind kind)
{
    return itemOf(std::size_t(int(kind) - firstItem),
                  std::make_index_sequence<std::variant_size_v<Item>>());
}

} // namespace ripstop
