#include "transport/gamepad.h"

#include "document/document.h"
#include "document/player.h"

#include <QDir>
#include <QSocketNotifier>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace ripstop {
namespace {

// One event of a gamepad, laid out as js_event in linux/joystick.h.
struct Record
{
    std::uint32_t time; // ms
    std::int16_t value;
    std::uint8_t type;
    std::uint8_t number;
};
static_assert(sizeof(Record) == 8);
// The initial state comes as events with a further bit set in their type, which are ignored.
constexpr std::uint8_t axisMoved = 2;
constexpr double farthest = 32767.0;

} // namespace

double Gamepad::share(double push)
{
    constexpr double deadZone = 0.08;
    const double size = std::min(std::abs(push), 1.0);
    return size <= deadZone ? 0.0 : std::copysign((size - deadZone) / (1.0 - deadZone), push);
}

Gamepad::Gamepad(Document& document, Player& player, const QString& folder, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_player(player)
    , m_folder(folder)
{
    if (QDir(folder).exists())
        m_watch.addPath(folder);
    connect(&m_watch, &QFileSystemWatcher::directoryChanged, this, &Gamepad::look);
    look();
}

Gamepad::~Gamepad() { letGo(); }

// The n-th axis belongs to the n-th control. A stick that trembles in its middle must not set its
// control back to 0, because keys steer the same controls.
void Gamepad::steer(int axis, double push)
{
    if (std::exchange(m_share[axis], share(push)) == share(push))
        return;
    int number = 0;
    for (const Entry& entry : m_document.scene().items)
        if (const Control* control = std::get_if<Control>(&entry.item); control && number++ == axis)
            return m_player.steer(entry.id, share(push) * control->limit);
}

void Gamepad::look()
{
    const QDir folder(m_folder, QStringLiteral("js*"), QDir::Name, QDir::System | QDir::Files);
    for (const QString& name : folder.entryList()) {
        if (isThere())
            return;
        m_device.setFileName(folder.filePath(name));
        if (!m_device.open(QIODevice::ReadOnly | QIODevice::Unbuffered))
            continue; // this user may not read it
        m_notifier = std::make_unique<QSocketNotifier>(m_device.handle(), QSocketNotifier::Read);
        connect(m_notifier.get(), &QSocketNotifier::activated, this, &Gamepad::take);
    }
}

// Reads one record; reading on would wait for the next one and hold up the window.
void Gamepad::take()
{
    Record record{};
    if (m_device.read(reinterpret_cast<char*>(&record), sizeof record) != sizeof record)
        return letGo(); // the gamepad has been pulled out
    if (record.type == axisMoved)
        steer(record.number, double(record.value) / farthest);
}

void Gamepad::letGo()
{
    if (m_notifier) {
        m_notifier->setEnabled(false);
        m_notifier.release()->deleteLater(); // its signal may be what called this
    }
    m_device.close();
}

} // namespace ripstop
