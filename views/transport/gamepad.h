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

// Lets the sticks of a gamepad steer: the first axis sets the first control of the scene, the
// second one the second, and so on, from minus to plus their limits. A stick that is let go stands
// at 0.
//
// Qt 6 knows no gamepads. Linux tells of them as a stream of small records, one file for each
// (linux/joystick.h); the first one that there is counts, also when it is plugged in later.
class Gamepad final : public QObject
{
    Q_OBJECT

public:
    // Looks for js0, js1, ... in the folder.
    Gamepad(Document& document, Player& player,
            const QString& folder = QStringLiteral("/dev/input"), QObject* parent = nullptr);
    ~Gamepad() override;

    bool isThere() const { return m_device.isOpen(); }

    // What a stick that is pushed this far, from -1 to 1, asks for: nothing near the middle, where
    // sticks do not come to rest exactly.
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
    std::map<int, double> m_share; // by axis, as last told
    std::unique_ptr<QSocketNotifier> m_notifier;
};

} // namespace ripstop
