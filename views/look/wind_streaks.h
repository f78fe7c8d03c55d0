// Where short streaks drift that show the wind.
//
// Space is a grid of cells that stands in the world; its step is a round number of metres, in
// keeping with the view. From each cell one streak after another sets out, lives for the time in
// which the mean wind of its middle blows through a cell and a half, and is brightest halfway,
// where it passes near that middle. Its head at age a is where the mean wind of each place on its
// way (profiles, jets) has brought the air of its start, so that heads follow from the time alone:
// a run that is held has streaks that stand, and none jumps as gusts come and go or the playhead
// moves. Its tail trails behind the head in the wind of the moment, which gusts turn and lengthen.
#pragma once

#include "base/airflow.h"

#include <array>
#include <span>
#include <vector>

namespace ripstop {

struct WindStreak
{
    static constexpr int points = 6;

    std::array<Vec3, points> path; // m, from the tail to the head
    double opacity;                // 0 .. 1, of the head
};

// What is seen of the wind.
struct StreakView
{
    Vec3 middle; // m
    double size; // m, from the bottom to the top of the picture there
};

// None below y = 0 and none where the air is calm.
//     gust  m/s, of the moment, the same everywhere
//     time  s, of the frame
std::vector<WindStreak> windStreaks(std::span<const Airflow> winds, const Vec3& gust, double time,
                                    const StreakView& view);

} // namespace ripstop
