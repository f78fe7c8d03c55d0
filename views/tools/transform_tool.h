// The tool that moves, turns and scales what is selected, by the handles of a gizmo or by numbers.
//
// It shapes the design, so it acts while the simulation stands at its start: while a run is shown
// it cannot be chosen, and waits if it was, as a key that is pressed by mistake must not end a
// flight. One drag is one step of the history. While it drags: X, Y or Z keep to that axis, digits
// type the amount, Ctrl snaps, Esc and the right button take everything back.
#pragma once

#include "tools/handle_drag.h"

#include <QObject>
#include <QSizeF>
#include <QString>

#include <optional>

class QKeyEvent;
class QMouseEvent;
class QWidget;

namespace ripstop {

class Document;
class Player;
class Selection;

enum class Snap { Grid, Particle };
enum class Axes { World, Own, View }; // that handles and numbers go along

class TransformTool final : public QObject
{
    Q_OBJECT

public:
    // It takes the mouse and the keys of `view` first, and leaves what it does not use.
    TransformTool(Document& document, Selection& selection, Player& player, QWidget& view,
                  const Camera& camera);

    Shaping shaping() const { return m_shaping; }
    void setShaping(Shaping shaping);

    Pivot pivot() const { return m_pivot; }
    void setPivot(Pivot pivot); // Pivot::Particle waits for a click on one
    bool awaitsPivot() const { return m_awaitsPivot; }
    RestLengths restLengths() const { return m_restLengths; }
    void setRestLengths(RestLengths restLengths) { m_restLengths = restLengths; }
    Axes axes() const { return m_axes; }
    void setAxes(Axes axes);
    Snap snap() const { return m_snap; }
    void setSnap(Snap snap) { m_snap = snap; }

    bool isAtDesign() const;      // no run is shown
    void goToDesign();            // where a run is shown; it then says so
    static QString wayToDesign(); // a sentence for who sees a run
    // Whether there is a design to be shaped and something of it is selected; it says what is to be
    // done first.
    bool canBegin();
    bool acts() const; // there are handles to take hold of

    // Numbers of the drag under way, or those that change nothing: m along the axes, degrees about
    // them, factors.
    Vec3 numbers() const;
    void shape(const Vec3& numbers); // as typed: one step of the history
    QString told() const;            // what the drag comes to, in words; empty without one

    bool isDragging() const { return m_drag.has_value(); }
    Handle active() const; // held or under the cursor
    std::optional<Gizmo> gizmo() const;

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void changed(); // anything that the functions above tell
    void said(const QString& message);

private:
    struct Drag
    {
        Movable movable;
        HandleDrag pull;
        int gesture;
        Vec3 numbers; // that the pull comes to now
        bool hasMoved = false;
    };

    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    bool key(const QKeyEvent& event);
    void step(); // takes the design to where the hand is now
    void end();
    void cancel();
    void takePivot(QPointF cursor);
    struct Under
    {
        Id id;
        Vec3 place; // m
    };
    // The particle nearest to the cursor, and none of `without`, which are in ascending order.
    std::optional<Under> particleUnder(QPointF cursor, const std::vector<Id>& without) const;
    Movable movable() const; // what is selected
    CameraProjection projection() const;
    void forget(); // makes gizmo() find the pivot again

    Document& m_document;
    Selection& m_selection;
    Player& m_player;
    QWidget& m_view;
    const Camera& m_camera;

    Shaping m_shaping = Shaping::None;
    Pivot m_pivot = Pivot::Median;
    Id m_pivotParticle = noId;
    bool m_awaitsPivot = false;
    RestLengths m_restLengths = RestLengths::Keep;
    Axes m_axes = Axes::World;
    Snap m_snap = Snap::Grid;
    Handle m_hovered;
    std::optional<Drag> m_drag;
    bool m_spent = false; // the drag is over by a key, and the button still down

    // Of the selection, found when it is asked for; empty where nothing can be moved.
    mutable bool m_known = false;
    mutable std::optional<Vec3> m_place; // m
    mutable Eigen::Matrix3d m_own;
};

} // namespace ripstop
