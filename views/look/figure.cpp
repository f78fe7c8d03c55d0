// A Body has the frame of a person (its up, the way that it faces) and adds limbs: trunk and head,
// arms and legs of two segments each, whose joint lies to a side that is given. The poses place its
// shoulders and hips and say where hands and feet are.
#include "look/figure.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

constexpr double tall = personHeight;
constexpr double shoulders = 0.818 * tall; // m over the ground, as the next
constexpr double hips = 0.530 * tall;
constexpr double chin = 0.870 * tall;
constexpr double halfShoulders = 0.105 * tall; // m, to the joints
constexpr double halfHips = 0.052 * tall;
constexpr double upperArm = 0.186 * tall;
constexpr double forearm = 0.200 * tall; // and half a hand
constexpr double thigh = (0.530 - 0.285) * tall;
constexpr double shin = (0.285 - 0.039) * tall;
constexpr double ankle = 0.039 * tall;                // m over the ground
constexpr double reach = 0.90 * (upperArm + forearm); // with an elbow that is not stretched
constexpr double headRadius = 0.088;                  // m
constexpr double lowestHips = 0.25;                   // m
constexpr double halfBar = 0.65;                      // m, to each side of the pilot
constexpr double tubeRadius = 0.015;                  // m, of the control frame
constexpr double strapRadius = 0.010;                 // m, that the pilot hangs by
constexpr double harnessRadius = 0.135;               // m, round the hips
constexpr double riser = 0.30; // m, from where lines meet to the shoulders of who hangs there

// Where the joint of two segments is, bent towards `pole`; on the way when it is too far.
Vec3 jointOf(const Vec3& from, const Vec3& to, double upper, double lower, const Vec3& pole)
{
    const Vec3 way = to - from;
    const double length = std::max(way.norm(), 1e-6);
    const Vec3 along = way / length;
    const double near = (length * length + upper * upper - lower * lower) / (2.0 * length);
    const double aside = std::sqrt(std::max(0.0, upper * upper - near * near));
    const Vec3 side = pole - pole.dot(along) * along;
    const double bent = side.norm();
    return from + std::clamp(near, 0.0, upper) * along + (bent > 1e-9 ? aside / bent : 0.0) * side;
}

struct Body
{
    Vec3 up, ahead, right;
    std::vector<Limb> limbs;

    Body(const Vec3& upwards, const Vec3& facing)
        : up(upwards.normalized())
    {
        Vec3 level = facing - facing.dot(up) * up;
        if (level.norm() < 1e-6)
            level = up.unitOrthogonal();
        ahead = level.normalized();
        right = ahead.cross(up);
    }

    void add(const Vec3& from, const Vec3& to, double fromRadius, double toRadius)
    {
        limbs.push_back({from, to, fromRadius, toRadius});
    }
    // Between the middles of shoulders and hips, and the head on its neck.
    void addTrunk(const Vec3& chest, const Vec3& pelvis, const Vec3& headwards)
    {
        add(pelvis, chest - 0.12 * (chest - pelvis), 0.120, 0.150);
        add(chest - halfShoulders * right, chest + halfShoulders * right, 0.058, 0.058);
        add(pelvis - halfHips * right, pelvis + halfHips * right, 0.095, 0.095);
        const Vec3 neck = headwards.normalized();
        const Vec3 crown = chest + (tall - shoulders) * neck;
        add(chest, chest + (chin - shoulders) * neck, 0.055, 0.050);
        add(chest + (chin - shoulders + 0.055) * neck, crown - headRadius * neck, 0.070,
            headRadius);
    }
    void addArm(const Vec3& shoulder, const Vec3& hand, const Vec3& elbowwards)
    {
        const Vec3 elbow = jointOf(shoulder, hand, upperArm, forearm, elbowwards);
        add(shoulder, elbow, 0.050, 0.041);
        add(elbow, hand, 0.041, 0.032);
        add(hand, hand, 0.042, 0.042);
    }
    void addLeg(const Vec3& hip, const Vec3& heel, const Vec3& kneewards, const Vec3& toewards)
    {
        const Vec3 knee = jointOf(hip, heel, thigh, shin, kneewards);
        add(hip, knee, 0.082, 0.056);
        add(knee, heel, 0.056, 0.042);
        add(heel - 0.02 * up, heel + 0.16 * toewards - 0.032 * up, 0.044, 0.034);
    }
};

bool isPlace(const Frame& frame, const std::vector<int>& particles)
{
    return std::ranges::all_of(particles, [&](int particle) {
        return std::size_t(particle) < frame.position.size()
               && frame.position[std::size_t(particle)].allFinite();
    });
}

Vec3 meanOf(const Frame& frame, const std::vector<int>& particles)
{
    Vec3 sum = Vec3::Zero();
    for (const int particle : particles)
        sum += frame.position[std::size_t(particle)];
    return sum / double(std::max<std::size_t>(particles.size(), 1));
}

// Someone whose right hand is where `hold` is, and the left one where `other` is.
std::vector<Limb> standing(const Vec3& shoulder, double ground, const Vec3& ahead, const Vec3& hold,
                           const Vec3& other)
{
    Body body(Vec3::UnitY(), ahead);
    const double sunk = ground + shoulders - shoulder.y(); // how far the knees let them down
    const Vec3 feet(shoulder.x(), ground, shoulder.z());
    const Vec3 pelvis = feet + std::max(hips - sunk, lowestHips) * body.up + 0.03 * body.ahead;
    body.addTrunk(shoulder, pelvis, body.up);
    for (const double side : {1.0, -1.0}) {
        const Vec3 foot =
            feet + ankle * body.up + side * 0.10 * body.right + side * 0.14 * body.ahead;
        body.addLeg(pelvis + side * halfHips * body.right, foot, body.ahead, body.ahead);
        const Vec3 joint = shoulder + side * halfShoulders * body.right;
        body.addArm(joint, side > 0.0 ? hold : other,
                    side * 0.5 * body.right - body.up - 0.3 * body.ahead);
    }
    return body.limbs;
}

std::vector<Limb> holding(const Person& person, const Frame& frame,
                          const std::vector<ColliderBody>& colliders)
{
    const Vec3 hold = meanOf(frame, person.holds);
    const Vec3 line = meanOf(frame, person.towards) - hold;
    const Vec3 level(line.x(), 0.0, line.z());
    const Vec3 ahead = level.norm() > 1e-3 * line.norm() ? Vec3(level.normalized()) : Vec3::UnitX();

    double ground = groundBelow(colliders, frame, hold);
    if (!std::isfinite(ground))
        ground = hold.y() - 0.7 * tall;
    const double above = hold.y() - ground;
    if (above < -0.1 || above > shoulders + upperArm + forearm)
        return {};
    // shoulders as high as they are, or as low as the arm asks
    const double height = std::min(shoulders, above + reach);
    const double rise = std::clamp(above - height, -reach, upperArm + forearm);
    const double behind = std::sqrt(std::max(reach * reach - rise * rise, 0.15 * 0.15));
    const Vec3 right = ahead.cross(Vec3::UnitY());
    // the shoulder behind the hand is the right one, unless there are two hands to be filled
    const bool two = person.holds.size() > 1;
    const Vec3 shoulder =
        Vec3(hold.x(), ground + height, hold.z()) - behind * ahead - (two ? 0.0 : 0.09) * right;
    if (!two) {
        const Vec3 other = hold - 0.10 * ahead - 0.06 * right - Vec3(0.0, 0.10, 0.0);
        return standing(shoulder, ground, ahead, hold, other);
    }
    Vec3 rightHand = frame.position[std::size_t(person.holds[0])];
    Vec3 leftHand = frame.position[std::size_t(person.holds[1])];
    if (rightHand.dot(right) < leftHand.dot(right))
        std::swap(rightHand, leftHand);
    return standing(shoulder, ground, ahead, rightHand, leftHand);
}

// The way that what carries someone goes, from its marks in this frame.
Vec3 headingOf(const Person& person, const Frame& frame)
{
    if (person.marks.size() < 4)
        return Vec3::UnitX();
    const auto at = [&](std::size_t mark) {
        return frame.position[std::size_t(person.marks[mark])];
    };
    const Vec3 way = at(0) - at(1);
    return way.norm() > 1e-9 ? Vec3(way.normalized()) : Vec3::UnitX();
}

// Straight up along the lines that carry them.
Vec3 upOf(const Person& person, const Frame& frame)
{
    const Vec3 way = meanOf(frame, person.towards) - meanOf(frame, person.holds);
    return way.norm() > 1e-9 ? Vec3(way.normalized()) : Vec3::UnitY();
}

// The point of the keel, from its nose to its tail, that is nearest to a place.
Vec3 onKeel(const Person& person, const Frame& frame, const Vec3& place)
{
    const Vec3 nose = frame.position[std::size_t(person.marks[0])];
    const Vec3 keel = frame.position[std::size_t(person.marks[1])] - nose;
    const double share = keel.dot(place - nose) / std::max(keel.squaredNorm(), 1e-9);
    return nose + std::clamp(share, 0.0, 1.0) * keel;
}

// The strap from the keel to the harness, and the control frame: uprights to the ends of the bar,
// in whose middle the wires meet.
void addControlFrame(Body& body, const Vec3& hangPoint, const Vec3& back, const Vec3& bar)
{
    body.add(hangPoint, back, strapRadius, strapRadius);
    for (const double side : {1.0, -1.0})
        body.add(hangPoint, bar + side * halfBar * body.right, tubeRadius, tubeRadius);
}

// The middle of the body is where the weight is; it lies along the keel.
std::vector<Limb> prone(const Person& person, const Frame& frame)
{
    const Vec3 middle = meanOf(frame, person.holds);
    const Vec3 heading = headingOf(person, frame);
    const Vec3 up = upOf(person, frame);
    Body body(up - up.dot(heading) * heading, heading); // ahead is along the spine
    const Vec3 chest = middle + (shoulders - 0.55 * tall) * body.ahead;
    const Vec3 pelvis = middle + (hips - 0.55 * tall) * body.ahead;
    body.addTrunk(chest, pelvis, body.ahead + 0.25 * body.up);
    // the bar that they steer by, where the wires meet or before the chest
    const Vec3 bar = person.bar.empty() ? Vec3(chest + 0.34 * body.ahead - 0.42 * body.up)
                                        : meanOf(frame, person.bar);
    for (const double side : {1.0, -1.0}) {
        const Vec3 joint = chest + side * halfShoulders * body.right;
        const Vec3 hand = bar + side * (halfShoulders + 0.08) * body.right;
        body.addArm(joint, hand, side * body.right - 0.5 * body.ahead);
        const Vec3 hip = pelvis + side * halfHips * body.right;
        const Vec3 heel =
            hip - (thigh + shin - 0.01) * body.ahead - 0.04 * body.up - side * 0.04 * body.right;
        body.addLeg(hip, heel, -body.up, -body.ahead);
    }
    body.add(bar - halfBar * body.right, bar + halfBar * body.right, tubeRadius, tubeRadius);
    if (!person.bar.empty())
        addControlFrame(body, onKeel(person, frame, middle), middle + harnessRadius * body.up, bar);
    // the harness holds the legs together
    body.add(pelvis, pelvis - 0.9 * (thigh + shin) * body.ahead, harnessRadius, 0.085);
    return body.limbs;
}

// Who has come down stands where the weight lies, the risers in their hands as long as those reach.
std::vector<Limb> landed(const Vec3& meet, double ground, const Vec3& heading)
{
    const Vec3 shoulder(meet.x(), ground + shoulders, meet.z());
    const Body body(Vec3::UnitY(), heading);
    const auto hand = [&](double side) {
        const Vec3 joint = shoulder + side * halfShoulders * body.right;
        const Vec3 way = meet + 0.25 * body.ahead - joint;
        return Vec3(joint + std::min(1.0, reach / std::max(way.norm(), 1e-6)) * way);
    };
    std::vector<Limb> limbs = standing(shoulder, ground, body.ahead, hand(1.0), hand(-1.0));
    for (const double side : {1.0, -1.0})
        limbs.push_back({hand(side), meet, 0.014, 0.010});
    return limbs;
}

std::vector<Limb> upright(const Person& person, const Frame& frame,
                          const std::vector<ColliderBody>& colliders)
{
    const Vec3 meet = meanOf(frame, person.holds);
    const double ground = groundBelow(colliders, frame, meet);
    if (meet.y() < ground + riser + tall)
        return landed(meet, ground, headingOf(person, frame));
    Body body(upOf(person, frame), headingOf(person, frame));
    const Vec3 chest = meet - (riser + tall - shoulders) * body.up;
    const Vec3 pelvis = chest - (shoulders - hips) * body.up + 0.03 * body.ahead;
    body.addTrunk(chest, pelvis, body.up);
    for (const double side : {1.0, -1.0}) {
        const Vec3 joint = chest + side * halfShoulders * body.right;
        const Vec3 hand = joint + 0.75 * (meet - joint) + side * 0.04 * body.right;
        body.add(joint, meet, 0.014, 0.010); // a riser
        body.addArm(joint, hand, side * body.right + 0.3 * body.ahead);
        const Vec3 hip = pelvis + side * halfHips * body.right;
        const Vec3 heel =
            hip - 0.95 * (thigh + shin) * body.up - 0.02 * body.ahead + side * 0.05 * body.right;
        body.addLeg(hip, heel, body.ahead, (body.ahead - 0.7 * body.up).normalized());
    }
    return body.limbs;
}

} // namespace

std::vector<Limb> limbsOf(const Person& person, const Frame& frame,
                          const std::vector<ColliderBody>& colliders)
{
    if (!isPlace(frame, person.holds) || !isPlace(frame, person.towards)
        || !isPlace(frame, person.marks) || !isPlace(frame, person.bar))
        return {};
    switch (person.pose) {
    case Pose::Standing:
        return holding(person, frame, colliders);
    case Pose::Prone:
        return prone(person, frame);
    case Pose::Upright:
        return upright(person, frame, colliders);
    }
    return {};
}

LimbAxes::LimbAxes(const Limb& limb)
{
    const Vec3 way = limb.to - limb.from;
    along = way.norm() > 1e-9 ? Vec3(way.normalized()) : Vec3::UnitY();
    across = along.unitOrthogonal();
    third = along.cross(across);
}

} // namespace ripstop
