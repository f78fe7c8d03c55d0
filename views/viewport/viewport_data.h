// The inside of the viewport: what it shows, and what the mouse is about.
//
// Only viewport.cpp and viewport_input.cpp include it, so that users of the viewport see neither
// VTK nor the overlays. Members are made in the order of their declaration: the screen with its
// render window before the stage that draws into it, and the overlays after what they lie over.
#pragma once

#include "camera/chase.h"
#include "camera/overlay_margins.h"
#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "overlays/centre_mark.h"
#include "overlays/compass.h"
#include "overlays/legend.h"
#include "overlays/probe_labels.h"
#include "overlays/range_editor.h"
#include "tools/brush_tool.h"
#include "tools/gizmo_overlay.h"
#include "tools/grab_tool.h"
#include "tools/pointing.h"
#include "tools/transform_tool.h"
#include "viewport/stage.h"
#include "viewport/viewport.h"
#include "viewport/vtk_widget.h"

#include <optional>

namespace ripstop {

class Viewport::Private
{
public:
    Private(Viewport& widget, Document& openDocument, Selection& openSelection, Player& openPlayer)
        : document(openDocument)
        , selection(openSelection)
        , player(openPlayer)
        , screen(&widget)
        , stage(screen.window())
        , pointing([this] { return view(); }, &widget)
        , legend(&widget)
        , rangeEditor(legend, &widget)
        , compass(&widget)
        , transform(openDocument, openSelection, openPlayer, widget, camera)
        , centre(openDocument, openSelection, &widget)
        , labels(openDocument, &widget)
        , gizmo(transform, &widget)
    {
        camera.look(PresetView::Iso);
        pointing.setCtrlTool(std::make_unique<GrabTool>(document, player, hands,
                                                        [this] { return pointing.pickable; }));
    }

    double aspect() const
    {
        return screen.height() > 0 ? double(screen.width()) / screen.height() : 1.0;
    }
    OverlayMargins overlayMargins() const { return overlayMarginsOf(*screen.parentWidget()); }
    void sceneReplaced();
    bool sceneChanged(const Edit& edit); // true when it shows in the picture at once
    void showDesign();
    void prepare();
    void place();
    int aboveBars(const QRect& place) const; // its upper edge, px
    std::optional<CameraView> view();        // what is seen now
    void click(Id id, Qt::KeyboardModifiers keys);
    void fitNow();
    bool seesSubject(); // some of the design is in the picture
    bool sees(const Vec3& point) const;
    void keepWhole();
    bool lookAtGhosts(const std::vector<GhostFrame>& ghosts);

    template <typename Change>
    void draw(Change change) // makes the change and asks for a picture
    {
        change();
        screen.renderSoon();
    }

    Document& document;
    Selection& selection;
    Player& player;
    Camera camera;
    HandSettings hands;
    Brush brush;
    VtkWidget screen;
    Stage stage;
    Pointing pointing;
    Legend legend;
    RangeEditor rangeEditor;
    Compass compass;
    TransformTool transform;
    CentreMark centre;
    ProbeLabels labels;
    GizmoOverlay gizmo;

    std::optional<double> shotRatio; // pixels for one of the view, while a picture is taken
    bool untouched = true;           // the camera still shows all it should, as nobody has moved it
    bool wholeScene = false;         // should show: everything, or the fabric and what it carries
    double fittedFrom = 0.0;         // m, the distance of the camera when everything was fitted
    Chase chase;

    // Ghosts that stand beside are to be seen whole; when they go, so does the camera.
    struct Before
    {
        Camera camera;
        bool untouched;
        std::optional<Vec3> middle; // of the fabric, of a camera that follows it
    };
    std::optional<Before> beforeGhosts;
    std::vector<Vec3> ghostShifts; // m, empty: none stands beside
    std::vector<Vec3> ghostPoints; // m, of those
    QPointF pressed;
    QPointF last;
    bool dragging = false;
};

} // namespace ripstop
