// The inside of the viewport: what it shows, and what the mouse is about.
#pragma once

#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "viewport/centre_mark.h"
#include "viewport/chase.h"
#include "viewport/compass.h"
#include "viewport/covered.h"
#include "viewport/gizmo_overlay.h"
#include "viewport/grab_tool.h"
#include "viewport/legend.h"
#include "viewport/pointing.h"
#include "viewport/probe_labels.h"
#include "viewport/range_editor.h"
#include "viewport/stage.h"
#include "viewport/transform_tool.h"
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
        , pointing([this] { return sight(); }, &widget)
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
    Covered covered() const { return coveredOf(*screen.parentWidget()); }
    void sceneReplaced();
    bool sceneChanged(const Edit& edit); // true when it shows in the picture at once
    void showDesign();
    void prepare();
    void place();
    std::optional<Sight> sight(); // what is seen now
    void click(Id id, Qt::KeyboardModifiers keys);
    void fitNow();

    template <typename Change>
    void draw(Change change) // with the change
    {
        change();
        screen.renderSoon();
    }

    Document& document;
    Selection& selection;
    Player& player;
    Turntable camera;
    HandSettings hands;
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
    Chase chase;
    QPointF pressed;
    QPointF last;
    bool dragging = false;
};

} // namespace ripstop
