// Smooths the shape that particles lie in.
//
// Each pass moves a particle by a share of the way to the middle of its neighbours,
//
//     x' = x + f (mean of neighbours - x),
//
// all at once. Laplacian smoothing takes f = factor, and shrinks what it smooths. Taubin's (1995)
// lets a second pass follow with f = 1 / (0.1 - 1 / factor), below 0, which gives the size back:
// waves longer than some twenty particles stay as they are.
//
// Neighbours are those along the edges of panels; of a particle without panels, those that links
// lead to. Particles that are not selected stay, and are neighbours all the same.
#pragma once

#include "shaping/transform.h"

namespace ripstop {

enum class Smoothing { Laplacian, Taubin };

// Of fabric, edges with one panel; of lines, ends with one neighbour.
enum class Border {
    Kept, // stays where it is
    Along // is smoothed along itself; ends stay
};

struct SmoothHow
{
    Smoothing smoothing = Smoothing::Taubin;
    double factor = 0.5; // 1, from 0 to 1
    int iterations = 10;
    Border border = Border::Kept;
};

// Sets positions and, when asked, binds the rest lengths of all links at what moves. Empty when
// nothing is selected that has neighbours.
Edit smoothed(const Scene& scene, const std::vector<Id>& ids, const SmoothHow& how,
              RestLengths restLengths);

} // namespace ripstop
