#include "simulation/hand_track.h"

#include <algorithm>
#include <utility>

namespace ripstop {
namespace {

struct Teller
{
    HandCommands& commands;

    void operator()(const HandPull& pull) const { commands.hands.pull = pull; }
    void operator()(HandNote::LetGo) const { commands.hands.pull.reset(); }
    void operator()(const HandNote::Pin& pin) const
    {
        std::erase(commands.hands.pins, pin.particle);
        if (pin.holds)
            commands.hands.pins.push_back(pin.particle);
    }
    void operator()(const Carry& carry) const
    {
        auto& carries = commands.hands.carries;
        const auto found = std::find_if(carries.begin(), carries.end(), [&](const Carry& other) {
            return other.collider == carry.collider;
        });
        if (found == carries.end())
            carries.push_back(carry);
        else
            *found = carry;
    }
    void operator()(const Airflow& fan) const { commands.hands.fan = fan; }
    void operator()(HandNote::FanOff) const { commands.hands.fan.reset(); }
    void operator()(const std::shared_ptr<const Cut>& cut) const { commands.cuts.push_back(cut); }
    void operator()(HandNote::Halt) const { ++commands.halts; }
};

} // namespace

void add(const HandNote::What& what, HandCommands& commands) { std::visit(Teller{commands}, what); }

void HandTrack::append(HandNote note)
{
    m_end.push_back(std::move(note));
    if (m_end.size() == block)
        m_sealed.push_back(std::make_shared<const Block>(std::exchange(m_end, {})));
}

void HandTrack::clear()
{
    m_sealed.clear();
    m_end.clear();
}

std::vector<HandNote> HandTrack::notes() const
{
    std::vector<HandNote> all;
    all.reserve(size());
    for (const auto& sealed : m_sealed)
        all.insert(all.end(), sealed->begin(), sealed->end());
    all.insert(all.end(), m_end.begin(), m_end.end());
    return all;
}

} // namespace ripstop
