// A small picture of a mesh, drawn without a graphics card: each triangle in one shade, the front
// and the back in two colours, so that what is turned the wrong way shows.
#pragma once

#include "author/mesh_import.h"

#include <QColor>
#include <QImage>

namespace ripstop {

struct MeshLook
{
    QColor ground;
    QColor front;
    QColor back;
    QColor edge;    // of meshes that are not too fine to show them
    QColor rim;     // edges of one face
    QColor trouble; // edges of more than two faces
};

// Parallel rays. `turn` brings the mesh before the eye, which looks along -z.
struct MeshCamera
{
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Vec3 middle = Vec3::Zero(); // m, in the middle of the picture
    double scale = 1.0;         // px/m

    // Where a point is in a picture of this size, px, and how near it is to the eye, m.
    Vec3 project(const Vec3& point, const QSize& size) const;
};

QImage drawMesh(const PreparedMesh& mesh, const MeshCamera& camera, const QSize& size,
                const MeshLook& look);

} // namespace ripstop
