// A small picture of a mesh, drawn without a graphics card: each triangle in one shade, the front
// and the back in two colours, so that faces which are turned the wrong way show. Pure functions:
// any thread may call them. The preview of the import uses them.
#pragma once

#include "author/mesh_import.h"

#include <QColor>
#include <QImage>

namespace ripstop {

// The colours of the picture.
struct MeshLook
{
    QColor ground;
    QColor front;
    QColor back;
    QColor edge;    // of meshes that are not too fine to show them
    QColor rim;     // edges of one face, and lines beside the faces
    QColor trouble; // edges of more than two faces
};

// A camera with parallel rays. `turn` takes the mesh into its frame: x to the right, y up, and it
// looks along -z.
struct MeshCamera
{
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Vec3 middle = Vec3::Zero(); // m, in the middle of the picture
    double scale = 1.0;         // px/m

    // Where a point, m, is in a picture of this size: x to the right and y down from the corner,
    // and z towards the camera, all in px.
    Vec3 project(const Vec3& point, const QSize& size) const;
};

// A picture of `size`, px, without any scaling for the screen.
QImage drawMesh(const PreparedMesh& mesh, const MeshCamera& camera, const QSize& size,
                const MeshLook& look);

} // namespace ripstop
