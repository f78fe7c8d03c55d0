// Values as bytes, and back. A struct says once what it is made of, and both directions follow:
//
//     template <typename A>
//     void visit(A& archive, Of<A, Split>& split)
//     {
//         auto& [from, twin, share] = split; // does not compile when a field is missing
//         archive(from, twin, share);
//     }
//
// The bytes are those of the machine. Who reads them has checked that they are whole; a length that
// cannot be is noticed all the same.
#pragma once

#include "base/vec3.h"

#include <array>
#include <cstdint>
#include <cstring>
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

class ByteWriter
{
public:
    static constexpr bool writes = true;

    explicit ByteWriter(std::string room = {}) // whose memory it uses
        : m_bytes(std::move(room))
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
        std::visit([this](const auto& held) { put(held); }, value);
    }
    template <typename T>
    void put(const T& value)
    {
        visit(*this, value);
    }

    std::string m_bytes;
};

class ByteReader
{
public:
    static constexpr bool writes = false;

    explicit ByteReader(std::string_view bytes)
        : m_left(bytes)
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
    // Nothing is made room for that the rest cannot hold.
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
            values.resize(length(1));
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
    template <typename T>
    void take(T& value)
    {
        visit(*this, value);
    }

    std::string_view m_left;
    bool m_ok = true;
};

// What `visit` of an archive gets: const when it writes.
template <typename Archive, typename T>
using Of = std::conditional_t<Archive::writes, const T, T>;

} // namespace ripstop
