// Values as bytes, and back. A struct becomes the bytes of its fields, in the order of its list
// (fields.h); nothing else says what it is made of, in either direction.
//
// Bytes of a version have the fields that there were then (Since); a field that came later is
// neither written nor read, and keeps the value that it begins with.
//
// The bytes are those of the machine. Whoever reads them has checked that they are whole; a length
// that cannot be is noticed all the same: ok() turns false and stays so. A byte that is there asks
// for no more than `mostMemory` bytes of memory.
#pragma once

#include "base/fields.h"
#include "base/vec3.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace ripstop {

template <typename T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

inline constexpr int newestVersion = std::numeric_limits<int>::max();

// The fewest bytes that a value of a type is written as. It bounds how many values some bytes can
// hold, before memory is asked for.
template <typename T>
struct FewestBytes
{
    static constexpr std::size_t count()
    {
        if constexpr (Plain<T>) {
            return std::is_same_v<T, bool> ? 1 : sizeof(T);
        } else if constexpr (HasFields<T>) {
            std::size_t sum = 0;
            forEachField<T>([&](auto field) {
                using Value = std::remove_cvref_t<decltype(field.of(std::declval<T&>()))>;
                if (field.mark(Since{1}).version == 1)
                    sum += FewestBytes<Value>::count();
            });
            return sum;
        } else {
            return sizeof(Vec3); // or PaddedVec3
        }
    }
};
template <>
struct FewestBytes<std::string>
{
    static constexpr std::size_t count() { return sizeof(std::uint64_t); }
};
template <typename T>
struct FewestBytes<std::vector<T>> : FewestBytes<std::string>
{};
template <typename T, std::size_t n>
struct FewestBytes<std::array<T, n>>
{
    static constexpr std::size_t count() { return n * FewestBytes<T>::count(); }
};
template <typename T>
struct FewestBytes<std::optional<T>> : FewestBytes<bool>
{};
template <typename T>
struct FewestBytes<std::shared_ptr<const T>> : FewestBytes<T>
{};
template <typename... T>
struct FewestBytes<std::variant<T...>>
{
    static constexpr std::size_t count() { return 1 + std::min({FewestBytes<T>::count()...}); }
};

class ByteWriter
{
public:
    explicit ByteWriter(std::string room = {}, // whose memory it uses
                        int version = newestVersion)
        : m_bytes(std::move(room))
        , m_version(version)
    {
        m_bytes.clear();
    }

    template <typename... T>
    void operator()(const T&... values)
    {
        (put(values), ...);
    }
    std::string take() { return std::move(m_bytes); }

private:
    void raw(const void* data, std::size_t size)
    {
        m_bytes.append(static_cast<const char*>(data), size);
    }
    template <Plain T>
    void put(const T& value)
    {
        raw(&value, sizeof value);
    }
    void put(const Vec3& value) { raw(value.data(), sizeof(Vec3)); }
    void put(const PaddedVec3& value) { put(static_cast<const Vec3&>(value)); }
    void put(const std::string& text)
    {
        put(std::uint64_t(text.size()));
        raw(text.data(), text.size());
    }
    template <typename T>
    void put(const std::vector<T>& values)
    {
        put(std::uint64_t(values.size()));
        if constexpr (Plain<T>)
            raw(values.data(), values.size() * sizeof(T));
        else
            for (const T& value : values)
                put(value);
    }
    template <typename T, std::size_t n>
    void put(const std::array<T, n>& values)
    {
        for (const T& value : values)
            put(value);
    }
    template <typename T>
    void put(const std::optional<T>& value)
    {
        put(value.has_value());
        if (value)
            put(*value);
    }
    template <typename T>
    void put(const std::shared_ptr<const T>& value)
    {
        put(*value);
    }
    template <typename... T>
    void put(const std::variant<T...>& value)
    {
        put(std::uint8_t(value.index()));
        std::visit([this](const auto& held) { this->put(held); }, value);
    }
    template <HasFields T>
    void put([[maybe_unused]] const T& value)
    {
        forEachField<T>([&](auto field) {
            if (field.mark(Since{1}).version <= m_version)
                put(field.of(value));
        });
    }

    std::string m_bytes;
    int m_version;
};

class ByteReader
{
public:
    static constexpr std::size_t mostMemory = 16;

    explicit ByteReader(std::string_view bytes, int version = newestVersion)
        : m_left(bytes)
        , m_version(version)
    {}

    template <typename... T>
    void operator()(T&... values)
    {
        (take(values), ...);
    }
    bool ok() const { return m_ok; }
    bool atEnd() const { return m_left.empty(); }

private:
    void raw(void* data, std::size_t size)
    {
        m_ok = m_ok && size <= m_left.size();
        if (!m_ok || size == 0)
            return;
        std::memcpy(data, m_left.data(), size);
        m_left.remove_prefix(size);
    }
    // A damaged length must not ask for memory that the rest of the bytes cannot fill.
    std::size_t length(std::size_t bytesEach)
    {
        std::uint64_t count = 0;
        take(count);
        m_ok = m_ok && count <= m_left.size() / bytesEach;
        return m_ok ? std::size_t(count) : 0;
    }
    template <Plain T>
    void take(T& value)
    {
        raw(&value, sizeof value);
    }
    void take(bool& value)
    {
        std::uint8_t byte = 0;
        take(byte);
        value = byte != 0;
    }
    void take(Vec3& value) { raw(value.data(), sizeof(Vec3)); }
    void take(PaddedVec3& value) { take(static_cast<Vec3&>(value)); }
    void take(std::string& text)
    {
        text.resize(length(1));
        raw(text.data(), text.size());
    }
    template <typename T>
    void take(std::vector<T>& values)
    {
        if constexpr (Plain<T>) {
            values.resize(length(sizeof(T)));
            raw(values.data(), values.size() * sizeof(T));
        } else {
            static_assert(sizeof(T) <= mostMemory * FewestBytes<T>::count());
            values.resize(length(FewestBytes<T>::count()));
            for (T& value : values)
                take(value);
        }
    }
    template <typename T, std::size_t n>
    void take(std::array<T, n>& values)
    {
        for (T& value : values)
            take(value);
    }
    template <typename T>
    void take(std::optional<T>& value)
    {
        bool there = false;
        take(there);
        value.reset();
        if (there && m_ok)
            take(value.emplace());
    }
    template <typename T>
    void take(std::shared_ptr<const T>& value)
    {
        auto made = std::make_shared<T>();
        take(*made);
        value = std::move(made);
    }
    template <std::size_t i = 0, typename... T>
    void takeOne(std::uint8_t index, std::variant<T...>& value)
    {
        if constexpr (i == sizeof...(T))
            m_ok = false;
        else if (index == i)
            take(value.template emplace<i>());
        else
            takeOne<i + 1>(index, value);
    }
    template <typename... T>
    void take(std::variant<T...>& value)
    {
        std::uint8_t index = 0;
        take(index);
        takeOne(index, value);
    }
    template <HasFields T>
    void take([[maybe_unused]] T& value)
    {
        forEachField<T>([&](auto field) {
            if (field.mark(Since{1}).version <= m_version)
                take(field.of(value));
        });
    }

    std::string_view m_left;
    int m_version;
    bool m_ok = true;
};

} // namespace ripstop
