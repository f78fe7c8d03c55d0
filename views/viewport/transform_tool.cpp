#include "viewport/transform_tool.h"

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

constexpr double degrees = 180.0 / std::numbers::pi;
constexpr double snapAngle = 15.0;     // degrees
constexpr double snapFactor = 0.1;     // 1
constexpr double gridPixels = 12.0;    // a step of the grid is at least this long
constexpr double particleReach = 14.0; // pixels

const char* verbOf(Shaping shaping)
{
    switch (shaping) {
    case Shaping::Move:
        return "Move";
    case Shaping::Turn:
        return "Turn";
    case Shaping::Scale:
        return "Scale";
    case Shaping::None:
        break;
    }
    return "";
}

double rounded(double value, double step) { return step * std::round(value / step); }

} // namespace

TransformTool::TransformTool(Document& document, Selection& selection, Player& player,
                             QWidget& view, const Turntable& camera)
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
    if (shaping != Shaping::None)
        goToDesign();
    emit changed();
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

bool TransformTool::isAtDesign() const
{
    return !m_player.isPlaying() && (!m_player.frame() || m_player.frame()->step == 0);
}

bool TransformTool::acts() const { return gizmo().has_value(); }

Lens TransformTool::lens() const
{
    return {m_camera, double(m_view.width()), double(m_view.height())};
}

void TransformTool::forget() { m_known = false; }

std::optional<Gizmo> TransformTool::gizmo() const
{
    if (m_shaping == Shaping::None || (!m_drag && !isAtDesign()))
        return std::nullopt;
    if (m_drag) {
        Gizmo now = m_drag->gizmo;
        now.lens = lens();
        if (m_shaping == Shaping::Move)
            now.pivot += now.axes * dragNumbers();
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
    Gizmo gizmo{m_shaping, *m_place, lens()};
    if (m_axes == Axes::Own)
        gizmo.axes = m_own;
    else if (m_axes == Axes::View)
        gizmo.axes << m_camera.right(), m_camera.up(), m_camera.back();
    return gizmo;
}

// Links only matter where they are bound anew.
Movable TransformTool::movable() const
{
    return movableOf(m_document.scene(), m_selection.ids(),
                     m_restLengths == RestLengths::Rebind ? Ties::Found : Ties::Left);
}

Handle TransformTool::active() const { return m_drag ? m_drag->handle : m_hovered; }

// --- what a drag comes to ----------------------------------------------------------------------

std::optional<double> TransformTool::typedNumber() const
{
    bool isNumber = false;
    const double number = QString(m_drag->typed).replace(',', '.').toDouble(&isNumber);
    return isNumber ? std::optional(number) : std::nullopt;
}

std::optional<TransformTool::Under>
TransformTool::particleUnder(QPointF cursor, const std::vector<Id>& without) const
{
    std::optional<Under> found;
    double nearest = particleReach;
    const Lens lens = this->lens();
    forEachPart(m_document.scene(), [&](Id, const Part& part) {
        for (const Particle& row : part.particles) {
            const auto pixel = lens.pixel(row.position);
            if (!pixel)
                continue;
            const double distance = std::hypot(pixel->x() - cursor.x(), pixel->y() - cursor.y());
            if (distance < nearest && !std::binary_search(without.begin(), without.end(), row.id)) {
                nearest = distance;
                found = Under{row.id, row.position};
            }
        }
    });
    return found;
}

Vec3 TransformTool::dragShift() const
{
    const Drag& drag = *m_drag;
    const Gizmo& start = drag.gizmo;
    Vec3 way = start.axes.transpose() * start.shift(drag.handle, drag.from, drag.to);
    if (!drag.snaps)
        return way;
    if (m_snap == Snap::Particle) {
        if (const auto goal = particleUnder(drag.to, drag.movable.particles))
            way = start.axes.transpose() * (goal->place - start.pivot);
    } else {
        // a step of 1, 2 or 5 times a power of ten; along the axes of the world, places are round
        const double least = gridPixels * lens().metresPerPixel(start.pivot);
        const double decade = std::pow(10.0, std::floor(std::log10(least)));
        const double ratio = least / decade;
        const double grid = decade * (ratio > 5.0 ? 10.0 : ratio > 2.0 ? 5.0 : 2.0);
        const Vec3 zero = m_axes == Axes::World ? start.pivot : Vec3(Vec3::Zero());
        for (int axis = 0; axis < 3; ++axis)
            way[axis] = rounded(zero[axis] + way[axis], grid) - zero[axis];
    }
    for (int axis = 0; axis < 3; ++axis)
        if (!drag.handle.axes()[std::size_t(axis)])
            way[axis] = 0.0;
    return way;
}

Vec3 TransformTool::dragNumbers() const
{
    const Drag& drag = *m_drag;
    const auto typed = typedNumber();
    const int axis = drag.handle.axis;
    if (m_shaping == Shaping::Move) {
        if (!typed)
            return dragShift();
        Vec3 shift = Vec3::Zero();
        shift[drag.handle.sort == Handle::Sort::Axis ? axis : 0] = *typed;
        return shift;
    }
    if (m_shaping == Shaping::Turn) {
        const double turned = degrees * drag.angle;
        Vec3 angles = Vec3::Zero();
        angles[axis] = typed ? *typed : drag.snaps ? rounded(turned, snapAngle) : turned;
        return angles;
    }
    Vec3 factors = drag.gizmo.factors(drag.handle, drag.from, drag.to);
    for (int i = 0; i < 3; ++i)
        if (drag.handle.axes()[std::size_t(i)]) {
            if (drag.snaps)
                factors[i] = std::max(rounded(factors[i], snapFactor), snapFactor);
            if (typed && *typed > 0.0)
                factors[i] = *typed;
        }
    return factors;
}

Vec3 TransformTool::numbers() const
{
    if (!m_drag)
        return m_shaping == Shaping::Scale ? Vec3(Vec3::Ones()) : Vec3(Vec3::Zero());
    const bool ofAxis = m_drag->handle.sort == Handle::Sort::Axis;
    return m_shaping == Shaping::Turn && !ofAxis ? Vec3(Vec3::Zero()) : dragNumbers();
}

QString TransformTool::told() const
{
    if (!m_drag)
        return {};
    const Vec3 n = dragNumbers();
    const auto text = [](double value, int digits) {
        return QString::number(value, 'f', digits).replace('-', QChar(0x2212));
    };
    QStringList words;
    const std::array<bool, 3> changed = m_drag->handle.axes();
    if (m_shaping == Shaping::Turn)
        words << tr("%1\u00b0").arg(text(n[m_drag->handle.axis], 1));
    else
        for (int i = 0; i < 3; ++i)
            if (changed[std::size_t(i)])
                words << (m_shaping == Shaping::Move ? tr("%1 %2 m") : tr("%1 \u00d7%2"))
                             .arg(QChar('x' + i), text(n[i], 3));
    if (m_shaping == Shaping::Scale && m_drag->handle.sort == Handle::Sort::Free)
        words = {tr("\u00d7%1").arg(text(n[0], 3))};
    QString told = words.join(QStringLiteral("   "));
    if (!m_drag->typed.isEmpty())
        told += tr("   typed: %1").arg(m_drag->typed);
    return told;
}

Motion TransformTool::motionOf(const Vec3& numbers, const Gizmo& handles) const
{
    if (m_shaping == Shaping::Move)
        return shifted(handles.axes * numbers);
    if (m_shaping == Shaping::Scale)
        return scaled(handles.pivot, numbers, handles.axes);
    Motion motion;
    for (int axis = 0; axis < 3; ++axis)
        motion.map =
            turned(handles.pivot, handles.axes.col(axis), numbers[axis] / degrees).map * motion.map;
    return motion;
}

void TransformTool::shape(const Vec3& numbers)
{
    const auto handles = gizmo();
    if (m_drag || !handles)
        return;
    const Vec3 idle = m_shaping == Shaping::Scale ? Vec3(Vec3::Ones()) : Vec3(Vec3::Zero());
    if (numbers == idle || (m_shaping == Shaping::Scale && numbers.minCoeff() <= 0.0))
        return;
    const Movable all = movable();
    m_document.push(moved(all, motionOf(numbers, *handles), m_restLengths,
                          movingLabel(verbOf(m_shaping), all)));
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
    m_drag = Drag{movable(), *handles, handle, event.position(), event.position()};
    m_drag->lastAngle = handles->angle(handle, event.position());
    m_drag->gesture = m_document.beginGesture();
    emit changed();
    return true;
}

bool TransformTool::move(const QMouseEvent& event)
{
    if (m_drag) {
        m_drag->to = event.position();
        m_drag->snaps = event.modifiers().testFlag(Qt::ControlModifier);
        const double angle = m_drag->gizmo.angle(m_drag->handle, event.position());
        m_drag->angle += std::remainder(angle - m_drag->lastAngle, 2.0 * std::numbers::pi);
        m_drag->lastAngle = angle;
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
        return std::exchange(m_spent, false); // not a click
    end();
    m_spent = false;
    return true;
}

void TransformTool::step()
{
    const Vec3 numbers = dragNumbers();
    const bool ofSight = m_shaping == Shaping::Turn && m_drag->handle.sort == Handle::Sort::Free;
    const Gizmo& start = m_drag->gizmo;
    const Motion motion = ofSight ? turned(start.pivot, start.turningAxis(m_drag->handle),
                                           numbers[m_drag->handle.axis] / degrees)
                                  : motionOf(numbers, start);
    m_drag->hasMoved = true;
    m_document.drag(moved(m_drag->movable, motion, m_restLengths,
                          movingLabel(verbOf(m_shaping), m_drag->movable)),
                    m_drag->gesture);
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

void TransformTool::keepTo(int axis)
{
    const Handle wanted{Handle::Sort::Axis, axis};
    const bool again = m_drag->handle == wanted;
    m_drag->handle = again ? Handle{Handle::Sort::Free, 0} : wanted;
    m_drag->angle = 0.0;
    m_drag->from = m_shaping == Shaping::Turn ? m_drag->to : m_drag->from;
    m_drag->lastAngle = m_drag->gizmo.angle(m_drag->handle, m_drag->to);
    step();
}

bool TransformTool::key(const QKeyEvent& event)
{
    if (!m_drag) {
        if (event.key() != Qt::Key_Escape || m_shaping == Shaping::None)
            return false;
        setShaping(Shaping::None);
        return true;
    }
    QString& typed = m_drag->typed;
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
        keepTo(event.key() - Qt::Key_X);
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
        if (typedNumber())
            step();
        else
            emit changed();
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
        // accepted, the key comes as a press and not as a shortcut
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
