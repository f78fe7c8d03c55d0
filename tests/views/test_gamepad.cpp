// A gamepad, as Linux tells of it: records in a file. Here a pipe plays the device.
//
// Stages: the dead middle of a stick; a stick that sets its control; devices that come and go; and
// none at all.
#include "document/document.h"
#include "document/player.h"
#include "small_scenes.h"
#include "transport/gamepad.h"
#include "views/run_with_widgets.h"

#include <QTemporaryDir>
#include <QtTest>

#include <fcntl.h>
#include <linux/joystick.h>
#include <sys/stat.h>
#include <unistd.h>

namespace ripstop::test_gamepad {

namespace {

constexpr Id hand{7}; // limit 0.25 m

class Device
{
public:
    explicit Device(const QString& path)
    {
        ::mkfifo(qPrintable(path), 0600);
        m_handle = ::open(qPrintable(path), O_RDWR | O_NONBLOCK);
    }
    ~Device() { close(); }
    void close()
    {
        if (m_handle >= 0)
            ::close(m_handle);
        m_handle = -1;
    }
    void tell(int type, int number, int value) const
    {
        js_event event{};
        event.type = std::uint8_t(type);
        event.number = std::uint8_t(number);
        event.value = std::int16_t(value);
        QCOMPARE(::write(m_handle, &event, sizeof event), ssize_t(sizeof event));
    }

private:
    int m_handle = -1;
};

} // namespace

class TestGamepad : public QObject
{
    Q_OBJECT

private slots:
    void theMiddleIsDead()
    {
        QCOMPARE(Gamepad::share(0.0), 0.0);
        QCOMPARE(Gamepad::share(0.05), 0.0);
        QCOMPARE(Gamepad::share(1.0), 1.0);
        QCOMPARE(Gamepad::share(-1.0), -1.0);
        QCOMPARE(Gamepad::share(-1.5), -1.0);
        QVERIFY(Gamepad::share(0.09) > 0.0 && Gamepad::share(0.09) < 0.02); // without a jump
    }

    void aStickSetsItsControl()
    {
        const QTemporaryDir folder;
        const Device device(folder.filePath("js0"));
        Document document;
        Player player(document);
        document.replace(fallingPair());
        const Gamepad pad(document, player, folder.path());
        QVERIFY(pad.isThere());
        device.tell(JS_EVENT_AXIS, 0, 32767);
        QTRY_COMPARE(player.commandOf(hand), 0.25);
        device.tell(JS_EVENT_AXIS, 0, -32767);
        QTRY_COMPARE(player.commandOf(hand), -0.25);
        device.tell(JS_EVENT_AXIS, 5, 32767);                 // there is no sixth control
        device.tell(JS_EVENT_BUTTON, 0, 1);                   // buttons do nothing
        device.tell(JS_EVENT_AXIS | JS_EVENT_INIT, 0, 32767); // nobody has touched it
        device.tell(JS_EVENT_AXIS, 0, 0);
        QTRY_COMPARE(player.commandOf(hand), 0.0);
    }

    void pluggedInLaterAndPulledOut()
    {
        const QTemporaryDir folder;
        Document document;
        Player player(document);
        document.replace(fallingPair());
        const Gamepad pad(document, player, folder.path());
        QVERIFY(!pad.isThere());
        const QString path = folder.filePath("js0");
        {
            Device device(path);
            QTRY_VERIFY(pad.isThere());
            QFile::remove(path);
        }
        QTRY_VERIFY(!pad.isThere());
    }

    void withoutDevicesNothingHappens()
    {
        Document document;
        Player player(document);
        const Gamepad pad(document, player, QStringLiteral("/no/such/folder"));
        QVERIFY(!pad.isThere());
    }
};

const RegisteredTest registered("test_gamepad", runWithWidgets<TestGamepad>);

} // namespace ripstop::test_gamepad
#include "test_gamepad.moc"
