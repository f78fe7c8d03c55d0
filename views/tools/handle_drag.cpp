// follow() takes the cursor and counts the angle turned so far, whole turns included. numbers()
// comes to numbers along or about the axes in this order: what is typed, else what snaps (a goal,
// the grid, 15 degrees, tenths), else where the hand is; axes that the handle does not change stay
// idle. motion() makes a motion of them and told() a sentence.
//
// The step of the grid is a round number that is at least twelve pixels long in the picture.
#include "tools/handle_drag.h"

#include "document/words.h"

#include <QStringList>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

constexpr double snapAngle = 15.0;  // degrees
constexpr double snapFactor = 0.1;  // 1
constexpr double gridPixels = 12.0; // a step of the grid is at least this long

double rounded(double value, double step) { return step * std::round(value / step); }

// Step of the grid, m: 1, 2 or 5 times a power of ten.
double gridStep(const Gizmo& gizmo)
{
    const double least = gridPixels * gizmo.projection.metresPerPixel(gizmo.pivot);
    const double decade = std::pow(10.0, std::floor(std::log10(least)));
    const double ratio = least / decade;
    return decade * (ratio > 5.0 ? 10.0 : ratio > 2.0 ? 5.0 : 2.0);
}

} // namespace

Vec3 idleNumbers(Shaping shaping)
{
    return shaping == Shaping::Scale ? Vec3(Vec3::Ones()) : Vec3(Vec3::Zero());
}

Motion motionOf(const Gizmo& handles, const Vec3& numbers)
{
    if (handles.shaping == Shaping::Move)
        return shifted(handles.axes * numbers);
    if (handles.shaping == Shaping::Scale)
        return scaled(handles.pivot, numbers, handles.axes);
    Motion motion;
    for (int axis = 0; axis < 3; ++axis)
        motion.map =
            turned(handles.pivot, handles.axes.col(axis), numbers[axis] / degreesPerRadian).map
            * motion.map;
    return motion;
}

HandleDrag HandleDrag::at(const Gizmo& gizmo, Handle handle, QPointF from)
{
    HandleDrag pull{gizmo, handle, from, from};
    pull.lastAngle = gizmo.angle(handle, from);
    return pull;
}

void HandleDrag::follow(QPointF cursor)
{
    to = cursor;
    const double now = start.angle(handle, cursor);
    angle += std::remainder(now - lastAngle, 2.0 * std::numbers::pi);
    lastAngle = now;
}

void HandleDrag::keepTo(int axis)
{
    const Handle wanted{Handle::Sort::Axis, axis};
    handle = handle == wanted ? Handle{Handle::Sort::Free, 0} : wanted;
    angle = 0.0;
    lastAngle = start.angle(handle, to);
}

bool HandleDrag::isAboutSight() const
{
    return start.shaping == Shaping::Turn && handle.sort == Handle::Sort::Free;
}

std::optional<double> HandleDrag::typedNumber() const
{
    bool isNumber = false;
    const double number = QString(typed).replace(',', '.').toDouble(&isNumber);
    return isNumber ? std::optional(number) : std::nullopt;
}

Vec3 HandleDrag::way(const std::optional<Vec3>& goal) const
{
    Vec3 way = start.axes.transpose() * start.shift(handle, from, to);
    if (!snaps)
        return way;
    if (goal) {
        way = start.axes.transpose() * (*goal - start.pivot);
    } else {
        const double step = gridStep(start);
        const Vec3 zero = placesAreRound ? start.pivot : Vec3(Vec3::Zero());
        for (int axis = 0; axis < 3; ++axis)
            way[axis] = rounded(zero[axis] + way[axis], step) - zero[axis];
    }
    for (int axis = 0; axis < 3; ++axis)
        if (!handle.axes()[std::size_t(axis)])
            way[axis] = 0.0;
    return way;
}

Vec3 HandleDrag::numbers(const std::optional<Vec3>& goal) const
{
    const auto number = typedNumber();
    if (start.shaping == Shaping::Move) {
        if (!number)
            return way(goal);
        return *number * Vec3::Unit(handle.sort == Handle::Sort::Axis ? handle.axis : 0);
    }
    if (start.shaping == Shaping::Turn) {
        const double turned = degreesPerRadian * angle;
        const double snapped = snaps ? rounded(turned, snapAngle) : turned;
        return number.value_or(snapped) * Vec3::Unit(handle.axis);
    }
    Vec3 factors = start.factors(handle, from, to);
    for (int i = 0; i < 3; ++i)
        if (handle.axes()[std::size_t(i)]) {
            if (snaps)
                factors[i] = std::max(rounded(factors[i], snapFactor), snapFactor);
            if (number && *number > 0.0)
                factors[i] = *number;
        }
    return factors;
}

Motion HandleDrag::motion(const Vec3& numbers) const
{
    if (isAboutSight())
        return turned(start.pivot, start.turningAxis(handle),
                      numbers[handle.axis] / degreesPerRadian);
    return motionOf(start, numbers);
}

QString HandleDrag::told(const Vec3& numbers) const
{
    const auto text = [](double value, int digits) {
        return QLocale().toString(value, 'f', digits).replace('-', QChar(0x2212));
    };
    QStringList said;
    if (start.shaping == Shaping::Turn)
        said << words("%1\u00b0").arg(text(numbers[handle.axis], 1));
    else if (start.shaping == Shaping::Scale && handle.sort == Handle::Sort::Free)
        said << words("\u00d7%1").arg(text(numbers[0], 3));
    else
        for (int i = 0; i < 3; ++i)
            if (handle.axes()[std::size_t(i)])
                said << (start.shaping == Shaping::Move ? words("%1 %2 m") : words("%1 \u00d7%2"))
                            .arg(QChar('x' + i), text(numbers[i], 3));
    if (!typed.isEmpty())
        said << words("typed: %1").arg(typed);
    return said.join(QStringLiteral("   "));
}

} // namespace ripstop
