// Up to which frequency a substep tells swings as they are, whatever the pulls are true to: a step
// may find every pull right, and still be too long for the hum of a line.
//
// A motion x'' = -w^2 x, w in rad/s, comes out with another frequency and a damping that it has
// not. By what the methods make of it (Hairer and Wanner, Solving Ordinary Differential Equations
// II, 1996, sections V.1 and IV.3), h being the substep:
//
//     backward and forward Euler   height lost in a swing     pi w h, forward with the other sign
//     BDF2                         frequency lower by         (w h)^2 / 3
//     symplectic Euler, Verlet     frequency higher by        (w h)^2 / 24
//     Runge and Kutta's            height lost in a swing     2 pi (w h)^5 / 144
//
// What else they do is less: BDF2 takes pi (w h)^3 / 2 of the height, Runge and Kutta's method
// changes the frequency by (w h)^4 / 120.
#pragma once

#include "laws/solver_laws.h"

namespace ripstop {

// Hz: slower swings have their frequency right within 1 %, and keep their height within 1 % from
// one to the next. Where links or panels are `held`, by sweeps or together with others, only BDF2
// is better than backward Euler for what they do. Auto is none of them.
double fastestTrueSwing(Integrator integrator, bool held, double substep);

} // namespace ripstop
