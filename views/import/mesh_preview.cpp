// fit() measures the mesh as it is turned and puts the camera so that all of it shows. paintEvent()
// has the mesh drawn in device pixels, then draws rings around marked places and the axes of the
// scene in a corner with the same camera. Mouse, wheel and keys change only the two angles and the
// zoom.
#include "import/mesh_preview.h"

#include <Eigen/Geometry>

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

constexpr double perPixel = 0.5; // degrees
constexpr double perKey = 10.0;  // degrees
constexpr double margin = 0.86;  // of the widget that the mesh fills

MeshLook lookOf(const QPalette& palette)
{
    const QColor base = palette.color(QPalette::Base);
    const bool isDark = base.lightness() < 128;
    return {base,
            QColor(0x5b, 0x9b, 0xc8),
            QColor(0xd8, 0xa0, 0x4a),
            isDark ? QColor(0x1c, 0x2b, 0x36) : QColor(0x2c, 0x4a, 0x5e),
            palette.color(QPalette::Text),
            QColor(0xd6, 0x2f, 0x2f)};
}

} // namespace

MeshPreview::MeshPreview(QWidget* parent)
    : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::OpenHandCursor);
    setAccessibleName(tr("Preview"));
    setToolTip(tr("Drag or use the arrow keys to turn, the wheel to zoom; a double click shows "
                  "all. Blue is the front of the fabric, ochre its back."));
}

void MeshPreview::setMesh(std::shared_ptr<const PreparedMesh> mesh)
{
    m_mesh = std::move(mesh);
    m_marks.clear();
    fit();
}

void MeshPreview::fit()
{
    m_zoom = 1.0;
    const double infinity = std::numeric_limits<double>::infinity();
    Vec3 low = Vec3::Constant(infinity); // in the frame of the camera
    Vec3 high = -low;
    if (m_mesh)
        for (const RepairedMesh& surface : m_mesh->surfaces)
            for (const Vec3& point : surface.mesh.points) {
                const Vec3 seen = turn() * point;
                low = low.cwiseMin(seen);
                high = high.cwiseMax(seen);
            }
    if (m_mesh) {
        m_middle = turn().transpose() * (0.5 * (low + high));
        m_reach = (0.5 * (high - low).head<2>()).cwiseMax(1e-9);
    }
    update();
}

void MeshPreview::mark(std::vector<Vec3> places)
{
    m_marks = std::move(places);
    update();
}

void MeshPreview::setHint(const QString& hint)
{
    m_hint = hint;
    update();
}

Eigen::Matrix3d MeshPreview::turn() const
{
    constexpr double degree = std::numbers::pi / 180.0;
    return (Eigen::AngleAxisd(m_over * degree, Vec3::UnitX())
            * Eigen::AngleAxisd(-m_around * degree, Vec3::UnitY()))
        .toRotationMatrix();
}

MeshCamera MeshPreview::camera(const QSize& size) const
{
    MeshCamera camera;
    camera.turn = turn();
    camera.middle = m_middle;
    camera.scale =
        m_zoom * margin * 0.5 * std::min(size.width() / m_reach.x(), size.height() / m_reach.y());
    return camera;
}

void MeshPreview::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const MeshLook look = lookOf(palette());
    if (!m_mesh) {
        painter.fillRect(rect(), look.ground);
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                         m_hint);
        return;
    }
    const double ratio = devicePixelRatioF();
    const QSize pixels = size() * ratio;
    QImage image = drawMesh(*m_mesh, camera(pixels), pixels, look);
    image.setDevicePixelRatio(ratio);
    painter.drawImage(0, 0, image);

    const MeshCamera here = camera(size());
    painter.setPen(QPen(look.trouble, 2.0));
    for (const Vec3& place : m_marks) {
        const Vec3 at = here.project(place, size());
        painter.drawEllipse(QPointF(at.x(), at.y()), 6.0, 6.0);
    }

    // how the mesh stands: the axes of the scene in a corner
    const QPointF corner(34.0, height() - 34.0);
    const char* const names[]{"x", "y", "z"};
    const QColor colors[]{QColor(0xd6, 0x4b, 0x4b), QColor(0x4c, 0xa8, 0x57),
                          QColor(0x4b, 0x78, 0xd6)};
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 along = 22.0 * (here.turn * Vec3::Unit(axis));
        painter.setPen(QPen(colors[axis], 2.0));
        const QPointF end = corner + QPointF(along.x(), -along.y());
        painter.drawLine(corner, end);
        painter.drawText(end + QPointF(along.x(), -along.y()) * 0.2 - QPointF(3.0, -4.0),
                         QLatin1String(names[axis]));
    }
}

void MeshPreview::turnBy(double around, double over)
{
    m_around = std::remainder(m_around + around, 360.0);
    m_over = std::clamp(m_over + over, -90.0, 90.0);
    update();
}

void MeshPreview::mousePressEvent(QMouseEvent* event) { m_last = event->position(); }

void MeshPreview::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF way = event->position() - m_last;
    m_last = event->position();
    turnBy(-perPixel * way.x(), perPixel * way.y());
}

void MeshPreview::mouseDoubleClickEvent(QMouseEvent*) { fit(); }

void MeshPreview::wheelEvent(QWheelEvent* event)
{
    m_zoom = std::clamp(m_zoom * std::pow(1.2, event->angleDelta().y() / 120.0), 0.1, 200.0);
    update();
    event->accept();
}

void MeshPreview::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Left:
        return turnBy(perKey, 0.0);
    case Qt::Key_Right:
        return turnBy(-perKey, 0.0);
    case Qt::Key_Up:
        return turnBy(0.0, perKey);
    case Qt::Key_Down:
        return turnBy(0.0, -perKey);
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace ripstop
