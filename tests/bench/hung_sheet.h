// A sheet whose answer is known, for programs beside each other to hang.
//
// Kite cloth, 1 m x 1 m, E t 40 kN/m, 47 g/m^2, n x n cells of threads, hangs by its upper edge
// with 10 kg along the lower one. It is let go without load. Theory has
//   at rest  the lower edge (M + m / 2) g L / (E t W) lower, 0.25 %, and in each thread the weight
//            of what hangs below it;
//   before   the swing of a mass on a spring, of which a third of the sheet is part (Rayleigh),
//            of 63 rad/s, damped by viscosity alone.
#pragma once

#include "scene/scene.h"
#include "system/system.h"

#include <functional>

namespace ripstop {

struct HungSheet
{
    int cells;
    double dampingTime; // s, of the cloth; what the presets of fabrics have is below

    Scene scene() const;               // with what a new scene has, but steps of 10 ms
    double dropAt(double time) const;  // 1, over the drop at rest; s
    double pullOf(int particle) const; // N, at rest, of the thread down from there

    // How an instant differs from rest, 1.
    struct Instant
    {
        double drop = 0.0; // of the lower edge, over the drop at rest
        double pull = 0.0; // RMS of the errors of threads that hang, each over its own pull
        double worstPull = 0.0;
    };

    //   height   m, of a particle of the system
    //   tension  N, of a link of the system
    Instant instant(const System& system, const std::function<double(int)>& height,
                    const std::function<double(std::size_t)>& tension) const;

    // The width that a row or column stands for, m.
    double share(int k) const { return (k == 0 || k == cells ? 0.5 : 1.0) / cells; }
};

inline constexpr double clothDamping = 473.0 / 614600.0; // s, of resources/materials.json

} // namespace ripstop
