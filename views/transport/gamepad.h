// Lets the sticks of a gamepad steer: the first axis sets the first control of the scene, the
// second one the second, and so on, from minus to plus their limits. A stick that is let go stands
// at 0.
//
// Qt 6 knows no gamepads. Linux reports them as a stream of records of 8 bytes, one file for each
// gamepad (linux/joystick.h). The first one that can be read is used, also when it is plugged in
// later; without any, and on other systems, nothing happens. Only the window's thread uses it,
// woken by the file.
#pragma once

#include <QFile>
#include <QFileSystemWatcher>
#include <QObject>
#include <QString>

#include <map>
#include <memory>

class QSocketNotifier;

namespace ripstop {

class Document;
class Player;

class Gamepad final : public QObject
{
    Q_OBJECT

public:
    // Looks for js0, js1, ... in the folder.
    Gamepad(Document& document, Player& player,
            const QString& folder = QStringLiteral("/dev/input"), QObject* parent = nullptr);
    ~Gamepad() override;

    bool isThere() const { return m_device.isOpen(); }

    // The share of its limit, -1 to 1, that a stick which is pushed this far, -1 to 1, asks for. It
    // is 0 near the middle, where sticks do not come to rest exactly.
    static double share(double push);

private:
    void look();
    void take();
    void letGo();
    void steer(int axis, double push);

    Document& m_document;
    Player& m_player;
    QString m_folder;
    QFileSystemWatcher m_watch;
    QFile m_device;
    std::map<int, double> m_share; // by axis, -1 to 1, as last passed to the player
    std::unique_ptr<QSocketNotifier> m_notifier;
};

} // namespace ripstop
