// The 3D view.
//
// Left drag turns it, middle or Shift + left drag moves it, the wheel moves in towards the cursor.
// Ctrl + left drag takes hold of things (grab_tool.h): it steers what controls move, carries
// colliders and pulls at all else.
// A right click selects what is under it, unless that is selected, and asks for a menu.
// A click selects the particle, link, panel or collider under the cursor; with Shift it adds to the
// selection, with Ctrl it takes away. A tool (tool.h) takes the left button for itself; the view
// then turns by right drag.
#pragma once

#include "camera/camera.h"
#include "look/backdrop.h"
#include "look/quantity_values.h"
#include "look/steady_range.h"
#include "look/theme.h"
#include "look/vectors.h"
#include "scene/id.h"

#include <QImage>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace ripstop {

struct Brush;
class Document;
struct GhostFrame; // document/recordings.h
struct HandSettings;
class Legend;
class Player;
class Pointing;
class Selection;
class TransformTool;

class Viewport final : public QWidget
{
    Q_OBJECT

public:
    Viewport(Document& document, Selection& selection, Player& player, QWidget* parent = nullptr);
    ~Viewport() override;

    // Shows what another view shows, from where it looks, with the same hands and brush. What the
    // menus choose comes with them.
    void takeOver(const Viewport& before);

    // Shows this instant until the next one; the player's frames come by themselves.
    void show(std::shared_ptr<const Frame> frame);
    using QWidget::show;
    void showGhosts(const std::vector<GhostFrame>& ghosts); // other runs over this one
    const std::shared_ptr<const Frame>& frame() const;      // null before the first

    ColorBy colorBy() const;
    void setColorBy(ColorBy colorBy);

    // In the unit of the quantity (strain: 1). Without one the range follows the values.
    void setFixedRange(std::optional<ValueRange> range); // of the quantity that is shown
    void setRangeToPeak(bool toPeak);                    // else 2 % may lie beyond; off at first
    void editRange();                                    // asks for a range, beside the legend
    ValueRange range() const;                            // what the colours mean now
    const Legend& legend() const;

    void setPanelsShown(bool shown);
    void setLinksShown(bool shown);
    void setParticlesShown(bool shown);
    void setPeopleShown(bool shown); // who holds and who hangs; on at first
    void setWindShown(bool shown);
    void setWindFieldShown(bool shown);  // as arrows, off at first
    void setStreaksShown(bool shown);    // that drift with the wind; on at first
    void setMotionReduced(bool reduced); // nothing moves but what is simulated; off at first
    void setCentreShown(bool shown);     // of gravity, off at first
    void setVectors(Vectors vectors);    // arrows on the elements; none at first
    void setDesignShown(bool shown);     // as a ghost; off at first
    void setTrailsShown(bool shown);     // of selected or probed particles; off at first
    void setGrainShown(bool shown);      // of panels that carry a pull, as strokes; off at first
    void setMeshShown(bool shown);       // links that stand for fabric, on it; off at first
    void setProbesShown(bool shown);     // what they read, beside what they look at; off at first

    // A scene that is opened shows its fabric and what that carries; this shows everything.
    void fit();
    // These elements or items; everything when there are none. They fit beside what covers the
    // right of the view, as a dialog does, in pixels of the screen.
    void fit(const std::vector<Id>& ids, const QRect& covered = {});
    void centre(const std::vector<Id>& ids); // from as far as it is seen now
    void centreAt(const Vec3& place);        // m, likewise
    void look(const Camera& camera);         // shows the view as from there again
    void view(PresetView preset);
    void setFollow(bool follow); // the camera goes with the fabric; on at first
    void setOrthographic(bool orthographic);
    const Camera& camera() const;

    // The viewport also chooses a theme by itself whenever the palette changes.
    void setTheme(const Theme& theme);

    // The view as it is now, in device pixels; with all that lies over it, if wanted.
    enum class Overlays { With, Without };
    QImage image(Overlays overlays = Overlays::With);

    // The view in another size, in pixels, without the marks of what is selected; of what lies over
    // it only legend and compass, as large as they are in the view.
    enum class Pins { With, Without }; // the marks of particles that are fixed or guided
    struct Shot
    {
        QSize size;
        Overlays overlays = Overlays::With;
        Backdrop backdrop = Backdrop::Scenery;
        Pins pins = Pins::With;
    };
    QImage image(const Shot& shot);
    void paintOverlays(QPainter& painter, QSize picture); // those of such a shot

    TransformTool& transformTool();
    HandSettings& hands(); // how hard hands pull and blow
    Brush& brush();        // what it paints, and how wide

    Id pick(QPointF place); // noId when nothing is there
    Pointing& pointing();   // the tool in use, and what the mouse is on

signals:
    void cameraChanged();
    void colorByChanged();                // whoever chose it
    void menuWanted(const QPoint& place); // of the screen; for what is selected by then

protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace ripstop
