#include "editor/shown_break.h"

#include "document/player.h"
#include "document/recordings.h"
#include "document/spoken.h"
#include "viewport/viewport.h"

#include <utility>

namespace ripstop {

ShownBreak::ShownBreak(Player& player, Recordings& recordings, Viewport& viewport, QObject& window)
    : QObject(&window)
    , m_recordings(recordings)
    , m_viewport(viewport)
{
    connect(&player, &Player::frameReady, this, [this](const std::shared_ptr<const Frame>& frame) {
        if (m_awaited && m_recordings.isLookingBack() && frame->time == m_recordings.time())
            m_viewport.centreAt(*std::exchange(m_awaited, std::nullopt));
    });
}

void ShownBreak::show(quint64 run, double time, const Vec3& place)
{
    m_awaited.reset();
    if (m_recordings.seekRun(run, time)) {
        m_awaited = place;
        return;
    }
    m_viewport.centreAt(place);
    emit said(tr("The moment at which it broke, %1, is not recorded: the view has the place in its "
                 "middle as it is now.")
                  .arg(spokenText(time, "s")));
}

} // namespace ripstop
