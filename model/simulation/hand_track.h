// What hands have done in a run, in order. Frames share all of it but the end, so that an hour of
// pulling costs a frame no more than a second does.
#pragma once

#include "base/hands.h"

#include <cstddef>
#include <memory>
#include <variant>
#include <vector>

namespace ripstop {

struct HandNote
{
    struct LetGo // of what was pulled
    {
        friend bool operator==(const LetGo&, const LetGo&) = default;
    };
    struct Pin
    {
        std::uint32_t particle = 0; // key
        bool holds = true;          // or is pulled out again

        friend bool operator==(const Pin&, const Pin&) = default;
    };
    struct FanOff
    {
        friend bool operator==(const FanOff&, const FanOff&) = default;
    };
    struct Halt // of all motion
    {
        friend bool operator==(const Halt&, const Halt&) = default;
    };
    using What = std::variant<HandPull, LetGo, Pin, Carry, Airflow, FanOff,
                              std::shared_ptr<const Cut>, Halt>;

    double time = 0.0; // s, of the step boundary
    What what;
};

// What is to be told so that this happens, after `commands`.
void add(const HandNote::What& what, HandCommands& commands);

class HandTrack
{
public:
    void append(HandNote note);
    void clear();

    bool empty() const { return m_sealed.empty() && m_end.empty(); }
    std::size_t size() const { return m_sealed.size() * block + m_end.size(); }
    std::vector<HandNote> notes() const;

private:
    static constexpr std::size_t block = 256;
    using Block = std::vector<HandNote>;

    std::vector<std::shared_ptr<const Block>> m_sealed; // of `block` notes each
    Block m_end;
};

} // namespace ripstop
