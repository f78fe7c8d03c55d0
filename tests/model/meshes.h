// Meshes for tests, and short ways from the text of a file to fabric.
//
// Expected numbers are those of the shapes: a cube has 8 corners and 6 sides, so 12 triangles and,
// by Euler (corners - edges + faces = 2), 18 edges of triangles or 12 of squares.
#pragma once

#include "author/mesh_import.h"
#include "shapes/mesh_file.h"
#include "shapes/obj_file.h"

#include <Eigen/Geometry>

#include <QByteArray>
#include <QFile>
#include <QString>
#include <QTemporaryDir>
#include <QtGlobal>

#include <algorithm>
#include <cmath>

namespace ripstop {

inline const char* const cubeOfQuads = "o cube\n"
                                       "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                       "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                                       "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\n"
                                       "f 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

// The same cube as twelve separate triangles; bottom and top swapped when `isInsideOut`.
inline QByteArray cubeAsStl(bool isInsideOut = false)
{
    const auto cube = readObj(cubeOfQuads, "cube");
    QByteArray text = "solid cube\n";
    for (std::size_t i = 0; i < cube->faceCount(); ++i) {
        const auto quad = cube->face(i);
        for (std::array<int, 3> corner : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
            if (isInsideOut)
                std::swap(corner[1], corner[2]);
            text += "facet normal 0 0 0\nouter loop\n";
            for (const int c : corner) {
                const Vec3& p = cube->points[std::size_t(quad[std::size_t(c)])];
                text +=
                    QStringLiteral("vertex %1 %2 %3\n").arg(p.x()).arg(p.y()).arg(p.z()).toUtf8();
            }
            text += "endloop\nendfacet\n";
        }
    }
    return text + "endsolid cube\n";
}

inline PolygonMesh meshOf(const char* obj)
{
    Result<PolygonMesh> mesh = readObj(obj, "test");
    if (!mesh)
        qFatal("%s", mesh.message().english().c_str());
    return *mesh;
}

inline PreparedMesh preparedOf(const PolygonMesh& mesh, const MeshShape& shape = {})
{
    Result<PreparedMesh> result = prepared(mesh, shape);
    if (!result)
        qFatal("%s", result.message().english().c_str());
    return *result;
}

// Fabric of threads, with no other choice made: it has rods along its edges.
inline MeshFabric plainFabric(double density = 0.1)
{
    MeshFabric fabric;
    fabric.carrier = FabricKind::Threads;
    fabric.material.membraneStiffness = 1000.0;
    fabric.material.shearStiffness = 100.0;
    fabric.material.arealDensity = density;
    return fabric;
}

inline MeshImport importOf(const PreparedMesh& mesh, const MeshFabric& fabric = plainFabric(),
                           const Scene& scene = {})
{
    Result<MeshImport> result = fabricOf(mesh, fabric, "sail", surroundingsOf(scene));
    if (!result)
        qFatal("%s", result.message().english().c_str());
    return *result;
}

inline Scene sceneOf(const PreparedMesh& mesh, const MeshFabric& fabric = plainFabric())
{
    Scene scene;
    (void)apply(scene, importOf(mesh, fabric).edit);
    return scene;
}

inline Part firstPart(const Scene& scene)
{
    for (const Entry& entry : scene.items)
        if (const Part* part = std::get_if<Part>(&entry.item))
            return *part;
    qFatal("no part");
}

inline std::size_t countOf(const Part& part, LinkRole role)
{
    return std::size_t(std::ranges::count(part.links, role, &Link::role));
}

// A sheet of n x n squares of 0.1 m in the plane z = 0, as triangles whose corners lie up to a
// quarter of a square off, without a texture; faces look along z.
inline std::string unevenSheet(int n)
{
    std::string text;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            text += "v " + std::to_string(0.1 * i + 0.025 * std::sin(17.0 * i + 29.0 * j)) + " "
                    + std::to_string(0.1 * j + 0.025 * std::cos(23.0 * i + 13.0 * j)) + " 0\n";
    const auto corner = [n](int i, int j) { return " " + std::to_string(j * (n + 1) + i + 1); };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const std::string a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                              d = corner(i, j + 1);
            text += (i + j) % 2 == 0 ? "f" + a + b + c + "\nf" + c + d + a + "\n"
                                     : "f" + b + c + d + "\nf" + d + a + b + "\n";
        }
    return text;
}

// A sheet of n x n squares of this size, in the plane z = 0, as quads or as triangles.
inline std::string sheet(int n, double size, bool quads)
{
    std::string text;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            text += "v " + std::to_string(size * i) + " " + std::to_string(size * j) + " 0\n";
            text +=
                "vt " + std::to_string(double(i) / n) + " " + std::to_string(double(j) / n) + "\n";
        }
    const auto corner = [n](int i, int j) {
        const std::string at = std::to_string(j * (n + 1) + i + 1);
        return " " + at + "/" + at;
    };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const std::string a = corner(i, j);
            const std::string b = corner(i + 1, j);
            const std::string c = corner(i + 1, j + 1);
            const std::string d = corner(i, j + 1);
            text += quads ? "f" + a + b + c + d + "\n" : "f" + a + b + c + "\nf" + a + c + d + "\n";
        }
    return text;
}

inline double areaOfTriangles(const RepairedMesh& surface)
{
    double area = 0.0;
    for (const auto& triangle : surface.triangles)
        area += 0.5 * doubleArea(triangle, surface.mesh.points).norm();
    return area;
}

// A glTF of one triangle with a picture on it.
inline QByteArray texturedTriangle(const QByteArray& picture)
{
    QByteArray corners; // three of three floats, as three of two and so many bytes more
    for (const float number : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F})
        corners.append(reinterpret_cast<const char*>(&number), sizeof number);
    QByteArray gltf =
        "{'asset':{'version':'2.0'},'scene':0,'scenes':[{'nodes':[0]}],'nodes':[{'mesh':0}],"
        "'meshes':[{'primitives':[{'attributes':{'POSITION':0,'TEXCOORD_0':1},'material':0}]}],"
        "'materials':[{'name':'sail','pbrMetallicRoughness':{'baseColorTexture':{'index':0}}}],"
        "'textures':[{'source':0}],'images':[{'uri':'PICTURE'}],"
        "'accessors':[{'bufferView':0,'componentType':5126,'count':3,'type':'VEC3',"
        "'min':[0,0,0],'max':[1,1,0]},{'bufferView':0,'componentType':5126,'count':3,"
        "'type':'VEC2'}],'bufferViews':[{'buffer':0,'byteLength':36}],"
        "'buffers':[{'byteLength':36,'uri':'data:application/octet-stream;base64,"
        + corners.toBase64() + "'}]}";
    gltf.replace('\'', '"');
    return gltf.replace("PICTURE", picture);
}

// A PNG of one red point.
inline QByteArray redPoint()
{
    return QByteArray::fromBase64("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJ"
                                  "AAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==");
}

// The same triangle, with what says it is a PNG within the file.
inline QByteArray trianglePackedWith(const QByteArray& picture)
{
    return texturedTriangle("data:image/png;base64," + picture.toBase64());
}

// Writes a file and answers its path.
inline QString writeFile(const QString& path, const QByteArray& content)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        qFatal("cannot write %s", qPrintable(path));
    return path;
}

// A folder of its own for the mesh files of a test.
class MeshFolder
{
protected:
    QString write(const QString& name, const QByteArray& content)
    {
        return writeFile(m_folder.filePath(name), content);
    }

    PolygonMesh fileOf(const QString& name, const QByteArray& content)
    {
        Result<PolygonMesh> mesh = readPolygonFile(write(name, content).toStdString());
        if (!mesh)
            qFatal("%s", mesh.message().english().c_str());
        return *mesh;
    }

    QTemporaryDir m_folder;
};

} // namespace ripstop
