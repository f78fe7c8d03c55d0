// The mesh as it will be imported, seen along parallel rays: a drag or the arrow keys turn it, the
// wheel zooms, a double click shows all of it. It is drawn without a graphics card (mesh_raster.h),
// so that the dialog works wherever the window does. Only the window's thread uses it.
#pragma once

#include "import/mesh_raster.h"

#include <QWidget>

#include <memory>

namespace ripstop {

class MeshPreview final : public QWidget
{
    Q_OBJECT

public:
    explicit MeshPreview(QWidget* parent = nullptr);

    void setMesh(std::shared_ptr<const PreparedMesh> mesh); // null shows the hint instead
    void mark(std::vector<Vec3> places);                    // m, shown as rings
    void setHint(const QString& hint);                      // shown while there is no mesh

    QSize sizeHint() const override { return {460, 380}; }
    QSize minimumSizeHint() const override { return {280, 220}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void turnBy(double around, double over); // degrees
    void fit(); // chooses the middle and the zoom that show all, as it is turned now
    Eigen::Matrix3d turn() const;
    MeshCamera camera(const QSize& size) const;

    std::shared_ptr<const PreparedMesh> m_mesh;
    std::vector<Vec3> m_marks;
    QString m_hint;
    Vec3 m_middle = Vec3::Zero();      // m
    Eigen::Vector2d m_reach{1.0, 1.0}; // m, to the right and up, of what is shown at zoom 1
    double m_around = 35.0;            // degrees about the vertical
    double m_over = 25.0;              // degrees from which it is looked down on
    double m_zoom = 1.0;
    QPointF m_last; // px, where the drag was last
};

} // namespace ripstop
