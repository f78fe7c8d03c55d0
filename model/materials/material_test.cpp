// The fit is made about the middle of its points, where slope and offset do not depend on each
// other, and in units of the spread of the elongations, so that strains of a thousandth are no
// worse off than deflections of metres.
#include "materials/material_test.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace ripstop {
namespace {

constexpr double toe = 0.1;   // of the largest force: crimp, slack and play end below it
constexpr double ahead = 0.6; // of it: what comes later is on the way to the break
constexpr double gone = 0.5;  // of it: less is left of what has broken
constexpr int keptPoints = 12;

// N of a rod's middle to N m, N of a strip to N/m.
double strengthFactor(const SpecimenSize& size)
{
    return size.specimen == Specimen::Strip ? 1.0 / size.width
           : size.specimen == Specimen::Rod ? 0.25 * size.length
                                            : 1.0;
}

// Newtons per strain, or per metre, to the stiffness.
double stiffnessFactor(const SpecimenSize& size)
{
    return size.specimen == Specimen::Strip ? 1.0 / size.width
           : size.specimen == Specimen::Rod ? std::pow(size.length, 3) / 48.0
                                            : 1.0;
}

// Some of the points up to the break, as a curve whose loads and strains rise.
std::vector<StretchPoint> curveOf(const std::vector<TestPoint>& points, const MaterialFit& fit,
                                  const SpecimenSize& size)
{
    std::vector<StretchPoint> curve;
    StretchPoint last{0.0, 0.0};
    for (const TestPoint& point : points) {
        const StretchPoint next{point.force * strengthFactor(size), point.elongation};
        const bool apart = next.strain >= last.strain + fit.highestAt / keptPoints
                           || point.elongation >= fit.highestAt;
        if (point.elongation > fit.highestAt || !apart || next.load <= last.load)
            continue;
        curve.push_back(last = next);
    }
    return curve;
}

} // namespace

std::string_view specimenName(Specimen specimen)
{
    constexpr std::array<std::string_view, specimenCount> names{"strip", "line", "rod"};
    return names[std::size_t(specimen)];
}

std::string_view stiffnessUnit(Specimen specimen)
{
    constexpr std::array<std::string_view, specimenCount> units{"N/m", "N", "N m\u00b2"};
    return units[std::size_t(specimen)];
}

std::string_view elongationUnit(Specimen specimen)
{
    return specimen == Specimen::Rod ? "mm" : "%";
}

double shownElongation(double elongation, Specimen specimen)
{
    return elongation * (specimen == Specimen::Rod ? 1e3 : 1e2);
}

const Property& stiffnessOf(const SpecimenSize& size)
{
    if (size.specimen == Specimen::Line)
        return propertyOf<&Material::axialStiffness>();
    if (size.specimen == Specimen::Rod)
        return propertyOf<&Material::flexuralRigidity>();
    return size.direction == PullDirection::Warp ? propertyOf<&Material::membraneStiffness>()
                                                 : propertyOf<&Material::weftStiffness>();
}

const Property& strengthOf(const SpecimenSize& size)
{
    if (size.specimen == Specimen::Line)
        return propertyOf<&Material::lineStrength>();
    if (size.specimen == Specimen::Rod)
        return propertyOf<&Material::breakingMoment>();
    return size.direction == PullDirection::Warp ? propertyOf<&Material::warpStrength>()
                                                 : propertyOf<&Material::weftStrength>();
}

Result<MaterialFit> fitMaterialTest(const std::vector<TestPoint>& points, const SpecimenSize& size,
                                    std::optional<ElongationRange> range)
{
    const auto highest = std::ranges::max_element(points, {}, &TestPoint::force);
    if (highest == points.end() || !(highest->force > 0.0))
        return Failure("The force is never above 0: are the columns in the other order?");
    if (highest == points.begin())
        return Failure("The force falls from the first row on; a test begins where it is slack.");
    MaterialFit fit;
    fit.highest = highest->force;
    fit.highestAt = highest->elongation;
    fit.broke = std::any_of(highest, points.end(), [&](const TestPoint& point) {
        return point.force < gone * highest->force;
    });
    const std::vector<TestPoint> rising(points.begin(), highest + 1);
    if (!range) {
        const auto reaches = [&](double share) {
            return std::ranges::find_if(rising,
                                        [&](const TestPoint& point) {
                                            return point.force >= share * highest->force;
                                        })
                ->elongation;
        };
        range = {reaches(toe), reaches(ahead)};
    }
    fit.range = *range;
    std::vector<TestPoint> used;
    std::ranges::copy_if(rising, std::back_inserter(used), [&](const TestPoint& point) {
        return point.elongation >= range->from && point.elongation <= range->to;
    });
    fit.points = int(used.size());
    if (fit.points < 3)
        return Failure("There are %1 points between %2 and %3 %4; a fit needs three or more.",
                       fit.points,
                       Message::number("%.4g", shownElongation(range->from, size.specimen)),
                       Message::number("%.4g", shownElongation(range->to, size.specimen)),
                       elongationUnit(size.specimen));

    const auto n = Eigen::Index(used.size());
    Eigen::VectorXd x(n), force(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        x[i] = used[std::size_t(i)].elongation;
        force[i] = used[std::size_t(i)].force;
    }
    const double middle = x.mean();
    const double spread = (x.array() - middle).matrix().norm();
    if (!(spread > 0.0))
        return Failure("All points of the range have the same elongation.");
    Eigen::MatrixX2d line(n, 2);
    line.col(0).setOnes();
    line.col(1) = (x.array() - middle) / spread;
    const Eigen::Vector2d solution = line.colPivHouseholderQr().solve(force);
    fit.slope = solution[1] / spread;
    fit.offset = solution[0] - fit.slope * middle;
    if (!(fit.slope > 0.0))
        return Failure("The force does not rise in this range; choose another one.");
    fit.residual = (force - line * solution).norm() / std::sqrt(double(n - 2));
    fit.stiffness = fit.slope * stiffnessFactor(size);
    fit.standardError = fit.residual / spread * stiffnessFactor(size);
    if (fit.broke)
        fit.strength = fit.highest * strengthFactor(size);
    return fit;
}

Message summaryOf(const MaterialFit& fit, const SpecimenSize& size)
{
    return Message("%1 %2 %3, standard error %4 (%5 %); %6 points from %7 to %8 %9",
                   Message::word(stiffnessOf(size).label), Message::number("%.5g", fit.stiffness),
                   stiffnessUnit(size.specimen), Message::number("%.3g", fit.standardError),
                   Message::number("%.2g", 100.0 * fit.standardError / fit.stiffness), fit.points,
                   Message::number("%.3g", shownElongation(fit.range.from, size.specimen)),
                   Message::number("%.3g", shownElongation(fit.range.to, size.specimen)),
                   elongationUnit(size.specimen));
}

Preset presetOf(const MaterialFit& fit, const std::vector<TestPoint>& points,
                const SpecimenSize& size, std::string name, std::string_view source,
                const Preset* like)
{
    Preset preset;
    if (like)
        preset = *like;
    preset.own = true;
    preset.kind = size.specimen == Specimen::Strip  ? PresetKind::Fabric
                  : size.specimen == Specimen::Line ? PresetKind::Line
                                                    : PresetKind::Spar;
    if (like && isSheet(like->kind) && isSheet(preset.kind))
        preset.kind = like->kind;
    preset.label = name;
    preset.name = std::move(name);
    const auto set = [&](const Property& property, double value, std::string text) {
        std::erase_if(preset.values,
                      [&](const PresetNumber& number) { return number.key == property.key; });
        preset.values.push_back({property.key, value, NumberStanding::Measured, std::move(text)});
    };
    const std::string from(source);
    set(stiffnessOf(size), fit.stiffness, from + ": " + summaryOf(fit, size).english());
    if (!fit.strength)
        return preset;
    set(strengthOf(size), *fit.strength,
        from + ": broke at " + Message::number("%.4g", fit.highest).english() + " N");
    if (size.specimen == Specimen::Rod)
        return preset;
    // what tears by force has to tear at the strength that was found
    const PresetNumber* rule = findNumber(preset, propertyOf<&Material::tearRule>());
    if (size.specimen == Specimen::Line && rule && std::get<std::string>(rule->value) == "force")
        set(propertyOf<&Material::tearLimit>(), *fit.strength, from);
    preset.breakElongation = {breakElongationKey, fit.highestAt, NumberStanding::Measured, from};
    if (size.direction == PullDirection::Warp)
        preset.curve = {curveOf(points, fit, size), NumberStanding::Measured, from};
    return preset;
}

} // namespace ripstop
