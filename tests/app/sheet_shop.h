// A square sheet whose places and ids are known by row and column, and the whole window around it
// with the camera in front and a mouse: for tests of hands and tools.
//
// A test makes a Shop of a Sheet, and has to run by runWithView(), since the window has a 3D view.
#pragma once

#include "app/window_shop.h"
#include "icons/complaint.h"
#include "views/small_scenes.h"

#include <QLineEdit>
#include <QtTest>

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

struct Shop : WindowShop
{
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
    QString complaint() const // of a bar in the view; empty without any
    {
        for (const Complaint* complaint : viewport.findChildren<Complaint*>())
            if (complaint->isVisible())
                return complaint->text();
        return {};
    }
};

} // namespace ripstop
