#include "document/event_words.h"

#include "derived/gust_now.h"
#include "document/place_words.h"
#include "document/spoken.h"
#include "document/words.h"

#include <QCoreApplication>
#include <QLocale>

#include <array>

namespace ripstop {
namespace {

struct EventWords
{
    Q_DECLARE_TR_FUNCTIONS(EventWords)
};

// The words for one event or for several at once, which name the first of their links.
QString lines(const RunEvent& event, const QString& one, const QString& many)
{
    return event.count == 1 ? one.arg(event.what) : many.arg(event.count).arg(event.what);
}

QString what(const RunEvent& event, const Scene& scene)
{
    const auto name = [&](std::uint32_t id) { return nameOf(scene, Id{id}); };
    switch (event.kind) {
    case RunEvent::Kind::Tear:
        return event.count == 1 ? EventWords::tr("%1 tore").arg(placeWords(scene, Id{event.what}))
                                : EventWords::tr("%1 places tore, the first is %2")
                                      .arg(event.count)
                                      .arg(placeWords(scene, Id{event.what}));
    case RunEvent::Kind::Control:
        return EventWords::tr("a control was moved");
    case RunEvent::Kind::Hand:
        return EventWords::tr("something was done by hand");
    case RunEvent::Kind::Edit:
        return EventWords::tr("the design was edited");
    case RunEvent::Kind::Stopped:
        return EventWords::tr("the simulation could not go on");
    case RunEvent::Kind::Contact:
        return EventWords::tr("%1 touches %2").arg(name(event.what), name(event.with));
    case RunEvent::Kind::LiftOff:
        return EventWords::tr("%1 leaves %2").arg(name(event.what), name(event.with));
    case RunEvent::Kind::Slack:
        return lines(event, EventWords::tr("the line of link %1 goes slack"),
                     EventWords::tr("%1 lines go slack, that of link %2 first"));
    case RunEvent::Kind::Taut:
        return lines(event, EventWords::tr("the line of link %1 goes taut"),
                     EventWords::tr("%1 lines go taut, that of link %2 first"));
    }
    return {};
}

} // namespace

QString describe(const RunEvent& event, const Scene& scene, int more)
{
    const QString one =
        EventWords::tr("%1 s: %2").arg(QLocale().toString(event.time, 'f', 3), what(event, scene));
    return more == 0
               ? one
               : EventWords::tr("%1, and %2 more in this step").arg(one, QString::number(more));
}

QString describeInGust(const RunEvent& event, const Scene& flown)
{
    const QString told = describe(event, flown);
    const std::optional<GustNow> gust = gustNow(flown, event.time);
    if (!gust)
        return told;
    const QString wind = nameOf(flown, gust->wind);
    const QString peak = spokenText(gust->peak, "m/s");
    return gust->repeats ? EventWords::tr("%1, in gust %2 of %3, which peaks at %4")
                               .arg(told, QString::number(gust->number), wind, peak)
                         : EventWords::tr("%1, in %2, which peaks at %3").arg(told, wind, peak);
}

QColor eventColor(RunEvent::Kind kind, const QPalette& palette)
{
    // by RunEvent::Kind; contact and lift-off have one colour, slack and taut have another
    static constexpr std::array light{0xc62828, 0x1565c0, 0x6a1b9a, 0x2e7d32, 0x8d4b00,
                                      0x00796b, 0x00796b, 0xad1457, 0xad1457};
    static constexpr std::array dark{0xff6b60, 0x64b5f6, 0xce93d8, 0x81c784, 0xffb74d,
                                     0x4dd0c1, 0x4dd0c1, 0xf48fb1, 0xf48fb1};
    static_assert(light.size() == runEventNames.size() && dark.size() == runEventNames.size());
    const bool isDark = palette.color(QPalette::Base).lightness() < 128;
    return QRgb(0xff000000u | unsigned((isDark ? dark : light)[std::size_t(kind)]));
}

} // namespace ripstop
