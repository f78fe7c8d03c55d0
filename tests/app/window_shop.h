// The whole window with its document, selection and player, and a mouse that sends real events to
// the view: press, move, drag, wheel, at places in pixels of the view.
//
// It ignores remembered layouts and keys, so that tests do not depend on the machine. The window
// is not shown by itself. Whoever makes one has to run by runWithView().
#pragma once

#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "editor/main_window.h"
#include "viewport/viewport.h"
#include "views/run_with_widgets.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QMouseEvent>
#include <QTimer>
#include <QtTest>

#include <algorithm>
#include <functional>

namespace ripstop {

struct WindowShop
{
    Document document;
    Selection selection{document};
    Player player{document};
    MainWindow window{document, selection, player, MainWindow::Memory::Ignore};
    Viewport& viewport = window.viewport();

    void run(const char* id) { window.actions()[id]->trigger(); }
    const Frame& frame() const { return *player.frame(); }

    // Where a place (m) is in the picture, in pixels.
    QPointF at(const Vec3& place) const
    {
        const double width = viewport.width(), height = viewport.height();
        const Eigen::Vector4d p =
            viewport.camera().projection(width / height) * place.homogeneous();
        return {0.5 * width * (1.0 + p.x() / p.w()), 0.5 * height * (1.0 - p.y() / p.w())};
    }

    Vec3 now(Id id) const
    {
        const auto& ids = frame().layout->particleId;
        const auto place = std::find(ids.begin(), ids.end(), std::uint32_t(id)) - ids.begin();
        return frame().position[std::size_t(place)];
    }

    void send(QEvent::Type type, QPointF place, Qt::KeyboardModifiers keys = {})
    {
        const auto button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
        const auto buttons = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
        QMouseEvent event(type, place, viewport.mapToGlobal(place), button, buttons, keys);
        QApplication::sendEvent(&viewport, &event);
    }
    void press(QPointF place, Qt::KeyboardModifiers keys = {})
    {
        send(QEvent::MouseButtonPress, place, keys);
    }
    void move(QPointF from, QPointF to, Qt::KeyboardModifiers keys = {})
    {
        for (int i = 1; i <= 10; ++i)
            send(QEvent::MouseMove, from + 0.1 * i * (to - from), keys);
    }
    void release(QPointF place, Qt::KeyboardModifiers keys = {})
    {
        send(QEvent::MouseButtonRelease, place, keys);
    }
    void drag(QPointF from, QPointF to, Qt::KeyboardModifiers keys = {})
    {
        press(from, keys);
        move(from, to, keys);
        release(to, keys);
    }
    void wheel(QPointF place, int notches, Qt::KeyboardModifiers keys = {})
    {
        QWheelEvent event(place, viewport.mapToGlobal(place), {}, {0, 120 * notches},
                          Qt::LeftButton, keys, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&viewport, &event);
    }

    // Begins what opens a dialog with a loop of its own, and does this in it; what is left open is
    // dismissed.
    template <typename Dialog>
    void during(const std::function<void()>& begin, const std::function<void(Dialog&)>& act)
    {
        bool found = false;
        QTimer::singleShot(0, &window, [&] {
            auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
            found = dialog;
            if (dialog)
                act(*dialog);
            if (dialog && dialog->isVisible())
                dialog->reject();
        });
        begin();
        QVERIFY(found);
    }
    template <typename Dialog>
    void during(const char* id, const std::function<void(Dialog&)>& act)
    {
        during<Dialog>([&] { run(id); }, act);
    }
};

} // namespace ripstop
