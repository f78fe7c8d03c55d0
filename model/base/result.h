// What functions return that may fail: a value, or the reason why there is none.
//
// Loading, compiling and exporting fail with a Failure and throw nothing out of a source file; a
// step cannot fail and returns no Result. A Failure has one sentence for people and no code to
// switch on: whoever calls shows the sentence or puts it into one of its own. [[nodiscard]] makes
// the compiler complain where a Result is dropped.
#pragma once

#include "base/message.h"

#include <cassert>
#include <optional>
#include <utility>

namespace ripstop {

// Why something could not be done: one sentence that names the place and says what to do.
struct Failure
{
    Failure() = default;
    Failure(Message why)
        : message(std::move(why))
    {}
    template <std::size_t size, typename... Parts>
    explicit Failure(const char (&english)[size], Parts&&... parts)
        : message(english, std::forward<Parts>(parts)...)
    {}
    template <std::size_t size, typename... Parts>
    explicit Failure(char (&composed)[size], Parts&&... parts) = delete; // it is no literal

    Message message;
};

// A value, or the reason why there is none. (g++ 12 has no std::expected.)
template <typename T>
class [[nodiscard]] Result
{
public:
    Result(T value)
        : m_value(std::move(value))
    {}
    Result(Failure failure)
        : m_failure(std::move(failure))
    {}

    explicit operator bool() const { return m_value.has_value(); }

    T& operator*() { return *m_value; }
    const T& operator*() const { return *m_value; }
    T* operator->() { return &*m_value; }
    const T* operator->() const { return &*m_value; }

    // Why there is no value; it is a mistake to ask while there is one.
    const Failure& failure() const
    {
        assert(!m_value);
        return m_failure;
    }
    const Message& message() const { return failure().message; }

private:
    std::optional<T> m_value;
    Failure m_failure;
};

} // namespace ripstop
