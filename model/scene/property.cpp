// The rows of the table of properties. Text and limits of values stand in value.cpp, the conditions
// under which a value counts in property_needs.h.
// 1. Codec turns a field into a Value and back: fields as they are, enumerations as their names,
//    optional fields with nothing as an absent value.
// 2. property() joins a row from a pointer to member. The conditions come before what is unusual
//    and may not be left out, so that whoever adds a property thinks of them; {} always counts.
// 3. The table stands in the order of Kind, because propertiesOf() returns a span of it.
// 4. The lookups follow: by kind and key, by meaning, and by field.
#include "scene/property.h"

#include "scene/property_needs.h"

#include <algorithm>
#include <cassert>

namespace ripstop {
namespace {

template <typename Field>
struct Codec // bool, int, double, text, Vec3, id, ids and tables are held as they are
{
    static constexpr bool optional = false;
    static std::span<const std::string_view> choices() { return {}; }
    static Value value(const Field& field) { return field; }
    static Field field(const Value& value) { return std::get<Field>(value); }
};

template <typename Field>
requires std::is_enum_v<Field> &&(!std::is_same_v<Field, Id>)struct Codec<Field>
{
    static constexpr bool optional = false;
    static std::span<const std::string_view> choices() { return choiceNames<Field>; }
    static Value value(Field field) { return std::string(choices()[std::size_t(field)]); }
    static Field field(const Value& value)
    {
        const auto& name = std::get<std::string>(value);
        return Field(std::find(choices().begin(), choices().end(), name) - choices().begin());
    }
};

template <typename T>
struct Codec<std::optional<T>>
{
    static constexpr bool optional = true;
    static std::span<const std::string_view> choices() { return {}; }
    static Value value(const std::optional<T>& field)
    {
        return field ? Value(*field) : Value(std::monostate());
    }
    static std::optional<T> field(const Value& value)
    {
        const T* held = std::get_if<T>(&value);
        return held ? std::optional<T>(*held) : std::nullopt;
    }
};

// Conditions, each of which may be asked about things of this kind. Others do not compile.
template <typename Owner>
struct NeedsOf
{
    consteval NeedsOf(std::initializer_list<Need> list)
        : needs(list)
    {
        for (const Need& need : list)
            if (need.kind.value_or(kindOfType<Owner>) != kindOfType<Owner>)
                throw "a condition on a thing of another kind";
    }
    NeedList needs;
};

template <auto member>
using OwnerOf = typename MemberOf<decltype(member)>::Owner;

// Builds a row from a pointer to member, so that a row cannot name one field and read another.
template <auto member>
Property property(std::string_view key, std::string_view label, std::string_view unit,
                  Effect effect, std::string_view help, NeedsOf<OwnerOf<member>> needs,
                  const PropertyDetails& details = {})
{
    using Owner = OwnerOf<member>;
    using Coded = Codec<typename MemberOf<decltype(member)>::Field>;
    const auto get = [](const ConstRef& ref) -> Value {
        return Coded::value(std::get<const Owner*>(ref)->*member);
    };
    const auto set = [](const Ref& ref, const Value& value) {
        std::get<Owner*>(ref)->*member = Coded::field(value);
    };
    return {details,
            kindOfType<Owner>,
            memberPlace<member>,
            key,
            label,
            unit,
            effect,
            help,
            needs.needs,
            Coded::choices(),
            Coded::value(Owner().*member),
            Coded::optional,
            get,
            set};
}

constexpr SliderRange even(double low, double high) { return {low, high, false}; }
constexpr SliderRange decades(double low, double high) { return {low, high, true}; }

constexpr Range notNegative{0.0};
constexpr Range positive{0.0, std::numeric_limits<double>::infinity(), true};
constexpr Range fraction{0.0, 1.0};
constexpr Range factors{0.001, 1000.0};
constexpr Kinds particles{Kind::Particle};
constexpr Kinds movable{Kind::Particle, Kind::Collider};
constexpr Kinds materials{Kind::Material};
constexpr Kinds elements{Kind::Particle, Kind::Link, Kind::Panel};
constexpr Kinds probes{Kind::Probe};
constexpr Kinds measurable{Kind::Particle, Kind::Link, Kind::Part, Kind::Group};

} // namespace

std::span<const Property> allProperties()
{
    using namespace needs;
    using enum Effect;
    using enum Meaning;
    using enum Trait;
    // clang-format off
    static const std::array table{
        property<&Settings::title>       ("title",       "Title",        "",        DisplayOnly, "What this scene is, in one line.", {}, {.traits = {Own}}),
        property<&Settings::notes>       ("notes",       "Notes",        "",        DisplayOnly, "What a reader of this scene should know.", {}, {.meaning = Notes, .traits = {Own}}),
        property<&Settings::timeStep>    ("timeStep",    "Time step",    "s",       Recompile,   "Simulated time of one step; shorter is more exact and slower.", {}, {.range = {1e-6, 0.1}, .traits = {Solving}}),
        property<&Settings::substeps>    ("substeps",    "Substeps",     "",        Recompile,   "Parts that each time step is cut into, the cheapest way to stiffer rods; the automatic solver takes this many or more, and a quarter of them where the automatic integrator takes bdf2.", {}, {.range = {1, 10000}, .traits = {Solving}, .usual = decades(1.0, 64.0)}),
        property<&Settings::sweeps>      ("sweeps",      "Solver passes", "",        Recompile,   "Passes over all rods in each substep; more is stiffer and slower; the direct solver stops as soon as it has converged, and small steps and the automatic solver make one.", {sweeps, someRod}, {.range = {1, 100000}, .traits = {Solving}, .usual = decades(1.0, 256.0)}),
        property<&Settings::integrator>  ("integrator",  "Integrator",   "",        Recompile,   "Rule that turns forces into motion; the automatic one takes bdf2 where all rods stretch, are damped and are solved together, and otherwise semi_implicit_euler; implicit_euler and bdf2 hold springs of any stiffness, and bdf2 keeps swings where large steps damp them, rk4 is the most exact for what has no rods.", {}, {.traits = {Solving}}),
        property<&Settings::solver>      ("solver",      "Rod solver",   "",        Recompile,   "Rule that restores the lengths of rods; the automatic one takes what the wanted accuracy needs: small steps, or all rods together where they are stiff or carry heavy loads, and springs with them that are too stiff for the substep; averaged Jacobi conserves momentum, the paper's does not.", {someLinkOrElasticPanel}, {.traits = {Solving}}),
        property<&Settings::accuracy>    ("accuracy",    "Accuracy",     "%",       Recompile,   "Largest error of the pulls in links and elastic panels that a step may leave, against what their stiffness says; the automatic solver takes what that needs, and every run says where it was missed.", {someLinkOrElasticPanel}, {.range = {0.01, 100.0}, .traits = {Solving}, .usual = decades(0.1, 10.0)}),
        property<&Settings::strainGoal>  ("strainGoal",  "Wanted strain", "%",      Recompile,   "Largest strain that the automatic solver allows in rods without compliance, where it stands for the accuracy; smaller is stiffer and slower.", {aimsAtStrain, someRod}, {.range = {1e-4, 100.0}, .traits = {Solving}}),
        property<&Settings::rampTime>    ("rampTime",    "Ramp of edits", "s",       Recompile,   "Time in which links and elastic panels take over a stiffness, damping, rest length or tear limit that is edited in flight, and longer where that would throw what they hold; 0 takes it over at once.", {someLinkOrElasticPanel}, {.range = {0.0, 60.0}, .traits = {Solving}, .usual = even(0.0, 1.0)}),
        property<&Settings::tearsPerStep>("tearsPerStep","Tears per step", "",      Recompile,   "Most links and elastic panels that tear in one time step, the most overloaded first, so that a tear runs on from its tip; 0 sets no limit.", {someTear}, {.range = {0, 1000000}, .traits = {Solving}}),
        property<&Settings::tearMesh>    ("tearMesh",    "Fabric at tears", "",    Recompile,   "What panels do that tear or are beside a link that does: they vanish, or the mesh splits, so that each panel stays whole on its side.", {someTear}),
        property<&Settings::gravity>     ("gravity",     "Gravity",      "m/s\u00b2", Recompile, "Acceleration of everything that falls; y is up.", {}),
        property<&Settings::airDensity>  ("airDensity",  "Air density",  "kg/m\u00b3", Recompile, "Mass of the air per volume; 1.225 at sea level, 0 is a vacuum.", {someCloth}, {.range = notNegative, .usual = even(0.0, 2.0)}),
        property<&Settings::viscosity>   ("viscosity",   "Viscosity",    "1/s",     Recompile,   "Rate at which every velocity decays, over and above the drag of the panels.", {}, {.range = notNegative, .usual = even(0.0, 5.0)}),
        property<&Settings::speedLimit>  ("speedLimit",  "Speed limit",  "m/s",     Recompile,   "A particle faster than this counts as diverged, and the run stops.", {}, {.range = positive, .traits = {Solving}}),
        property<&Settings::safetyFactor>("safetyFactor", "Safety factor", "",     Recompile,   "Margins count every strength as so many times lower, so that with 2 a margin of 1 is half of what breaks; flights and tears do not depend on it.", {}, {.range = positive, .usual = even(1.0, 5.0)}),

        property<&Particle::position>    ("position",    "Position",     "m",       OnReset,     "Where the particle starts.", {}, {.traits = {Own}}),
        property<&Particle::velocity>    ("velocity",    "Velocity",     "m/s",     OnReset,     "How fast the particle starts.", {isFree}),
        property<&Particle::mass>        ("mass",        "Mass",         "kg",      Recompile,   "Inertia and weight.", {isFree}, {.range = notNegative}),
        property<&Particle::pinned>      ("pinned",      "Pinned",       "",        Recompile,   "Held in place, whatever pulls on it.", {}),
        property<&Particle::guide>       ("guide",       "Guide",        "",        Recompile,   "What the particle cannot leave: a line or a plane through where it is, which takes up every force across it and gives no friction.", {isFree}),
        property<&Particle::guideAxis>   ("guideAxis",   "Guide axis",   "",        Recompile,   "Direction of the line that the particle is free along, or the direction across the plane that it is free in.", {isFree, isGuided}),
        property<&Particle::textureU>    ("u",           "Texture u",    "",        DisplayOnly, "Where the particle lies across the picture printed on the fabric, 0 to 1.", {}),
        property<&Particle::textureV>    ("v",           "Texture v",    "",        DisplayOnly, "Where the particle lies up the picture printed on the fabric, 0 to 1.", {}),

        property<&Link::from>            ("from",        "From",         "",        Recompile,   "Particle at one end.", {}, {.pointsAt = particles, .traits = {Structure}}),
        property<&Link::to>              ("to",          "To",           "",        Recompile,   "Particle at the other end.", {}, {.pointsAt = particles, .traits = {Structure}}),
        property<&Link::material>        ("material",    "Material",     "",        Recompile,   "Gives every number that the link does not set itself.", {}, {.pointsAt = materials, .traits = {Looks, Counts}}),
        property<&Link::kind>            ("kind",        "Kind",         "",        Recompile,   "A spring pulls with a force, a rod keeps its length as a constraint.", {}, {.traits = {Structure, Counts}}),
        property<&Link::resists>         ("resists",     "Resists",      "",        Recompile,   "A line resists tension only, a strut compression only, a batten both.", {}, {.traits = {Counts}}),
        property<&Link::restLength>      ("restLength",  "Rest length",  "m",       Recompile,   "Length without load.", {}, {.range = notNegative, .traits = {Own}}),
        property<&Link::role>            ("role",        "Role",         "",        Recompile,   "What the link stands for where its material has a physical stiffness: a line or spar by itself, threads of a fabric, or its resistance to shear.", {}, {.traits = {Looks, Counts}}),
        property<&Link::width>           ("width",       "Width",        "m",       Recompile,   "Width of the strip of fabric that a thread or bias stands for; with 0 it takes the material's stiffness or compliance as it is.", {isNoLine}, {.range = notNegative, .traits = {Looks, Counts}}),
        property<&Link::cellAspect>      ("cellAspect",  "Aspect of cells", "", Recompile, "How many times as long as wide the cells of the fabric beside a thread are, whose diagonals resist stretching along it by the square of that: the thread takes so much off its own stiffness.", {isThread}, {.range = positive, .traits = {Structure}}),
        property<&Link::stiffness>       ("stiffness",   "Stiffness",    "N/m",     Recompile,   "Force of a spring per metre of stretch; empty takes the material's.", {isSpring}, {.range = notNegative, .traits = {Counts}}),
        property<&Link::damping>         ("damping",     "Damping",      "N s/m",   Recompile,   "Force of a spring per metre per second of stretching; empty takes the material's.", {isSpring}, {.range = notNegative, .traits = {Counts}}),
        property<&Link::compliance>      ("compliance",  "Compliance",   "m/N",     Recompile,   "Stretch of a rod per newton, 0 never stretches; empty takes the material's.", {isRod, softRods}, {.range = notNegative, .traits = {Counts}}),
        property<&Link::tearLimit>       ("tearLimit",   "Tear limit",   "",        Recompile,   "The link breaks above this, in metres, as a strain or in newtons as its material's tear rule says, and in newtons where that is of tension or strength; empty takes the material's.", {canTear}, {.range = notNegative, .traits = {Looks, Counts}}),
        property<&Link::stiffnessFactor> ("stiffnessFactor", "Stiffness factor", "", Recompile, "How many times as stiff the link is as its material makes it: above 1 where it is reinforced, below where it is worn; a stiffness of its own is taken as it is, and bending is not touched.", {takesStiffness}, {.range = factors, .traits = {Structure, Looks}, .usual = decades(0.1, 10.0)}),
        property<&Link::strengthFactor>  ("strengthFactor", "Strength factor", "", Recompile, "How many times as strong the link is as its material makes it, for tears, snapping spars and margins: below 1 where it is worn or sewn; a tear limit of its own is taken as it is.", {}, {.range = factors, .traits = {Structure, Looks}, .usual = decades(0.1, 10.0)}),

        property<&Panel::a>              ("a",           "Corner a",     "",        Recompile,   "First corner.", {}, {.pointsAt = particles, .traits = {Structure}}),
        property<&Panel::b>              ("b",           "Corner b",     "",        Recompile,   "Second corner.", {}, {.pointsAt = particles, .traits = {Structure}}),
        property<&Panel::c>              ("c",           "Corner c",     "",        Recompile,   "Third corner.", {}, {.pointsAt = particles, .traits = {Structure}}),
        property<&Panel::restAB>         ("restAB",      "Rest length ab", "m",     Recompile,   "Length of the side from a to b without load, where panels carry the pull of the fabric; 0 takes the distance of its corners in the scene.", {isElasticFabric}, {.range = notNegative, .traits = {Own, Structure}}),
        property<&Panel::restBC>         ("restBC",      "Rest length bc", "m",     Recompile,   "Length of the side from b to c without load, where panels carry the pull of the fabric; 0 takes the distance of its corners in the scene.", {isElasticFabric}, {.range = notNegative, .traits = {Own, Structure}}),
        property<&Panel::restCA>         ("restCA",      "Rest length ca", "m",     Recompile,   "Length of the side from c to a without load, where panels carry the pull of the fabric; 0 takes the distance of its corners in the scene.", {isElasticFabric}, {.range = notNegative, .traits = {Own, Structure}}),
        property<&Panel::grain>          ("grain",       "Grain",        "deg",     Recompile,   "Angle from the side ab of each panel, towards c, at which the warp of the cloth runs, where panels carry the pull of the fabric; for one direction on the cloth map it by a formula, or paint it.", {isElasticFabric}, {.range = {0.0, 180.0}, .traits = {Own, Structure, Looks}}),
        property<&Panel::stiffnessFactor>("stiffnessFactor", "Stiffness factor", "", Recompile, "How many times as stiff the panel is in its plane as its material makes it, where panels carry the pull of the fabric: above 1 where cloth lies double, below where it is worn.", {isElasticFabric}, {.range = factors, .traits = {Structure, Looks}, .usual = decades(0.1, 10.0)}),
        property<&Panel::strengthFactor> ("strengthFactor", "Strength factor", "", Recompile, "How many times as strong the panel is as its material makes it, for tears and margins, where panels carry the pull of the fabric: below 1 where it is worn or sewn.", {isElasticFabric}, {.range = factors, .traits = {Structure, Looks}, .usual = decades(0.1, 10.0)}),
        property<&Panel::material>       ("material",    "Material",     "",        Recompile,   "Gives the colour and the law of its air load.", {}, {.pointsAt = materials, .traits = {Looks, Counts}}),

        property<&Part::name>            ("name",        "Name",         "",        DisplayOnly, "Shown in the outline and used in paths.", {}, {.meaning = Name, .traits = {Own}}),
        property<&Part::shown>           ("shown",       "Shown",        "",        DisplayOnly, "Drawn in the view.", {}, {.meaning = Shown}),
        property<&Part::carrier>          ("carrier",     "Fabric pulls by", "",     Recompile,   "What carries the pull of the fabric: threads are links, panels are elastic triangles with warp, weft and shear, which wrinkle instead of pushing and give the same answer on every mesh; links that are there carry as well.", {hasPanels}, {.traits = {Structure, Counts}}),
        property<&Part::selfContact>     ("selfContact", "Self-contact", "m",       Recompile,   "Distance that particles of this part keep from its own panels and from those of other parts with self-contact; 0 lets fabric pass through fabric.", {}, {.range = notNegative}),
        property<&Part::selfFriction>    ("selfFriction", "Self-friction", "",      Recompile,   "Coulomb coefficient of fabric on fabric.", {touchesItself}, {.range = notNegative}),
        property<&Part::canopyPressure>  ("canopyPressure", "Canopy pressure", "",  Recompile,   "Fills the fabric with air through its mouth, up to this pressure over the dynamic pressure of the wind that meets the mouth; 1.68 for round parachutes, 0 leaves each panel to meet the wind by itself.", {hasPanels}, {.range = {0.0, 4.0}, .traits = {Structure}}),
        property<&Part::fillEfficiency>  ("fillEfficiency", "Fill efficiency", "",  Recompile,   "Speed at which air fills a canopy, over that of the wind times the square root of mouth over cloth area; 0.07 for round parachutes, only with canopy pressure.", {holdsAir}, {.range = {0.0, 1.0, true}}),
        property<&Part::addedMass>       ("addedMass",   "Added mass",   "",        Recompile,   "Mass of the air that moves with a canopy over that in a hemisphere on its mouth; only with canopy pressure.", {holdsAir}, {.range = notNegative}),
        property<&Part::massTarget>      ("massTarget",  "Target mass",  "kg",      DisplayOnly, "What it is meant to weigh; the totals show the difference, and empty sets no target.", {}, {.range = positive}),
        property<&Part::lengthTarget>    ("lengthTarget", "Target length", "m",     DisplayOnly, "Length of line that it is meant to have, by the rest lengths of its links with the role line; empty sets no target.", {}, {.range = positive}),
        property<&Part::areaTarget>      ("areaTarget",  "Target area",  "m\u00b2", DisplayOnly, "Area that its panels are meant to have; empty sets no target.", {hasPanels}, {.range = positive}),
        property<&Part::builder>         ("builder",     "Builder",      "",        DisplayOnly, "Builder that made this part; empty when drawn by hand.", {}, {.traits = {Own, Noted}}),

        property<&Material::name>        ("name",        "Name",         "",        DisplayOnly, "Shown in the outline and used in paths.", {}, {.meaning = Name, .traits = {Own}}),
        property<&Material::color>       ("color",       "Colour",       "",        DisplayOnly, "Colour in the view, as #rrggbb.", {}, {.meaning = Color}),
        property<&Material::shown>       ("shown",       "Shown",        "",        DisplayOnly, "Links and panels of this material are drawn.", {}, {.meaning = Shown}),
        property<&Material::picture>     ("picture",     "Picture",      "",        DisplayOnly, "Picture printed on fabric of this material (PNG or JPEG), beside the scene file.", {ofPanels}, {.meaning = File}),
        property<&Material::pictureWidth>("pictureWidth", "Picture width", "m",     DisplayOnly, "Width of one picture on the cloth, its height as it is tall; it repeats, and 0 lays one over u and v of the mesh.", {ofPanels, hasPicture}, {.range = notNegative}),
        property<&Material::pictureRight>("pictureRight", "Picture to the right", "", DisplayOnly, "How far the picture is moved to the right, of its own width.", {ofPanels, hasPicture}, {.usual = even(-1.0, 1.0)}),
        property<&Material::pictureUp>   ("pictureUp",   "Picture upwards", "",     DisplayOnly, "How far the picture is moved up, of its own height.", {ofPanels, hasPicture}, {.usual = even(-1.0, 1.0)}),
        property<&Material::pictureTurn> ("pictureTurn", "Picture turn", "deg",     DisplayOnly, "Angle by which the picture is turned on the cloth, counter-clockwise about its middle.", {ofPanels, hasPicture}, {.usual = even(-180.0, 180.0)}),
        property<&Material::stiffness>   ("stiffness",   "Stiffness",    "N/m",     Recompile,   "Force of a spring per metre of stretch.", {ofLinks, ofSprings, givesStiffness, isAbstract}, {.range = notNegative, .usual = decades(1.0, 1e5)}),
        property<&Material::damping>     ("damping",     "Damping",      "N s/m",   Recompile,   "Force of a spring per metre per second of stretching.", {ofLinks, ofSprings, givesDamping}, {.range = notNegative, .usual = decades(1e-3, 10.0)}),
        property<&Material::compliance>  ("compliance",  "Compliance",   "m/N",     Recompile,   "Stretch of a rod per newton; 0 never stretches.", {ofLinks, ofRods, softRods, givesCompliance, isAbstract}, {.range = notNegative, .usual = decades(1e-8, 1e-2)}),
        property<&Material::dampingTime> ("dampingTime", "Damping time", "s",       Recompile,   "Pull of a rod per rate of strain over its pull per strain, Kelvin and Voigt's retardation time: what stretches it at w radians per second has the loss factor w times this, and rods that never stretch take none.", {ofStretching, softRods}, {.range = notNegative, .usual = decades(1e-5, 1e-1)}),
        property<&Material::axialStiffness>("axialStiffness", "Axial stiffness", "N", Recompile, "EA of a line or spar, its tension per strain: a link of this length L gets EA / L, whatever the stiffness and compliance above say; empty leaves it to them.", {notOnlyStiffRods, ofLines}, {.range = positive}),
        property<&Material::membraneStiffness>("membraneStiffness", "Membrane stiffness", "N/m", Recompile, "E t of a fabric along its threads, its tension per width and strain: links with the role thread get theirs from it and from their width, and so do elastic panels along their warp; empty leaves it to stiffness and compliance.", {notOnlyStiffRods, ofFabric}, {.range = positive}),
        property<&Material::shearStiffness>("shearStiffness", "Shear stiffness", "N/m", Recompile, "G t of a fabric, its shear force per width and angle: links with the role bias and elastic panels get theirs from it; empty leaves links to stiffness and compliance, and gives panels that of a sheet without threads.", {notOnlyStiffRods, ofShearingFabric}, {.range = positive}),
        property<&Material::weftStiffness>("weftStiffness", "Weft stiffness", "N/m", Recompile, "E t of a fabric across its warp, where panels carry its pull; empty takes the membrane stiffness.", {ofElasticPanels, hasMembrane}, {.range = positive}),
        property<&Material::poissonRatio>("poissonRatio", "Poisson's ratio", "",    Recompile,   "Strain by which a fabric that is pulled along its warp gets narrower over the strain along it, where panels carry its pull; 0.1 to 0.2 for tight coated cloth.", {ofElasticPanels, hasMembrane}, {.range = {0.0, 0.9}}),
        property<&Material::resistsPushing>("resistsPushing", "Resists pushing", "", Recompile,  "Panels push as a board does instead of wrinkling, where they carry the pull of the fabric.", {ofElasticPanels, hasMembrane}, {}),
        property<&Material::bendingStiffness>("bendingStiffness", "Bending stiffness", "N m", Recompile, "B of a fabric, its bending moment per width and curvature: panels of this material that share a side resist folding there; 0 lets them fold freely.", {ofPanels}, {.range = notNegative}),
        property<&Material::flexuralRigidity>("flexuralRigidity", "Flexural rigidity", "N m\u00b2", Recompile, "EI of a spar, its bending moment per curvature: links of this material that go on into each other resist turning there, and stay as bent as they are built; 0 lets them hinge freely.", {ofLines, bends}, {.range = notNegative, .traits = {Counts}}),
        property<&Material::arealDensity>("arealDensity", "Areal density", "kg/m\u00b2", DisplayOnly, "Mass of the fabric per area that its particles were given; setting another one weighs them anew, and where it was empty it only notes.", {ofCloth}, {.range = notNegative}),
        property<&Material::linearDensity>("linearDensity", "Linear density", "kg/m", DisplayOnly, "Mass of the line or spar per length that its particles were given; setting another one weighs them anew, and where it was empty it only notes.", {ofLines}, {.range = notNegative}),
        property<&Material::tearRule>    ("tearRule",    "Tears by",     "",        Recompile,   "What breaks a link: its length (m), its strain, or the force in it (N); what tears an elastic panel: the strain of its threads; or, of fabric, the tension of its threads per width (N/m); or what the strengths below say of panels and lines; or the same, and for a tear in panels that goes on the energy that its tear strength tells; or nothing.", {ofWhatTears}, {.traits = {Looks}}),
        property<&Material::tearLimit>   ("tearLimit",   "Tear limit",   "",        Recompile,   "A link or an elastic panel tears above this, in metres, as a strain, in newtons or in newtons per metre as the rule says.", {tears, hasTearLimit, givesTearLimit}, {.range = notNegative, .traits = {Looks}, .usual = decades(1e-2, 1e3)}),
        property<&Material::airLaw>      ("airLaw",      "Air law",      "",        Recompile,   "How wind pushes a panel: the paper's law grows with the square of the head-on wind, the linear law fits plates at small angles too, lift and drag are read from a table, and the vortex law finds the circulation around a whole wing.", {ofPanels, inAir}),
        property<&Material::normalCoefficient>("normalCoefficient", "Normal force", "", Recompile, "Coefficient of the force across the panel; 4 is the paper's, 2 a flat plate's, 1.17 a disc's head on; of the linear law it is the slope at small angles.", {law<AirLaw::Paper, AirLaw::LinearNormal, AirLaw::Vortex>, ofPanels, inAir}, {.range = notNegative, .usual = even(0.0, 4.0)}),
        property<&Material::broadsideCoefficient>("broadsideCoefficient", "Head-on drag", "", Recompile, "Coefficient of the linear law head on, 1.17 for a square plate; empty takes the normal force's.", {law<AirLaw::LinearNormal, AirLaw::Vortex>, ofPanels, inAir}, {.range = positive}),
        property<&Material::polar>       ("polar",       "Lift and drag", "",       Recompile,   "Rows of angle of attack in degrees from 0 to 90, lift coefficient and drag coefficient, for the law lift_drag.", {law<AirLaw::LiftDrag>, ofPanels, inAir}, {.columns = 3, .meaning = Polar}),
        property<&Material::stallAngle>  ("stallAngle",  "Stall",        "deg",     Recompile,   "Angle at which a section of a wing with the vortex law meets the air when it has lost half of its circulation; 15 for a wing, 10 to 12 for a thin sail.", {law<AirLaw::Vortex>, ofPanels, inAir}, {.range = {1.0, 40.0}}),
        property<&Material::skinFriction>("skinFriction", "Skin friction", "",      Recompile,   "Coefficient of the force along the panel, both sides together; about 0.02 for cloth.", {lawOtherThan<AirLaw::None>, ofPanels, inAir}, {.range = notNegative, .usual = even(0.0, 0.2)}),
        property<&Material::porosity>    ("porosity",    "Porosity",     "",        Recompile,   "Speed of the air that leaks through the cloth over the speed sqrt(2 dp / rho) that its pressure could give; about 0.03 for parachute nylon, 0 is tight.", {lawOtherThan<AirLaw::None, AirLaw::Vortex>, ofPanels, inAir}, {.range = fraction, .usual = even(0.0, 0.2)}),
        property<&Material::diameter>    ("diameter",    "Line diameter", "m",      Recompile,   "Thickness of links as lines in the wind; 0 gives them no drag.", {ofLinks}, {.range = notNegative}),
        property<&Material::dragCoefficient>("dragCoefficient", "Line drag", "",    Recompile,   "Drag coefficient of links across the wind; 1 to 1.1 for lines.", {hasDiameter, ofLinks}, {.range = notNegative}),
        property<&Material::warpStrength>("warpStrength", "Warp strength", "N/m", Recompile, "Pull per width at which a strip of the fabric breaks along its warp, without seams; elastic panels tear by it where the material tears by strength, and else it is noted for margins.", {ofCloth}, {.range = positive, .traits = {Looks}}),
        property<&Material::weftStrength>("weftStrength", "Weft strength", "N/m", Recompile, "Pull per width at which a strip of the fabric breaks across its warp, without seams; elastic panels tear by it where the material tears by strength, and else it is noted for margins.", {ofCloth}, {.range = positive, .traits = {Looks}}),
        property<&Material::tearStrength>("tearStrength", "Tear strength", "N", Recompile, "Force that makes a tear in the fabric go on, as the tongue test has it; tears in elastic panels go on by it where the material tears by energy, and else it is noted.", {ofCloth}, {.range = positive, .traits = {Looks}}),
        property<&Material::lineStrength>("lineStrength", "Line strength", "N", Recompile, "Tension at which a line breaks, without knots; lines and spars tear by it where the material tears by strength, and else it is noted for margins.", {ofLines}, {.range = positive, .traits = {Looks}}),
        property<&Material::breakingMoment>("breakingMoment", "Breaking moment", "N m", Recompile, "Bending moment at which a spar snaps, or yields for good; spars snap by it where the material tears by strength, and else it is noted for margins.", {ofLines, bends}, {.range = positive}),
        property<&Material::jointEfficiency>("jointEfficiency", "Joint efficiency", "", Recompile, "Share of its strengths that what is made of it keeps, as fabric does at seams and a line at knots: about 0.8 for lap seams, 0.9 for sewn loops, 0.35 to 0.6 for knots; all of it tears at that share where the material tears by strength, and else it is noted for margins.", {}, {.range = {0.0, 1.0, true}, .traits = {Looks}}),

        property<&Group::name>           ("name",        "Name",         "",        DisplayOnly, "Shown in the outline and used in paths.", {}, {.meaning = Name, .traits = {Own}}),
        property<&Group::members>        ("members",     "Members",      "",        Recompile,   "Particles, links and panels that belong to the group.", {}, {.pointsAt = elements}),
        property<&Group::massTarget>      ("massTarget",  "Target mass",  "kg",      DisplayOnly, "What it is meant to weigh; the totals show the difference, and empty sets no target.", {}, {.range = positive}),
        property<&Group::lengthTarget>    ("lengthTarget", "Target length", "m",     DisplayOnly, "Length of line that it is meant to have, by the rest lengths of its links with the role line; empty sets no target.", {}, {.range = positive}),
        property<&Group::areaTarget>      ("areaTarget",  "Target area",  "m\u00b2", DisplayOnly, "Area that its panels are meant to have; empty sets no target.", {}, {.range = positive}),

        property<&Collider::name>        ("name",        "Name",         "",        DisplayOnly, "Shown in the outline and used in paths.", {}, {.meaning = Name, .traits = {Own}}),
        property<&Collider::shape>       ("shape",       "Shape",        "",        Recompile,   "A plane without end, a sphere, a box, a cylinder, hills or a relief from a picture, or a mesh from a file.", {}, {.traits = {Looks}}),
        property<&Collider::position>    ("position",    "Position",     "m",       Recompile,   "A point of the plane, the centre of the sphere, the box or the cylinder, the middle of the foot of a height field, or the origin of the mesh.", {hasNoPath}, {.traits = {Looks, Own}}),
        property<&Collider::normal>      ("normal",      "Normal",       "",        Recompile,   "Direction that the plane faces; only planes use it.", {hasNormal}, {.traits = {Looks}}),
        property<&Collider::radius>      ("radius",      "Radius",       "m",       Recompile,   "Radius of the sphere or the cylinder; other shapes do not use it.", {hasRadius}, {.range = positive, .traits = {Looks}}),
        property<&Collider::size>        ("size",        "Size",         "m",       Recompile,   "Edges of a box, or width, height and depth of a height field; the second number is the height of a cylinder, whose axis is its own y.", {hasSize}, {.traits = {Looks}}),
        property<&Collider::turn>        ("turn",        "Turn",         "deg",     Recompile,   "Angles about x, then y, then z; planes and spheres do not use it.", {turns}, {.traits = {Looks}}),
        property<&Collider::thickness>   ("thickness",   "Thickness",    "m",       Recompile,   "Distance that fabric keeps from the surface, half the thickness of the fabric or more; it rounds edges.", {}, {.range = notNegative, .traits = {Looks}, .usual = even(0.0, 0.05)}),
        property<&Collider::response>    ("response",    "Response",     "",        Recompile,   "What is left of the motion of a particle that touches: nothing, the part along the surface, or a bounce with friction.", {}, {.traits = {Looks}}),
        property<&Collider::restitution> ("restitution", "Restitution",  "",        Recompile,   "Share of the impact speed that a bounce gives back; only the response contact uses it.", {bounces}, {.range = fraction, .traits = {Looks}, .usual = even(0.0, 1.0)}),
        property<&Collider::friction>    ("friction",    "Friction",     "",        Recompile,   "Coulomb coefficient; only the response contact uses it.", {bounces}, {.range = notNegative, .traits = {Looks}, .usual = even(0.0, 1.5)}),
        property<&Collider::path>        ("path",        "Path",         "",        Recompile,   "Times in s and places in m that the collider moves through, as 0: 0 1 0; 2.5: 3 1 0; empty stays at its position.", {}, {.meaning = Path, .traits = {Looks}}),
        property<&Collider::file>        ("file",        "File",         "",        Recompile,   "Grey picture of a height field (PNG, PGM) or mesh (OBJ, STL, PLY and others), beside the scene file; a height field without one gets generated hills.", {hasFile}, {.meaning = File, .traits = {Looks}}),
        property<&Collider::scale>       ("scale",       "Scale",        "",        Recompile,   "Metres per unit of the mesh file; only meshes use it.", {isScaled}, {.range = positive, .traits = {Looks}}),
        property<&Collider::grid>        ("grid",        "Grid",         "",        Recompile,   "Points along each side of generated hills.", {isGenerated}, {.range = {2, 4096}, .traits = {Looks}}),
        property<&Collider::seed>        ("seed",        "Seed",         "",        Recompile,   "Number that picks the generated hills; the same number gives the same hills.", {isGenerated}, {.traits = {Looks}}),
        property<&Collider::hillLength>  ("hillLength",  "Hill length",  "",        Recompile,   "Distance from one generated hill to the next, over the width of the field.", {isGenerated}, {.range = {0.01, 10.0}, .traits = {Looks}, .usual = decades(0.02, 2.0)}),
        property<&Collider::shown>       ("shown",       "Shown",        "",        DisplayOnly, "Drawn in the view.", {}, {.meaning = Shown}),

        property<&Wind::name>            ("name",        "Name",         "",        DisplayOnly, "Shown in the outline and used in paths.", {}, {.meaning = Name, .traits = {Own}}),
        property<&Wind::kind>            ("kind",        "Kind",         "",        Recompile,   "The same everywhere, growing with height by a power law or a logarithm, gusts after Dryden that the other winds carry past, a jet from a nozzle, single gusts of a known size, or as measured; the winds of a scene add up.", {inAir, someCloth}, {.traits = {Structure, Looks}}),
        property<&Wind::velocity>        ("velocity",    "Velocity",     "m/s",     Recompile,   "Velocity of the air: everywhere, at the reference height, in the nozzle, or at the peak of a discrete gust; gusts after Dryden and measured winds have none of their own.", {inAir, someCloth, hasVelocity}, {.traits = {Looks}, .usual = even(0.0, 25.0)}),
        property<&Wind::referenceHeight> ("referenceHeight", "Reference height", "m", Recompile, "Height over y = 0 at which a profile has its velocity, or for which gusts are made.", {inAir, someCloth, hasHeight}, {.range = positive, .traits = {Looks}}),
        property<&Wind::exponent>        ("exponent",    "Exponent",     "",        Recompile,   "Exponent of the power law; 1/7 over open land, 0.1 over water.", {inAir, someCloth, isPowerLaw}, {.range = {0.0, 2.0}, .traits = {Looks}}),
        property<&Wind::roughness>       ("roughness",   "Roughness",    "m",       Recompile,   "Height at which the logarithmic profile starts; 0.0002 on the sea, 0.03 over grass, 0.1 over farmland, 0.5 to 1 over suburbs.", {inAir, someCloth, isLogLaw}, {.range = positive, .traits = {Looks}}),
        property<&Wind::gustiness>       ("gustiness",   "Gustiness",    "m/s",     Recompile,   "Wind at 20 ft whose gusts these are; 7.7 is light turbulence, 15.4 moderate, 23.2 severe.", {inAir, someCloth, isGusts}, {.range = notNegative, .traits = {Looks}, .usual = even(0.0, 25.0)}),
        property<&Wind::seed>            ("seed",        "Seed",         "",        Recompile,   "Number that the gusts follow from; the same seed gives the same gusts.", {inAir, someCloth, isGusts}, {.range = notNegative, .traits = {Looks}}),
        property<&Wind::position>        ("position",    "Position",     "m",       Recompile,   "Middle of the nozzle of a jet.", {inAir, someCloth, isJet}, {.traits = {Looks, Own}}),
        property<&Wind::radius>          ("radius",      "Radius",       "m",       Recompile,   "Radius of the nozzle of a jet.", {inAir, someCloth, isJet}, {.range = positive, .traits = {Looks}}),
        property<&Wind::spread>          ("spread",      "Spread",       "deg",     Recompile,   "Half the angle by which a jet widens; 12 is that of a free jet.", {inAir, someCloth, isJet}, {.range = {0.0, 80.0}, .traits = {Looks}}),
        property<&Wind::onset>           ("onset",       "Onset",        "s",       Recompile,   "When the first gust begins.", {inAir, someCloth, isDiscreteGust}, {.range = notNegative, .traits = {Looks}, .usual = even(0.0, 30.0)}),
        property<&Wind::duration>        ("duration",    "Duration",     "s",       Recompile,   "How long a gust lasts: it grows for half of that, and falls again.", {inAir, someCloth, isDiscreteGust}, {.range = positive, .traits = {Looks}, .usual = even(0.5, 10.0)}),
        property<&Wind::interval>        ("interval",    "Interval",     "s",       Recompile,   "From the beginning of a gust to that of the next; 0 has one gust only.", {inAir, someCloth, isDiscreteGust}, {.range = notNegative, .traits = {Looks}, .usual = even(0.0, 20.0)}),
        property<&Wind::growth>          ("growth",      "Growth",       "",        Recompile,   "By how much of the first each gust is stronger than the one before: 0.25 has peaks of 1, 1.25, 1.5 and so on.", {inAir, someCloth, isRepeated}, {.range = notNegative, .traits = {Looks}, .usual = even(0.0, 1.0)}),
        property<&Wind::velocities>      ("velocities",  "Velocities",   "",        Recompile,   "Rows of time in s and of velocity along x, y and z in m/s: straight from row to row, and before the first and after the last as there.", {inAir, someCloth, isMeasured}, {.columns = 4, .meaning = Times, .traits = {Looks}}),

        property<&Control::name>         ("name",        "Name",         "",        DisplayOnly, "Shown in the outline and used in paths.", {}, {.meaning = Name, .traits = {Own}}),
        property<&Control::kind>         ("kind",        "Kind",         "",        Recompile,   "Moves its targets, or shifts their weight inside the rods that hold them.", {}),
        property<&Control::targets>      ("targets",     "Targets",      "",        Recompile,   "Particles that the control acts on, and colliders that it moves.", {}, {.pointsAt = movable}),
        property<&Control::axis>         ("axis",        "Axis",         "",        Recompile,   "Direction of a positive value.", {}),
        property<&Control::keyLess>      ("keyLess",     "Key less",     "",        DisplayOnly, "Key that lowers the value by one step, for example Left.", {}, {.meaning = Keys}),
        property<&Control::keyMore>      ("keyMore",     "Key more",     "",        DisplayOnly, "Key that raises the value by one step, for example Right.", {}, {.meaning = Keys}),
        property<&Control::step>         ("step",        "Step",         "m",       DisplayOnly, "Change of the commanded value per key press.", {}, {.range = positive}),
        property<&Control::limit>        ("limit",       "Limit",        "m",       Recompile,   "Largest value either way.", {}, {.range = notNegative}),
        property<&Control::rate>         ("rate",        "Rate",         "m/s",     Recompile,   "How fast the value follows its command in simulated time.", {}, {.range = positive}),
        property<&Control::automaticRate>("automaticRate", "Automatic rate", "m/s", Recompile,   "How fast the value moves by itself until it reaches the limit; 0 waits for keys.", {}),

        property<&Probe::name>           ("name",        "Name",         "",        DisplayOnly, "Shown in plots and tables.", {}, {.meaning = Name, .traits = {Own}}),
        property<&Probe::quantity>       ("quantity",    "Quantity",     "",        Recompile,   "What is measured.", {}),
        property<&Probe::target>         ("target",      "Target",       "",        Recompile,   "Particle, link, part or group that is measured; empty is the whole scene.", {isOfThings}, {.pointsAt = measurable}),
        property<&Probe::from>           ("from",        "From",         "",        Recompile,   "Particle that a distance or an elevation is measured from; the tail, where the target is the nose.", {hasOrigin}, {.pointsAt = particles}),
        property<&Probe::side>           ("side",        "Right side",   "",        Recompile,   "A particle on the right of nose and tail, for roll and angle of attack.", {hasSide}, {.pointsAt = particles}),
        property<&Probe::formula>        ("formula",     "Formula",      "",        Recompile,   "A number made of what other probes read, by their names with _ for blanks: line_tension / weight.", {isFormula}),
        property<&Probe::plotted>        ("plotted",     "Plotted",      "",        DisplayOnly, "Shown in plots that name no probes of their own.", {}),

        property<&Plot::name>            ("name",        "Name",         "",        DisplayOnly, "Shown over the plot.", {}, {.meaning = Name, .traits = {Own}}),
        property<&Plot::axis>            ("axis",        "Against",      "",        DisplayOnly, "What the curves are drawn against: time, what another probe reads, or frequency, as spectra.", {}),
        property<&Plot::against>         ("against",     "Other probe",  "",        DisplayOnly, "Probe whose readings go across when the curves are against a probe.", {isAgainstProbe}, {.pointsAt = probes}),
        property<&Plot::probes>          ("probes",      "Probes",       "",        DisplayOnly, "Probes whose curves it has; empty has all that are plotted.", {}, {.pointsAt = probes}),
        property<&Plot::seconds>         ("seconds",     "In sight",     "s",       DisplayOnly, "How much of the run is in sight, up to now; 0 shows all of it.", {isAgainstTime}, {.range = notNegative}),
        property<&Plot::logarithmic>     ("logarithmic", "Logarithmic",  "",        DisplayOnly, "Values stand on a logarithmic axis; those at or below 0 are left out.", {}),
        property<&Plot::low>             ("low",         "Lowest value", "",        DisplayOnly, "Lower end of the axis of values, in the unit of the curves; empty fits what is in sight.", {}),
        property<&Plot::high>            ("high",        "Highest value", "",       DisplayOnly, "Upper end of the axis of values, in the unit of the curves; empty fits what is in sight.", {}),
    };
    // clang-format on
    return table;
}

std::span<const Property> propertiesOf(Kind kind)
{
    const auto all = allProperties();
    const auto isOther = [&](const Property& p) { return p.kind != kind; };
    const auto first = std::find_if_not(all.begin(), all.end(), isOther);
    return {first, std::find_if(first, all.end(), isOther)};
}

const Property* findProperty(Kind kind, std::string_view key)
{
    for (const Property& property : propertiesOf(kind))
        if (property.key == key)
            return &property;
    return nullptr;
}

const Property* findProperty(Kind kind, Meaning meaning)
{
    for (const Property& property : propertiesOf(kind))
        if (property.meaning == meaning)
            return &property;
    return nullptr;
}

const Property& propertyAt(const MemberPlace& place)
{
    const auto of = propertiesOf(place.kind);
    const auto found =
        std::ranges::find(of, place, [](const Property& property) { return property.place; });
    assert(found != of.end());
    return *found;
}

const Property* ofMaterial(const Property& property)
{
    return property.kind == Kind::Link && property.optional
               ? findProperty(Kind::Material, property.key)
               : nullptr;
}

bool isResettable(const Property& property)
{
    return property.pointsAt.empty() && !property.traits.contains(Trait::Own);
}

bool changesLooks(const Property& property)
{
    return property.effect == Effect::DisplayOnly || property.traits.contains(Trait::Looks);
}

} // namespace ripstop
