// The table, and the walk from a widget upwards until a row is found.
#include "manual/manual_pages.h"

#include <QWidget>

#include <array>

namespace ripstop {
namespace {

constexpr auto ofProperty = "property ";

constexpr const char* properties = "resources/help/properties";

// clang-format off
constexpr std::array table{
    // docks and bars
    ManualRow{"outline",   "docs/editor",    "five-minutes"},
    ManualRow{"history",   "docs/editor",    "five-minutes"},
    ManualRow{"inspector", "docs/tuning",    "the-inspector"},
    ManualRow{"tuning",    "docs/tuning",    "sliders"},
    ManualRow{"plots",     "docs/measuring", "plots"},
    ManualRow{"controls",  "docs/by-hand",   "gamepad"},
    ManualRow{"problems",  "docs/tuning",    "before-the-start"},
    ManualRow{"loads",     "docs/measuring", "how-near-it-is-to-breaking"},
    ManualRow{"table",     "docs/tuning",    "the-table"},
    ManualRow{"study",     "docs/studies",   "in-the-window"},
    ManualRow{"timeline",  "docs/recordings", ""},
    ManualRow{"main",      "docs/editor",    "five-minutes"},
    // the view, what stands over it, and the start page
    ManualRow{"Viewport",     "docs/selecting", "in-the-3d-view"},
    ManualRow{"Transport",    "docs/choosing-a-solver", "how-you-know-that-a-run-is-true"},
    ManualRow{"HandBar",      "docs/by-hand",   "how-strong"},
    ManualRow{"BrushBar",     "docs/tuning",    "worn-and-reinforced-places"},
    ManualRow{"DrawBar",      "docs/drawing",   "by-clicks"},
    ManualRow{"TransformBar", "docs/editor",    "shape-a-design"},
    ManualRow{"StartPage",    "docs/editor",    "five-minutes"},
    // dialogs
    ManualRow{"BuilderDialog",          "docs/building",  "the-dialog"},
    ManualRow{"CertifyDialog",          "docs/choosing-a-solver", "which-digits-hold"},
    ManualRow{"ConditionDialog",        "docs/selecting", "by-property-ctrlshiftf"},
    ManualRow{"DesignDifferenceDialog", "docs/command-line", "what-two-designs-differ-in"},
    ManualRow{"DifferenceDialog",       "docs/flight-to-figure", "look-back-and-compare"},
    ManualRow{"ExportDialog",           "docs/exporting", ""},
    ManualRow{"PictureDialog",          "docs/exporting", "pictures-for-papers"},
    ManualRow{"ImportDialog",           "docs/importing", ""},
    ManualRow{"KeysDialog",             "docs/editor",    "five-minutes"},
    ManualRow{"MapDialog",              "docs/tuning",    "maps"},
    ManualRow{"MaterialTestDialog",     "docs/materials", "material-from-a-test"},
    ManualRow{"OperationDialog",        "docs/editor",    "shape-a-design"},
    ManualRow{"OwnMaterialDialog",      "docs/materials", "own-materials"},
    ManualRow{"Palette",                "docs/editor",    "five-minutes"},
    ManualRow{"PolarDialog",            "docs/air",       ""},
    ManualRow{"PoseDialog",             "docs/by-hand",   "adopt-the-pose"},
    ManualRow{"PreferencesDialog",      "docs/editor",    "five-minutes"},
    ManualRow{"RescueDialog",           "docs/promises",  "files-appear-whole-or-not-at-all"},
    ManualRow{"RigidityDialog",         "docs/drawing",   "what-gives-way"},
    ManualRow{"SettleDialog",           "docs/by-hand",   "settle"},
    ManualRow{"VerificationDialog",     "docs/physics",   ""},
    // kinds of things
    ManualRow{"property settings", properties, "settings"},
    ManualRow{"property particle", properties, "particle"},
    ManualRow{"property link",     properties, "link"},
    ManualRow{"property panel",    properties, "panel"},
    ManualRow{"property part",     properties, "part"},
    ManualRow{"property material", properties, "material"},
    ManualRow{"property group",    properties, "group"},
    ManualRow{"property collider", properties, "collider"},
    ManualRow{"property wind",     properties, "wind"},
    ManualRow{"property control",  properties, "control"},
    ManualRow{"property probe",    properties, "probe"},
    ManualRow{"property plot",     properties, "plot"},
    // properties that have more to be said of them
    ManualRow{"property settings.solver",        "docs/choosing-a-solver", "what-the-automatic-solver-does"},
    ManualRow{"property settings.accuracy",      "docs/choosing-a-solver", "how-you-know-that-a-run-is-true"},
    ManualRow{"property settings.integrator",    "docs/choosing-a-solver", "how-long-a-swing-lasts"},
    ManualRow{"property settings.tearMesh",      "docs/tearing",   "the-mesh-splits"},
    ManualRow{"property settings.tearsPerStep",  "docs/tearing",   "how-many-at-once"},
    ManualRow{"property settings.safetyFactor",  "docs/measuring", "how-near-it-is-to-breaking"},
    ManualRow{"property particle.pinned",        "docs/shaping",   "what-holds-a-particle"},
    ManualRow{"property particle.guide",         "docs/shaping",   "what-holds-a-particle"},
    ManualRow{"property link.tearLimit",         "docs/tearing",   "when-a-link-breaks"},
    ManualRow{"property panel.strengthFactor",   "docs/tuning",    "worn-and-reinforced-places"},
    ManualRow{"property panel.stiffnessFactor",  "docs/tuning",    "worn-and-reinforced-places"},
    ManualRow{"property panel.grain",            "docs/materials", "elastic-panels"},
    ManualRow{"property link.strengthFactor",    "docs/tuning",    "worn-and-reinforced-places"},
    ManualRow{"property link.stiffnessFactor",   "docs/tuning",    "worn-and-reinforced-places"},
    ManualRow{"property part.carrier",           "docs/materials", "elastic-panels"},
    ManualRow{"property part.selfContact",       "docs/contact",   "fabric-against-fabric"},
    ManualRow{"property part.canopyPressure",    "docs/air",       "air-in-a-canopy"},
    ManualRow{"property material.membraneStiffness", "docs/materials", "a-woven-sheet"},
    ManualRow{"property material.shearStiffness",    "docs/materials", "a-woven-sheet"},
    ManualRow{"property material.bendingStiffness",  "docs/materials", "bending"},
    ManualRow{"property material.dampingTime",   "docs/materials", "damping"},
    ManualRow{"property material.arealDensity",  "docs/materials", "weight"},
    ManualRow{"property material.linearDensity", "docs/materials", "weight"},
    ManualRow{"property material.tearRule",      "docs/tearing",   "when-a-link-breaks"},
    ManualRow{"property material.tearStrength",  "docs/tearing",   "tears-that-go-on"},
    ManualRow{"property material.breakingMoment", "docs/tearing",  "when-a-spar-snaps"},
    ManualRow{"property material.airLaw",        "docs/air",       ""},
    ManualRow{"property material.polar",         "docs/air",       "lift-and-drag-by-table"},
    ManualRow{"property material.stallAngle",    "docs/air",       "vortex"},
    ManualRow{"property material.skinFriction",  "docs/air",       "skin-friction"},
    ManualRow{"property material.porosity",      "docs/air",       "porosity"},
    ManualRow{"property material.dragCoefficient", "docs/air",     "lines"},
    ManualRow{"property collider.shape",         "docs/contact",   "shapes"},
    ManualRow{"property collider.path",          "docs/contact",   "colliders-that-move"},
    ManualRow{"property wind.kind",              "docs/air",       "wind"},
    ManualRow{"property probe.formula",          "docs/measuring", "formulas"},
    ManualRow{"property probe.quantity",         "docs/measuring", "all-quantities"},
};
// clang-format on

const ManualRow* rowOf(const QString& name)
{
    for (const ManualRow& row : table)
        if (name == QLatin1String(row.of))
            return &row;
    return nullptr;
}

const ManualRow* rowOf(const QWidget& widget)
{
    const QString name = widget.objectName();
    if (const ManualRow* row = rowOf(name))
        return row;
    if (name.startsWith(QLatin1String(ofProperty))) // a key of its own or the kind's
        return rowOf(name.section('.', 0, 0));
    return rowOf(QString(QLatin1String(widget.metaObject()->className())).section("::", -1));
}

ManualPage pageOf(const ManualRow& row)
{
    return {QLatin1String(row.page), QLatin1String(row.anchor)};
}

} // namespace

std::span<const ManualRow> manualTable() { return table; }

ManualPage firstManualPage() { return {QStringLiteral("docs/editor"), {}}; }

ManualPage manualPageFor(const QWidget* widget)
{
    for (; widget; widget = widget->parentWidget())
        if (const ManualRow* row = rowOf(*widget))
            return pageOf(*row);
    return firstManualPage();
}

} // namespace ripstop
