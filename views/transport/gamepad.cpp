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

// What Linux tells of a gamepad, as linux/joystick.h has it.
struct Record
{
    std::uint32_t time; // ms
    std::int16_t value;
    std::uint8_t type;
    std::uint8_t number;
};
static_assert(sizeof(Record) == 8);
constexpr std::uint8_t axisMoved = 2; // without the bit for where things stand at first
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

// The n-th axis belongs to the n-th control. A stick that trembles in its middle says nothing: keys
// steer too.
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
            continue; // not ours to read
        m_notifier = std::make_unique<QSocketNotifier>(m_device.handle(), QSocketNotifier::Read);
        connect(m_notifier.get(), &QSocketNotifier::activated, this, &Gamepad::take);
    }
}

// One record: to read on would wait for the next.
void Gamepad::take()
{
    Record record{};
    if (m_device.read(reinterpret_cast<char*>(&record), sizeof record) != sizeof record)
        return letGo(); // pulled out
    if (record.type == axisMoved)
        steer(record.number, double(record.value) / farthest);
}

void Gamepad::letGo()
{
    if (m_notifier) {
        m_notifier->setEnabled(false);
        m_notifier.release()->deleteLater(); // it may be what called
    }
    m_device.close();
}

} // namespace ripstop
