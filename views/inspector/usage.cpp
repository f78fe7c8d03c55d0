#include "inspector/usage.h"

namespace ripstop {
namespace {

bool uses(const Settings& settings, std::string_view key)
{
    if (key == "sweeps") // of the others, one or as many as it takes
        return settings.solver != Solver::SmallSteps && settings.solver != Solver::Auto;
    return key != "strainGoal" || settings.solver == Solver::Auto;
}

bool uses(const Part& part, std::string_view key)
{
    if (key == "fillEfficiency" || key == "addedMass")
        return part.canopyPressure > 0.0;
    return key != "selfFriction" || part.selfContact > 0.0;
}

bool uses(const Collider& collider, std::string_view key)
{
    const auto isShape = [&](auto... shapes) { return ((collider.shape == shapes) || ...); };
    using enum ColliderShape;
    if (key == "position")
        return collider.path.empty();
    if (key == "normal")
        return isShape(Plane);
    if (key == "radius")
        return isShape(Sphere);
    if (key == "size")
        return isShape(Box, HeightField);
    if (key == "turn")
        return isShape(Box, HeightField, Mesh);
    if (key == "file")
        return isShape(HeightField, Mesh);
    if (key == "scale")
        return isShape(Mesh);
    if (key == "grid" || key == "seed" || key == "hillLength")
        return isShape(HeightField) && collider.file.empty();
    return (key != "restitution" && key != "friction") || collider.response == Response::Contact;
}

bool uses(const Wind& wind, std::string_view key)
{
    if (key == "velocity")
        return wind.kind != WindKind::Gusts;
    if (key == "referenceHeight")
        return wind.kind != WindKind::Uniform && wind.kind != WindKind::Jet;
    if (key == "exponent" || key == "roughness")
        return wind.kind == (key == "exponent" ? WindKind::PowerLaw : WindKind::LogLaw);
    if (key == "gustiness" || key == "seed")
        return wind.kind == WindKind::Gusts;
    return wind.kind == WindKind::Jet || key == "name" || key == "kind";
}

bool uses(const Link& link, std::string_view key)
{
    if (key == "stiffness" || key == "damping")
        return link.kind == LinkKind::Spring;
    if (key == "width")
        return link.role != LinkRole::Line;
    return key != "compliance" || link.kind == LinkKind::Rod;
}

bool uses(const Material& material, std::string_view key)
{
    const auto isLaw = [&](auto... laws) { return ((material.airLaw == laws) || ...); };
    if (key == "normalCoefficient")
        return isLaw(AirLaw::Paper, AirLaw::LinearNormal, AirLaw::Vortex);
    if (key == "broadsideCoefficient")
        return isLaw(AirLaw::LinearNormal, AirLaw::Vortex);
    if (key == "stallAngle")
        return isLaw(AirLaw::Vortex);
    if (key == "polar")
        return material.airLaw == AirLaw::LiftDrag;
    if (key == "skinFriction")
        return !isLaw(AirLaw::None);
    if (key == "porosity")
        return !isLaw(AirLaw::None, AirLaw::Vortex);
    if (key == "dragCoefficient")
        return material.diameter > 0.0;
    return key != "tearLimit" || material.tearRule != TearRule::Never;
}

bool uses(const Probe& probe, std::string_view key)
{
    return key != "from" || probe.quantity == Quantity::Distance
           || probe.quantity == Quantity::Elevation;
}

bool uses(const Particle&, std::string_view) { return true; }
bool uses(const Panel&, std::string_view) { return true; }
bool uses(const Group&, std::string_view) { return true; }
bool uses(const Control&, std::string_view) { return true; }

} // namespace

bool isUsed(const Property& property, const ConstRef& ref)
{
    return std::visit([&](const auto* thing) { return uses(*thing, property.key); }, ref);
}

} // namespace ripstop
