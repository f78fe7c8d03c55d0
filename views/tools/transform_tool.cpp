// The tool watches the events of the view: press() takes hold of a handle and begins a gesture,
// move() steps it, release() ends it; keys keep to an axis, type numbers or take everything back.
// step() makes an edit from the state at the press each time, so that a drag is one step of the
// history and adds up no rounding.
//
// gizmo() says where the handles are: on the pivot of what is selected, or where a drag has brought
// them. The pivot is found when it is asked for and forgotten when document, selection, kind of
// pivot or state of the player change.
//
// shape() makes the same edit from numbers that are typed.
#include "tools/transform_tool.h"

#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "document/words.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWidget>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ripstop {
namespace {

constexpr double pivotReach = 14.0; // pixels

Message labelOf(Shaping shaping)
{
    switch (shaping) {
    case Shaping::Move:
        return Message("Move %1");
    case Shaping::Turn:
        return Message("Rotate %1");
    case Shaping::Scale:
        return Message("Scale %1");
    case Shaping::None:
        break;
    }
    return Message("%1");
}

} // namespace

TransformTool::TransformTool(Document& document, Selection& selection, Player& player,
                             QWidget& view, const Camera& camera)
    : QObject(&view)
    , m_document(document)
    , m_selection(selection)
    , m_player(player)
    , m_view(view)
    , m_camera(camera)
{
    view.installEventFilter(this);
    const auto renew = [this] {
        forget();
        emit changed();
    };
    connect(&selection, &Selection::changed, this, renew);
    connect(&document, &Document::changed, this, renew);
    connect(&document, &Document::replaced, this, [this, renew] {
        m_drag.reset();
        renew();
    });
    connect(&player, &Player::stateChanged, this, renew);
    connect(&player, &Player::frameReady, this, [this, was = true]() mutable {
        if (std::exchange(was, isAtDesign()) != isAtDesign())
            emit changed();
    });
}

void TransformTool::setShaping(Shaping shaping)
{
    if (m_drag)
        cancel();
    m_shaping = shaping;
    m_hovered = {};
    emit changed();
}

QString TransformTool::wayToDesign()
{
    return tr("A run is shown. Reset (Ctrl+R) goes back to the design.");
}

bool TransformTool::canBegin()
{
    const bool isAny = !m_selection.ids().empty();
    if (isAtDesign() && isAny)
        return true;
    emit said(!isAtDesign() ? wayToDesign()
                            : tr("Select something first: in the view, in the outline or with the "
                                 "menu Select."));
    emit changed(); // the toggle that was pressed is off
    return false;
}

void TransformTool::goToDesign()
{
    if (isAtDesign())
        return;
    m_player.reset();
    emit said(tr("The simulation is back at its start, where the design is shaped."));
}

void TransformTool::setPivot(Pivot pivot)
{
    m_pivot = pivot;
    m_awaitsPivot = pivot == Pivot::Particle;
    if (m_awaitsPivot) {
        m_pivotParticle = noId;
        emit said(tr("Click the particle that is to stay where it is."));
    }
    forget();
    emit changed();
}

void TransformTool::takePivot(QPointF cursor)
{
    const auto under = particleUnder(cursor, {});
    if (!under)
        return emit said(tr("There is no particle here. Click the one that is to stay."));
    m_pivotParticle = under->id;
    m_awaitsPivot = false;
    m_spent = true;
    forget();
    emit changed();
}

void TransformTool::setAxes(Axes axes)
{
    m_axes = axes;
    emit changed();
}

// A design that cannot run sends no frames; the view then shows it as it is.
bool TransformTool::isAtDesign() const
{
    const auto& frame = m_player.frame();
    return !m_player.isPlaying() && (!frame || !frame->underWay || !m_player.problem().isEmpty());
}

bool TransformTool::acts() const { return gizmo().has_value(); }

CameraProjection TransformTool::projection() const
{
    return {m_camera, double(m_view.width()), double(m_view.height())};
}

void TransformTool::forget() { m_known = false; }

std::optional<Gizmo> TransformTool::gizmo() const
{
    if (m_shaping == Shaping::None || (!m_drag && !isAtDesign()))
        return std::nullopt;
    if (m_drag) {
        Gizmo now = m_drag->pull.start;
        now.projection = projection();
        if (m_shaping == Shaping::Move)
            now.pivot += now.axes * m_drag->numbers;
        return now;
    }
    if (!m_known) {
        const Movable movable = movableOf(m_document.scene(), m_selection.ids(), Ties::Left);
        m_place.reset();
        if (!movable.isEmpty())
            m_place = pivotOf(m_document.scene(), movable, m_pivot, m_pivotParticle);
        m_own = ownAxes(movable);
        m_known = true;
    }
    if (!m_place)
        return std::nullopt;
    Gizmo gizmo{m_shaping, *m_place, projection()};
    if (m_axes == Axes::Own)
        gizmo.axes = m_own;
    else if (m_axes == Axes::View)
        gizmo.axes << m_camera.right(), m_camera.up(), m_camera.back();
    return gizmo;
}

// What is selected, as it can be moved. Links only matter where they are bound anew.
Movable TransformTool::movable() const
{
    return movableOf(m_document.scene(), m_selection.ids(),
                     m_restLengths == RestLengths::Rebind ? Ties::Found : Ties::Left);
}

Handle TransformTool::active() const { return m_drag ? m_drag->pull.handle : m_hovered; }

// --- numbers ----------------------------------------------------------------------

std::optional<TransformTool::Under>
TransformTool::particleUnder(QPointF cursor, const std::vector<Id>& without) const
{
    std::optional<Under> found;
    double nearest = pivotReach;
    const CameraProjection projection(m_camera, m_view.width(), m_view.height());
    forEachPart(m_document.scene(), [&](Id, const Part& part) {
        for (const Particle& row : part.particles) {
            const OnScreen seen = projection(row.position);
            if (!seen.isSeen())
                continue;
            const double distance = std::hypot(seen.x - cursor.x(), seen.y - cursor.y());
            if (distance < nearest && !std::binary_search(without.begin(), without.end(), row.id)) {
                nearest = distance;
                found = Under{row.id, row.position};
            }
        }
    });
    return found;
}

Vec3 TransformTool::numbers() const
{
    return m_drag && !m_drag->pull.isAboutSight() ? m_drag->numbers : idleNumbers(m_shaping);
}

QString TransformTool::told() const
{
    return m_drag ? m_drag->pull.told(m_drag->numbers) : QString();
}

void TransformTool::shape(const Vec3& numbers)
{
    const auto handles = gizmo();
    if (m_drag || !handles)
        return;
    if (numbers == idleNumbers(m_shaping)
        || (m_shaping == Shaping::Scale && numbers.minCoeff() <= 0.0))
        return;
    const Movable all = movable();
    m_document.push(moved(all, motionOf(*handles, numbers), m_restLengths,
                          movingLabel(labelOf(m_shaping), all)));
}

// --- the hand ----------------------------------------------------------------------------------

bool TransformTool::press(const QMouseEvent& event)
{
    if (m_drag) {
        if (event.button() == Qt::RightButton)
            cancel();
        return true;
    }
    m_spent = false;
    if (m_awaitsPivot && acts() && event.button() == Qt::LeftButton) {
        takePivot(event.position());
        return true;
    }
    const auto handles = gizmo();
    const Handle handle = handles ? handles->at(event.position()) : Handle{};
    if (!handle || event.button() != Qt::LeftButton)
        return false;
    m_drag = Drag{movable(), HandleDrag::at(*handles, handle, event.position()),
                  m_document.beginGesture(), idleNumbers(m_shaping)};
    m_drag->pull.placesAreRound = m_axes == Axes::World;
    emit changed();
    return true;
}

bool TransformTool::move(const QMouseEvent& event)
{
    if (m_drag) {
        m_drag->pull.snaps = event.modifiers().testFlag(Qt::ControlModifier);
        m_drag->pull.follow(event.position());
        step();
        return true;
    }
    if (event.buttons() != Qt::NoButton)
        return m_spent;
    m_spent = false;
    const auto handles = gizmo();
    const Handle under = handles ? handles->at(event.position()) : Handle{};
    if (under != m_hovered) {
        m_hovered = under;
        under ? m_view.setCursor(Qt::SizeAllCursor) : m_view.unsetCursor();
        emit changed();
    }
    return bool(under);
}

bool TransformTool::release(const QMouseEvent& event)
{
    if (event.button() != Qt::LeftButton)
        return m_drag.has_value();
    if (!m_drag)
        return std::exchange(m_spent, false); // it was not a click
    end();
    m_spent = false;
    return true;
}

void TransformTool::step()
{
    Drag& drag = *m_drag;
    std::optional<Vec3> goal;
    if (m_shaping == Shaping::Move && drag.pull.snaps && m_snap == Snap::Particle)
        if (const auto under = particleUnder(drag.pull.to, drag.movable.particles))
            goal = under->place;
    drag.numbers = drag.pull.numbers(goal);
    drag.hasMoved = true;
    m_document.drag(moved(drag.movable, drag.pull.motion(drag.numbers), m_restLengths,
                          movingLabel(labelOf(m_shaping), drag.movable)),
                    drag.gesture);
    emit changed();
}

void TransformTool::end()
{
    m_drag.reset();
    m_spent = true;
    forget();
    emit changed();
}

void TransformTool::cancel()
{
    if (m_drag->hasMoved)
        m_document.cancel(m_drag->gesture);
    end();
}

// --- keys --------------------------------------------------------------------------------------

bool TransformTool::key(const QKeyEvent& event)
{
    if (!m_drag) {
        if (event.key() != Qt::Key_Escape || m_shaping == Shaping::None)
            return false;
        setShaping(Shaping::None);
        return true;
    }
    QString& typed = m_drag->pull.typed;
    const QString text = event.text();
    switch (event.key()) {
    case Qt::Key_Escape:
        cancel();
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        end();
        return true;
    case Qt::Key_X:
    case Qt::Key_Y:
    case Qt::Key_Z:
        m_drag->pull.keepTo(event.key() - Qt::Key_X);
        step();
        return true;
    case Qt::Key_Backspace:
        typed.chop(1);
        step();
        return true;
    default:
        break;
    }
    if (text.size() == 1 && (text.at(0).isDigit() || QStringLiteral(".,-").contains(text))) {
        typed += text;
        step();
    }
    return true; // a shortcut in the middle of a drag would cut its ground away
}

bool TransformTool::eventFilter(QObject* watched, QEvent* event)
{
    bool used = false;
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
        used = press(*static_cast<QMouseEvent*>(event));
        break;
    case QEvent::MouseMove:
        used = move(*static_cast<QMouseEvent*>(event));
        break;
    case QEvent::MouseButtonRelease:
        used = release(*static_cast<QMouseEvent*>(event));
        break;
    case QEvent::ShortcutOverride: {
        // A key that is accepted here comes as a press and not as a shortcut.
        const bool escape = static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
        if (m_drag || (escape && m_shaping != Shaping::None))
            event->accept();
        return m_drag.has_value();
    }
    case QEvent::KeyPress:
        used = key(*static_cast<QKeyEvent*>(event));
        break;
    default:
        break;
    }
    return used || QObject::eventFilter(watched, event);
}

} // namespace ripstop
