// What a person does to a running simulation by hand, besides moving its controls: pull, pin, carry
// colliders, blow. Hands say what is held now, and not what has happened, so that a value may be
// skipped. Particles and colliders go by their keys, which outlive edits. All of it is plain
// values: the window fills them, a mailbox takes them to the thread that steps, and State keeps
// them.
#pragma once

#include "base/airflow.h"
#include "base/vec3.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace ripstop {

// A point of the fabric: a particle, or a place in a panel.
struct Grip
{
    std::array<std::uint32_t, 3> particle{}; // keys; those without a share do not count
    Vec3 share = Vec3::UnitX();              // 1, of each of them, 1 in sum

    friend bool operator==(const Grip&, const Grip&) = default;
};

// A damped spring between a grip and a place in the air; see forces/hand_pull.h.
struct HandPull
{
    Grip grip;
    Vec3 to = Vec3::Zero();  // m
    double stiffness = 50.0; // N/m
    double damping = 1.0;    // 1, of the critical damping of the mass in the grip
    double most = 20.0;      // N

    friend bool operator==(const HandPull&, const HandPull&) = default;
};

// A collider that a hand takes elsewhere.
struct Carry
{
    std::uint32_t collider = 0; // key
    Vec3 way = Vec3::Zero();    // m, from where it would be without

    friend bool operator==(const Carry&, const Carry&) = default;
};

struct Hands
{
    std::optional<HandPull> pull;
    std::optional<Airflow> fan;      // a jet
    std::vector<std::uint32_t> pins; // particles held where they were when they were pinned
    std::vector<Carry> carries;      // what was carried once stays where it was put

    friend bool operator==(const Hands&, const Hands&) = default;
};

// A stroke of the knife: each of its points cuts from `near` to `far`, and so does all between one
// point and the next.
struct Cut
{
    struct Edge
    {
        Vec3 near; // m
        Vec3 far;

        friend bool operator==(const Edge&, const Edge&) = default;
    };
    std::vector<Edge> edges;

    friend bool operator==(const Cut&, const Cut&) = default;
};

// All that hands were told to do since the run began. What can be done again is counted, so that a
// mailbox may skip values.
struct HandCommands
{
    Hands hands;
    std::vector<std::shared_ptr<const Cut>> cuts;
    int halts = 0; // times that all motion was stopped

    friend bool operator==(const HandCommands&, const HandCommands&) = default;
};

} // namespace ripstop
