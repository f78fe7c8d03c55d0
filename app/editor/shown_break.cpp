#include "editor/shown_break.h"

#include "document/event_words.h"
#include "document/player.h"
#include "document/recordings.h"
#include "document/selection.h"
#include "document/spoken.h"
#include "viewport/viewport.h"

#include <QEvent>
#include <QPainter>

#include <utility>

namespace ripstop {

BreakMark::BreakMark(Viewport& viewport)
    : QWidget(&viewport)
    , m_viewport(viewport)
{
    setObjectName(QStringLiteral("breakMark"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
    viewport.installEventFilter(this);
    connect(&viewport, &Viewport::cameraChanged, this, qOverload<>(&QWidget::update));
}

void BreakMark::mark(const Vec3& place)
{
    m_place = place;
    setGeometry(m_viewport.rect());
    show();
    raise();
    update();
}

// It is as large as the view, since the camera leaves room for what lies over a part of it.
bool BreakMark::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        setGeometry(m_viewport.rect());
    return QWidget::eventFilter(watched, event);
}

// In the colour that tears have in the strip of time, with an edge that is seen on any cloth.
void BreakMark::paintEvent(QPaintEvent*)
{
    constexpr double radius = 14.0; // pixels
    const Eigen::Vector4d place =
        m_viewport.camera().projection(double(width()) / height()) * m_place.homogeneous();
    if (place.w() <= 0.0)
        return; // behind the eye
    const QPointF pixel(0.5 * width() * (1.0 + place.x() / place.w()),
                        0.5 * height() * (1.0 - place.y() / place.w()));
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const auto& [ink, wide] : {std::pair(QColor(Qt::white), 5.0),
                                    std::pair(eventColor(RunEvent::Kind::Tear, palette()), 2.5)}) {
        painter.setPen(QPen(ink, wide));
        painter.drawEllipse(pixel, radius, radius);
    }
}

ShownBreak::ShownBreak(Player& player, Recordings& recordings, Selection& selection,
                       Viewport& viewport, QObject& window)
    : QObject(&window)
    , m_recordings(recordings)
    , m_viewport(viewport)
    , m_mark(new BreakMark(viewport))
{
    connect(&player, &Player::frameReady, this, [this](const std::shared_ptr<const Frame>& frame) {
        m_mark->hide();
        if (!m_awaited || !m_recordings.isLookingBack() || frame->time != m_recordings.time())
            return;
        m_viewport.centreAt(*m_awaited);
        m_mark->mark(*std::exchange(m_awaited, std::nullopt));
    });
    connect(&selection, &Selection::changed, m_mark, &QWidget::hide);
}

void ShownBreak::show(quint64 run, double time, const Vec3& place)
{
    m_awaited.reset();
    if (m_recordings.seekRun(run, time)) {
        m_awaited = place;
        return;
    }
    m_viewport.centreAt(place);
    m_mark->mark(place);
    emit said(tr("The moment at which it broke, %1, is not recorded: the view has the place in its "
                 "middle as it is now.")
                  .arg(spokenText(time, "s")));
}

} // namespace ripstop
