// Frames and scene: a frame of the player is shown as it comes; an edit shows at once only where it
// changes looks or where no simulation runs, and otherwise with the next frame. prepare() runs
// before each picture, place() also when only what lies over the picture changes.
//
// The widget: the constructor stacks overlays and connects document, selection and player; the
// setters pass on what the menus choose and ask for a picture (viewport_shown.cpp has the
// switches); image() renders one for files.
//
// The camera: fitting, preset views, following. The mouse and keys are in viewport_input.cpp.
#include "viewport/viewport.h"

#include "camera/camera_projection.h"
#include "document/recordings.h"
#include "look/collider_geometry.h"
#include "look/scene_frame.h"
#include "overlays/overlay_paint.h"
#include "tools/tool_strip.h"
#include "viewport/viewport_data.h"

#include <QPainter>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int corner = 12;           // pixels between the edge and what lies over the view
constexpr int barGap = 4;            // pixels above the bar of a tool
constexpr double room = 2.2;         // m, half of what is seen of a scene without anything in it
constexpr double most = 0.65;        // of the width, that a dialog may take from what is fitted
constexpr double farthestBack = 3.0; // times as far as when everything was fitted

// The fabric, or the network where there is none.
void addSubject(std::vector<Vec3>& points, const Frame& frame)
{
    const std::size_t before = points.size();
    for (std::size_t i = 0; i < frame.gone.size(); ++i)
        if (!frame.gone[i])
            for (const int particle : frame.layout->panelCorners[i])
                points.push_back(frame.position[std::size_t(particle)]);
    if (points.size() == before)
        points.insert(points.end(), frame.position.begin(), frame.position.end());
    std::erase_if(points, [](const Vec3& point) { return !point.allFinite(); });
}

} // namespace

// --- frames and scene ------------------------------------------------------------------------

void Viewport::Private::showDesign()
{
    stage.show(sceneFrame(document.scene()));
    stage.sceneChanged();
    chase.forget(); // what is drawn anew has not moved
}

void Viewport::Private::sceneReplaced()
{
    untouched = true;
    wholeScene = false;
    beforeGhosts.reset(); // they were of the other scene
    ghostShifts.clear();
    ghostPoints.clear();
    stage.forgetRanges();
    stage.designChanged();
    chase.forget();
    camera.look(PresetView::Iso);
    showDesign();
    fitNow();
}

bool Viewport::Private::sceneChanged(const Edit& edit)
{
    stage.designChanged();
    // a design that cannot run sends no frames, but must show what was done to it
    if (!player.frame() || !player.problem().isEmpty())
        showDesign();
    else if (changesLook(edit))
        stage.sceneChanged();
    else
        return false;
    return true;
}

void Viewport::Private::prepare()
{
    stage.setPixelRatio(shotRatio.value_or(screen.devicePixelRatioF()));
    stage.prepare(document.scene());
    keepWhole();
    compass.setWind(stage.frame() ? stage.frame()->wind : Vec3::Zero());
    const int before = legend.isHidden() ? 0 : legend.height();
    legend.setScale(stage.colorBy(), stage.range(), stage.colors());
    if (!legend.isHidden())
        legend.setPeak(stage.isKnown() ? std::optional(stage.peak()) : std::nullopt,
                       stage.extent());
    place();
    const int now = legend.isHidden() ? 0 : legend.height();
    if (untouched && now != before) { // it has come over the design, or gone
        fitNow();
        place();
    }
}

// The upper edge of what would stand here, were there not the bar of a tool.
int Viewport::Private::aboveBars(const QRect& place) const
{
    for (const QObject* child : screen.parentWidget()->children())
        if (const auto* bar = qobject_cast<const QFrame*>(child);
            bar && bar->frameShape() == QFrame::StyledPanel && bar->isVisible() && !bar->isWindow()
            && !qobject_cast<const ToolStrip*>(child) && bar->geometry().intersects(place))
            return bar->y() - place.height() - barGap;
    return place.y();
}

void Viewport::Private::place()
{
    legend.move(screen.width() - legend.width() - corner, corner);
    const int under = screen.height() - compass.height() - corner;
    QRect place(QPoint(corner, under), compass.size());
    place.moveLeft(besideTools(*screen.parentWidget(), place));
    compass.move(place.x(), aboveBars(place));
    compass.setCamera(camera);
    centre.show(stage.frame(), camera);
    labels.show(stage.frame(), camera);
    gizmo.refresh();
    stage.place(camera);
    compass.setSquares(stage.squares());
}

std::optional<CameraView> Viewport::Private::view()
{
    stage.prepare(document.scene());
    if (!stage.frame())
        return std::nullopt;
    return CameraView{*stage.frame(),
                      stage.look(),
                      stage.colliders(),
                      camera,
                      double(screen.width()),
                      double(screen.height()),
                      overlaysOf(*screen.parentWidget())};
}

void Viewport::Private::click(Id id, Qt::KeyboardModifiers keys)
{
    if (keys & Qt::ControlModifier)
        selection.remove({id});
    else if (keys & Qt::ShiftModifier)
        selection.add({id});
    else
        selection.set({id});
}

void Viewport::Private::fitNow()
{
    stage.prepare(document.scene());
    std::vector<Vec3> points = wholeScene ? stage.shownPoints() : stage.subjectPoints();
    if (points.empty()) // a room to draw in
        points = {Vec3(-room, 0.0, -room), Vec3(room, 0.0, room), Vec3(0.0, 1.5 * room, 0.0)};
    points.insert(points.end(), ghostPoints.begin(), ghostPoints.end());
    camera.fit(points, aspect(), overlayMargins());
    chase.settle(stage.frame().get());
    screen.renderSoon();
}

bool Viewport::Private::seesSubject()
{
    stage.prepare(document.scene());
    const std::vector<Vec3> points = stage.subjectPoints();
    return points.empty()
           || std::ranges::any_of(points, [this](const Vec3& point) { return sees(point); });
}

bool Viewport::Private::sees(const Vec3& point) const
{
    const auto pixel = CameraProjection(camera, screen.width(), screen.height()).pixel(point);
    return pixel && QRectF(screen.rect()).contains(*pixel);
}

// A camera that goes with a kite would leave the hand that holds it. As long as nobody has moved it
// since everything was fitted, it goes back until everything is in the picture again, though not
// without end where something has torn off.
void Viewport::Private::keepWhole()
{
    if (!untouched || !wholeScene || !chase.isOn())
        return;
    const std::vector<Vec3> points = stage.shownPoints();
    if (std::ranges::all_of(points, [this](const Vec3& point) { return sees(point); }))
        return;
    Camera wider = camera;
    wider.fit(points, aspect(), overlayMargins());
    if (wider.distance > farthestBack * fittedFrom)
        return;
    camera = wider;
    chase.settle(stage.frame().get());
}

// Once when they come; later the picture is left as it is, however far they fly. Says whether the
// camera may have moved.
bool Viewport::Private::lookAtGhosts(const std::vector<GhostFrame>& ghosts)
{
    std::vector<Vec3> shifts;
    ghostPoints.clear();
    for (const GhostFrame& ghost : ghosts)
        if (!ghost.shift.isZero()) {
            shifts.push_back(ghost.shift);
            addSubject(ghostPoints, *ghost.frame);
        }
    if (shifts == ghostShifts)
        return false;
    ghostShifts = std::move(shifts);
    if (!ghostShifts.empty()) {
        if (!beforeGhosts)
            beforeGhosts = Before{camera, untouched, chase.middle()};
        else if (!untouched)
            return false; // a person looks at one of them
        untouched = true;
        fitNow();
    } else if (const auto before = std::exchange(beforeGhosts, std::nullopt); before && untouched) {
        untouched = before->untouched;
        camera = before->camera;
        if (before->middle && chase.middle()) // it would have followed
            camera.focus += *chase.middle() - *before->middle;
        if (untouched)
            fitNow();
    }
    return true;
}

// --- the widget ------------------------------------------------------------------------------

Viewport::Viewport(Document& document, Selection& selection, Player& player, QWidget* parent)
    : QWidget(parent)
    , d(std::make_unique<Private>(*this, document, selection, player))
{
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(200, 150);
    setMouseTracking(true);
    d->screen.setAttribute(Qt::WA_TransparentForMouseEvents);
    d->pointing.raise();
    d->legend.raise();
    d->compass.raise();
    d->centre.raise();
    d->labels.raise();
    d->gizmo.raise();
    d->screen.beforePainting = [this] { d->prepare(); };

    connect(&document, &Document::replaced, this, [this] { d->sceneReplaced(); });
    connect(&document, &Document::changed, this, [this](const Edit& edit) {
        if (d->sceneChanged(edit)) {
            d->screen.renderSoon();
        } else {
            d->place(); // what lies over the picture; the next frame brings the rest
            d->screen.update();
        }
    });
    connect(&selection, &Selection::changed, this, [this] {
        d->stage.setSelected(d->selection.ids());
        d->screen.renderSoon();
    });
    connect(&player, &Player::frameReady, this,
            [this](const std::shared_ptr<const Frame>& frame) { show(frame); });

    // the files of colliders have been read then, also when there is no frame
    connect(&player, &Player::stateChanged, this, [this] { d->screen.renderSoon(); });
    connect(&player.follower(), &Follower::checked, this, [this] { d->screen.renderSoon(); });

    connect(&d->legend, &Legend::peakClicked, &selection,
            [&selection](Id id) { selection.set({id}); });
    connect(&d->rangeEditor, &RangeEditor::chosen, this, &Viewport::setFixedRange);
    connect(this, &Viewport::cameraChanged, this, [this] { d->pointing.moved(); });

    setTheme(Theme::from(palette()));
    player.frame() ? d->stage.show(player.frame()) : d->showDesign();
}

Viewport::~Viewport() = default;

void Viewport::takeOver(const Viewport& before)
{
    d->hands = before.d->hands;
    d->brush = before.d->brush;
    d->camera = before.d->camera;
    d->untouched = before.d->untouched;
    d->wholeScene = before.d->wholeScene;
    d->fittedFrom = before.d->fittedFrom;
    d->stage.takeRanges(before.d->stage);
    d->stage.setSelected(d->selection.ids());
    d->chase.settle(d->stage.frame().get());
    d->screen.renderSoon();
}

void Viewport::show(std::shared_ptr<const Frame> frame)
{
    if (d->pointing.holds()) // the camera would follow the hand, and the hand the camera
        d->chase.settle(frame.get());
    else
        d->chase.move(d->camera, *frame, d->stage.frame().get(),
                      groundBelow(d->stage.colliders(), *frame, d->camera.eye()));
    const auto before = d->stage.frame();
    const bool isAnew = before && beginsAnew(*frame, *before);
    const bool comesBack = before && before->position.empty() && !frame->position.empty();
    d->stage.show(std::move(frame));
    // the camera looked at what is elsewhere again, or at where it was before it was deleted
    if ((isAnew || comesBack) && !d->seesSubject())
        d->fitNow();
    d->pointing.moved();
    d->screen.renderSoon();
}

void Viewport::showGhosts(const std::vector<GhostFrame>& ghosts)
{
    std::vector<GhostLayer::Ghost> shown;
    for (const GhostFrame& ghost : ghosts)
        shown.push_back({ghost.frame, ghost.color});
    d->draw([&] { d->stage.ghost.show(std::move(shown)); });
    if (d->lookAtGhosts(ghosts))
        emit cameraChanged();
}

const std::shared_ptr<const Frame>& Viewport::frame() const { return d->stage.frame(); }

ColorBy Viewport::colorBy() const { return d->stage.colorBy(); }

void Viewport::setColorBy(ColorBy colorBy)
{
    d->draw([&] { d->stage.setColorBy(colorBy); });
    emit colorByChanged();
}

void Viewport::setFixedRange(std::optional<ValueRange> range)
{
    d->draw([&] { d->stage.setFixedRange(range); });
}

void Viewport::editRange() { d->rangeEditor.open(); }

ValueRange Viewport::range() const { return d->stage.range(); }

const Legend& Viewport::legend() const { return d->legend; }

void Viewport::setTheme(const Theme& theme)
{
    d->stage.setTheme(theme);
    d->pointing.setTheme(theme);
    d->legend.setTheme(theme);
    d->compass.setTheme(theme);
    d->centre.setTheme(theme);
    d->labels.setTheme(theme);
    d->gizmo.setTheme(theme);
    d->screen.renderSoon();
}

void Viewport::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange)
        setTheme(Theme::from(palette()));
    QWidget::changeEvent(event);
}

void Viewport::resizeEvent(QResizeEvent*)
{
    d->screen.setGeometry(rect());
    d->pointing.setGeometry(rect());
    if (d->untouched)
        d->fitNow();
    d->place();
}

QImage Viewport::image(Overlays overlays)
{
    QImage picture = d->screen.picture();
    if (!picture.isNull() && overlays == Overlays::With) {
        QPainter painter(&picture);
        paintOver(painter, picture.size(),
                  {&d->centre, &d->labels, &d->gizmo, &d->legend, &d->compass}, size());
    }
    return picture;
}

QImage Viewport::image(const Shot& shot)
{
    d->shotRatio = double(shot.size.height()) / std::max(height(), 1);
    d->stage.setBackdrop(shot.backdrop);
    d->stage.setSelectionMarked(false); // which is of the window, not of the design
    d->stage.setPinsShown(shot.pins == Pins::With);
    QImage picture = d->screen.picture(shot.size, shot.backdrop);
    d->stage.setBackdrop(Backdrop::Scenery);
    d->stage.setSelectionMarked(true);
    d->stage.setPinsShown(true);
    d->shotRatio.reset();
    if (!picture.isNull() && shot.overlays == Overlays::With) {
        QPainter painter(&picture);
        paintOverlays(painter, picture.size());
    }
    return picture;
}

void Viewport::paintOverlays(QPainter& painter, QSize picture)
{
    paintOver(painter, picture, {&d->legend, &d->compass}, size());
}

// --- camera ----------------------------------------------------------------------------------

const Camera& Viewport::camera() const { return d->camera; }

void Viewport::fit()
{
    d->untouched = true;
    d->wholeScene = true;
    d->fitNow();
    d->fittedFrom = d->camera.distance;
    emit cameraChanged();
}

void Viewport::centre(const std::vector<Id>& ids)
{
    d->stage.prepare(d->document.scene());
    const std::vector<Vec3> places = d->stage.pointsOf(d->document.scene(), ids);
    if (places.empty())
        return;
    Vec3 sum = Vec3::Zero();
    for (const Vec3& place : places)
        sum += place;
    centreAt(sum / double(places.size()));
}

void Viewport::centreAt(const Vec3& place)
{
    d->untouched = false;
    d->camera.focus = place;
    d->screen.renderSoon();
    emit cameraChanged();
}

void Viewport::fit(const std::vector<Id>& ids, const QRect& covered)
{
    d->stage.prepare(d->document.scene());
    const std::vector<Vec3> places = d->stage.fittedPoints(d->document.scene(), ids);
    if (places.empty())
        return fit();
    d->untouched = false;
    OverlayMargins margins = d->overlayMargins();
    const QRect under = QRect(mapToGlobal(QPoint()), size()).intersected(covered);
    if (under.isValid() && under.width() < width())
        margins.right = std::max(margins.right, std::min(double(under.width()) / width(), most));
    d->camera.fit(places, d->aspect(), margins);
    d->screen.renderSoon();
    emit cameraChanged();
}

void Viewport::look(const Camera& camera)
{
    d->untouched = false;
    d->draw([&] { d->camera = camera; });
    emit cameraChanged();
}

void Viewport::view(PresetView preset)
{
    d->camera.look(preset);
    d->untouched = true;
    d->fitNow();
    emit cameraChanged();
}

void Viewport::setFollow(bool follow) { d->chase.set(follow, d->stage.frame().get()); }

void Viewport::setOrthographic(bool orthographic)
{
    d->camera.orthographic = orthographic;
    d->screen.renderSoon();
    emit cameraChanged();
}

TransformTool& Viewport::transformTool() { return d->transform; }

HandSettings& Viewport::hands() { return d->hands; }

Brush& Viewport::brush() { return d->brush; }

Id Viewport::pick(QPointF place) { return d->pointing.pick(place); }

Pointing& Viewport::pointing() { return d->pointing; }

} // namespace ripstop
