// A Qt widget that shows a VTK render window. It only paints: the mouse belongs to its parent.
//
// VTK has such a widget of its own, but a packaged VTK is often built against another major version
// of Qt than ours; this one needs nothing of VTK beyond its OpenGL backend. As every widget it
// belongs to the thread of the window; renderSoon() is cheap and may be called many times between
// two pictures.
#pragma once

#include "look/backdrop.h"

#include <QOpenGLWidget>
#include <QTimer>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <functional>

namespace ripstop {

class VtkWidget final : public QOpenGLWidget
{
    Q_OBJECT

public:
    explicit VtkWidget(QWidget* parent = nullptr);
    ~VtkWidget() override;

    vtkRenderWindow& window() { return *m_window.Get(); }

    // Known from the first picture on.

    // What is to be seen has changed: a new picture, soon. A mere update() shows the last one
    // again, as Qt asks for whenever something above this widget is painted.
    void renderSoon();

    // The picture as it is seen when nothing moves, with smooth edges, in device pixels.
    QImage picture();

    // Renders the view in another size, in pixels. What the backdrop leaves out is transparent.
    QImage picture(QSize size, Backdrop backdrop);

    // Called before each new picture, so that many changes between two pictures cost one.
    std::function<void()> beforePainting;

protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;

private:
    void copyToWidget();
    void release();

    vtkNew<vtkGenericOpenGLRenderWindow> m_window;
    QMetaObject::Connection m_contextDies;
    bool m_isOld = true;       // the last picture is out of date
    bool m_isFine = true;      // the picture has smooth edges
    bool m_isSoftware = false; // OpenGL runs in software, so each sample costs
    QTimer m_still;            // runs out when the picture has not changed for a while
};

} // namespace ripstop
