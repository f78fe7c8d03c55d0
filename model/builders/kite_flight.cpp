// The flight of a kite in the order in which builders call it: the wind and its gusts; the launch,
// at the angle where the moments of air and weight about the tow point cancel (found by halving
// between 1 and 60 degrees); the line to the hand with second neighbours tied; the controls of the
// hand; and the probes, with plots where there are gusts.
#include "builders/kite_flight.h"

#include "builders/craft_materials.h"
#include "builders/delta_wing.h"
#include "builders/statics.h"

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

Vec3 handPlace(const Parameters& p) { return {0.0, p.at("hand_height"), 0.0}; }

// The angle of attack at which air and weight do not turn the kite about the tow point, rad.
double trimAngle(const Scene& scene, const Network& network, Id towPoint, double speed)
{
    const Vec3 tow = network.position(towPoint);
    const LumpedMass weight = lumpedMassOf(network.part());
    const auto moment = [&](double angle) {
        const Load air = airLoad(scene, network.part(), headwind(speed, angle));
        const Vec3 down = -weight.mass * scene.settings.gravity.norm()
                          * Vec3(std::sin(angle), std::cos(angle), 0.0);
        return (air.moment - tow.cross(air.force) + (weight.center - tow).cross(down)).z();
    };
    return root(moment, 1.0 * degrees, 60.0 * degrees);
}

} // namespace

void addKiteWind(Scene& scene, const Parameters& p)
{
    addWind(scene, Vec3(p.at("wind"), 0.0, 0.0));
    if (p.at("gusts") > 0.0) {
        Wind gusts;
        gusts.name = "gusts";
        gusts.kind = WindKind::Gusts;
        gusts.gustiness = p.at("gusts");
        gusts.referenceHeight = p.at("hand_height") + 0.5 * p.at("line_length");
        addItem(scene, gusts);
    }
}

void launch(const Scene& scene, Network& network, const Parameters& p, Id towPoint)
{
    const double angle = trimAngle(scene, network, towPoint, std::max(1.0, p.at("wind")));
    Eigen::Matrix3d turn;
    turn.col(0) = Vec3(-std::cos(angle), std::sin(angle), 0.0);
    turn.col(1) = Vec3(std::sin(angle), std::cos(angle), 0.0);
    turn.col(2) = Vec3(0.0, 0.0, -1.0);
    const double rise = p.at("launch") * degrees;
    const Vec3 tow = handPlace(p) + p.at("line_length") * Vec3(std::cos(rise), std::sin(rise), 0.0);
    network.place(turn, tow - turn * network.position(towPoint), Vec3::Zero());
}

FlyingLine addFlyingLine(Network& network, const Parameters& p, const LineMaterials& materials,
                         Id tow)
{
    const int count = int(p.at("line"));
    const Id hand = network.particle(handPlace(p));
    const Id end = network.particle(handPlace(p));
    const double mass = p.at("line_length") * cordDensity(p);
    const std::size_t first = network.part().links.size();
    const std::vector<Id> nodes =
        network.line(tow, end, count, mass, materials.line, Resists::Tension);
    const Id firstRod = network.part().links[first].id;
    for (int i = 1; i + 2 <= count; ++i)
        network.rod(nodes[i], nodes[i + 2], materials.core, Resists::Tension);
    for (const Id pinned : {end, hand}) {
        network.row(pinned).mass = mass / count;
        network.row(pinned).pinned = true;
    }
    return {firstRod, {end, hand}};
}

void addHandControls(Scene& scene, const std::vector<Id>& hand)
{
    Control control;
    control.targets = hand;
    control.step = 0.25;
    control.limit = 10.0;
    control.rate = 2.0;

    control.name = "hand";
    control.axis = -Vec3::UnitX();
    control.keyLess = "Up";
    control.keyMore = "Down";
    addItem(scene, control);

    control.name = "hand sideways";
    control.axis = -Vec3::UnitZ();
    control.keyLess = "Left";
    control.keyMore = "Right";
    addItem(scene, control);
}

void addKiteProbes(Scene& scene, const Parameters& p, Id kite, Id tow, const FlyingLine& line)
{
    const Id hand = line.hand.back();
    addProbe(scene, "height", Quantity::PositionY, tow);
    const Id angle = addProbe(scene, "line angle", Quantity::Elevation, tow, hand);
    addProbe(scene, "distance", Quantity::Distance, tow, hand);
    const Id pull = addProbe(scene, "line tension", Quantity::Tension, line.firstRod);
    addProbe(scene, "speed", Quantity::Speed, tow);
    addProbe(scene, "max strain", Quantity::MaxStrain, kite);
    if (!(p.at("gusts") > 0.0))
        return;
    addProbe(scene, "wind", Quantity::Airspeed, hand); // that stands still

    Plot plot; // of all probes
    plot.name = "flight";
    addItem(scene, plot);
    plot.probes = {pull};
    plot.seconds = 0.0; // the whole run
    plot.name = "spectrum of the pull";
    plot.axis = PlotAxis::Frequency;
    plot.logarithmic = true;
    addItem(scene, plot);
    plot.logarithmic = false;
    plot.name = "pull over line angle";
    plot.axis = PlotAxis::Probe;
    plot.against = angle;
    addItem(scene, plot);
}

} // namespace ripstop
