// A sheet in the whole window, and a mouse.
#pragma once

#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "editor/main_window.h"
#include "viewport/viewport.h"
#include "views/small_scenes.h"

#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QMouseEvent>
#include <QSurfaceFormat>
#include <QtTest>

#include <algorithm>

namespace ripstop {

// A square sheet of 2 m in the plane z = 0, held at its upper edge, in calm air; it parts at cuts.
// Ids: part 1, particles from 2 row by row, then the material, links, panels.
struct Sheet
{
    static constexpr int n = 8;
    Scene scene;

    Sheet()
    {
        Part part;
        part.name = "sheet";
        std::uint32_t id = 2;
        for (int row = 0; row <= n; ++row)
            for (int column = 0; column <= n; ++column)
                part.particles.push_back({.id = Id{id++},
                                          .position = placeOf(row, column),
                                          .mass = 0.01,
                                          .pinned = row == 0});
        const Id material{id++};
        const auto link = [&](Id a, Id b) { part.links.push_back(rod(Id{id++}, a, b, material)); };
        for (int row = 0; row <= n; ++row)
            for (int column = 0; column <= n; ++column) {
                if (column < n)
                    link(at(row, column), at(row, column + 1));
                if (row < n)
                    link(at(row, column), at(row + 1, column));
                if (row < n && column < n)
                    link(at(row + 1, column), at(row, column + 1));
            }
        for (int row = 0; row < n; ++row)
            for (int column = 0; column < n; ++column) {
                part.panels.push_back({Id{id++}, at(row, column), at(row + 1, column),
                                       at(row, column + 1), material});
                part.panels.push_back({Id{id++}, at(row + 1, column), at(row + 1, column + 1),
                                       at(row, column + 1), material});
            }
        for (Link& one : part.links) {
            one.resists = Resists::Tension; // so that it folds
            one.restLength = (position(part, one.to) - position(part, one.from)).norm();
        }
        Material cloth;
        cloth.name = "cloth";
        scene.items = {{Id{1}, part}, {material, cloth}};
        scene.nextId = Id{id};
        scene.settings.tearMesh = TearMesh::Split;
    }

    static Vec3 placeOf(int row, int column)
    {
        return {2.0 * column / n - 1.0, 3.0 - 2.0 * row / n, 0.0};
    }
    static Id at(int row, int column) { return Id(std::uint32_t(2 + row * (n + 1) + column)); }
    static Vec3 position(const Part& part, Id id)
    {
        return part.particles[std::size_t(std::uint32_t(id) - 2)].position;
    }
};

struct Shop
{
    Document document;
    Selection selection{document};
    Player player{document};
    MainWindow window{document, selection, player, MainWindow::Memory::Ignore};
    Viewport& viewport = window.viewport();

    explicit Shop(Scene scene)
    {
        document.replace(std::move(scene));
        window.show();
        window.showScene();
        viewport.setOrthographic(true);
        viewport.setFollow(false);
        viewport.view(PresetView::Front);
        (void)QTest::qWaitForWindowExposed(&window);
    }

    void run(const char* id) { window.actions()[id]->trigger(); }
    const Frame& frame() const { return *player.frame(); }

    // In the picture, pixels.
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
    QLineEdit* field(const char* name)
    {
        for (QLineEdit* edit : viewport.findChildren<QLineEdit*>(QLatin1String(name)))
            return edit;
        return nullptr;
    }
    void type(const char* name, const QString& text)
    {
        QLineEdit* edit = field(name);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
};

// Runs a test whose windows have a 3D view.
template <typename Test>
int runWithView(int argc, char** argv)
{
    QSurfaceFormat format;
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format); // before the application exists
    QApplication application(argc, argv);
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace ripstop
