// A brush that paints numbers on fabric: how strong and how stiff it is of its material, and where
// its warp runs.
//
// It paints what carries the pull: panels, in parts of which panels carry it, and in other parts
// the links that lie among panels, or all links where there are none. The grain is that of the
// former panels only. Links and panels are touched where their middles are, in the scene.
//
// Over one stroke a place has the weight of where the brush came nearest, so that painting it twice
// gives no more than once, and how fast the hand goes does not matter. A number goes by its weight
// from what it was to that of the brush; a warp turns the shorter way. On the other side of a
// mirror it is turned the other way, so that halves stay mirror images of each other.
#pragma once

#include "scene/edit.h"

#include <array>
#include <limits>

namespace ripstop {

enum class Painted { Strength, Stiffness, Grain };
inline constexpr std::size_t paintedCount = 3;

enum class Falloff { Smooth, Hard };

struct Brush
{
    Painted what = Painted::Strength;

    // By what is painted: factors, and degrees that the warp is turned from the way in which the
    // picture printed on the fabric goes up (derived/flat_panel.h).
    std::array<double, paintedCount> values{0.5, 2.0, 0.0};

    double radius = 0.1; // m
    Falloff falloff = Falloff::Smooth;
    bool mirrors = false; // at the plane of each part (mirror_plane.h)

    static constexpr double narrowest = 1e-4, widest = 1e3; // m, radius

    void widen(double factor); // to three digits, so that a person can read the radius

    double value() const { return values[std::size_t(what)]; }

    // 1 at the middle, 0 from the radius on; m from the middle.
    double weightAt(double distance) const;
};

// A radius for fabric of this size, m, in a round number.
double fittingRadius(const Scene& scene);

// The property of links or of panels that is painted; null for the grain of links.
const Property* paintedProperty(Painted what, Kind kind);
bool isPaint(const Property& property); // whether it is one of these

class BrushStroke
{
public:
    BrushStroke(const Scene& scene, const Brush& brush);

    // Whether there is nothing that could be painted, wherever the brush goes.
    bool hasNothing() const { return m_spots.empty(); }

    // Paints along the way from one place to another, m. Returns whether that changes something.
    bool paint(const Vec3& from, const Vec3& to);

    std::size_t count() const; // elements that it has touched

    // From the scene as it was to what has been painted so far.
    Edit edit() const;

private:
    struct Spot
    {
        Vec3 place; // m
        Vec3 image; // m, on the other side
        Id id;
        Kind kind;
        double from;    // the number before
        double upright; // degrees, the grain that a brush of 0 paints
        double nearest = std::numeric_limits<double>::infinity(); // m, that the brush came
        bool isImage = false;                                     // that of the other side
    };

    void add(const Scene& scene, const Part& part);
    double weightOf(const Spot& spot) const { return m_brush.weightAt(spot.nearest); }
    double valueOf(const Spot& spot) const;

    Brush m_brush;
    std::vector<Spot> m_spots;
};

} // namespace ripstop
