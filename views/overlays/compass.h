// Shows in the corner of the view which way the axes point and where the wind blows.
//
// The wind is an arrow across a level ring, with its speed below, and with how wide the squares on
// the ground are, on a card. The viewport places the widget, tells it the camera and the mean wind
// of the frame, and it paints only when one of them has changed.
#pragma once

#include "camera/camera.h"
#include "look/theme.h"

#include <QWidget>

namespace ripstop {

class Compass final : public QWidget
{
    Q_OBJECT

public:
    explicit Compass(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void setCamera(const Camera& camera);
    void setWind(const Vec3& velocity); // m/s
    void setWindShown(bool shown);
    void setSquares(double metres); // of the ground, 0 for none

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QPointF onScreen(const Vec3& direction) const; // pixel of a point of the unit sphere
    void paintRing(QPainter& painter) const;
    void paintAxes(QPainter& painter) const;
    void paintWind(QPainter& painter) const;
    void paintWords(QPainter& painter) const;
    QString windWords() const;

    Theme m_theme = Theme::light();
    Camera m_camera;
    Vec3 m_wind = Vec3::Zero(); // m/s
    bool m_windShown = true;
    double m_squares = 0.0; // m
};

} // namespace ripstop
