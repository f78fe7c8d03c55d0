// VTK draws into a framebuffer of its own in the OpenGL context of the widget; ContextBridge
// answers VTK whether that context is current. paintGL() renders anew only when the picture is old
// and then copies the framebuffer to that of Qt, so that painting something above the widget costs
// a copy alone.
//
// Where OpenGL runs in software, pictures in motion are drawn without smooth edges; a timer asks
// for one with them when nothing has changed for a while.
//
// picture(size) renders at another size for files and leaves the widget to paint itself again.
#include "viewport/vtk_widget.h"

#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QString>

#include <vtkCommand.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkUnsignedCharArray.h>

#include <utility>

namespace ripstop {
namespace {

constexpr int samples = 4;     // per pixel, for smooth edges
constexpr int stillTime = 250; // ms

bool drawsInSoftware(QOpenGLFunctions& gl)
{
    const auto* name = reinterpret_cast<const char*>(gl.glGetString(GL_RENDERER));
    const QString renderer = QString::fromLatin1(name);
    return renderer.contains("llvmpipe") || renderer.contains("softpipe")
           || renderer.contains("SWR");
}

// VTK asks these two questions many times per picture.
struct ContextBridge : vtkCommand
{
    static ContextBridge* New() { return new ContextBridge; }

    void Execute(vtkObject*, unsigned long event, void* data) override
    {
        QOpenGLContext* context = widget->context();
        const bool current = context && QOpenGLContext::currentContext() == context;
        if (event == vtkCommand::WindowIsCurrentEvent)
            *static_cast<bool*>(data) = current;
        else if (context && !current)
            // Not widget->makeCurrent(): that also binds Qt's framebuffer, behind the back of
            // VTK's record of what is bound, and VTK then draws into the wrong one.
            context->makeCurrent(context->surface());
    }

    QOpenGLWidget* widget = nullptr;
};

} // namespace

VtkWidget::VtkWidget(QWidget* parent)
    : QOpenGLWidget(parent)
{
    vtkNew<ContextBridge> bridge;
    bridge->widget = this;
    m_window->AddObserver(vtkCommand::WindowMakeCurrentEvent, bridge);
    m_window->AddObserver(vtkCommand::WindowIsCurrentEvent, bridge);
    m_window->SetOwnContext(false);
    m_window->SetReadyForRendering(false); // until initializeGL() has run
    m_window->SetFrameBlitModeToNoBlit();  // paintGL() copies the picture
    m_still.setSingleShot(true);
    m_still.setInterval(stillTime);
    connect(&m_still, &QTimer::timeout, this, [this] {
        m_isFine = m_isOld = true;
        update();
    });
}

VtkWidget::~VtkWidget()
{
    disconnect(m_contextDies);
    if (context())
        release();
    m_window->RemoveAllObservers();
}

// VTK must let go of its buffers while their context is still there.
void VtkWidget::release()
{
    makeCurrent();
    m_window->Finalize();
    m_window->SetReadyForRendering(false);
    doneCurrent();
}

// Also called again after the widget has moved to another window: Qt then makes a new context.
void VtkWidget::initializeGL()
{
    m_window->SetReadyForRendering(true);
    m_window->OpenGLInitContext();
    m_isSoftware = drawsInSoftware(*context()->functions());
    m_isOld = true;
    m_contextDies =
        connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &VtkWidget::release);
}

void VtkWidget::resizeGL(int width, int height)
{
    const QSize pixels = QSize(width, height) * devicePixelRatioF();
    m_window->SetSize(pixels.width(), pixels.height());
    m_isOld = true;
}

void VtkWidget::renderSoon()
{
    m_isOld = true;
    m_isFine = !m_isSoftware;
    update();
}

QImage VtkWidget::picture()
{
    m_isOld |= !m_isFine;
    m_isFine = true;
    return grabFramebuffer(); // this paints the picture first
}

QImage VtkWidget::picture(QSize size, Backdrop backdrop)
{
    makeCurrent();
    if (beforePainting)
        beforePainting();
    const int* const old = m_window->GetSize();
    const QSize before(old[0], old[1]);
    m_window->SetSize(size.width(), size.height());
    m_window->SetMultiSamples(samples);
    m_window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    constexpr int front = 0;
    m_window->GetRGBACharPixelData(0, 0, size.width() - 1, size.height() - 1, front, pixels);
    m_window->SetSize(before.width(), before.height());
    doneCurrent();
    m_isOld = true; // at the next paint, not now: a film takes one picture after the other

    const QImage upsideDown(pixels->GetPointer(0), size.width(), size.height(),
                            QImage::Format_RGBA8888_Premultiplied);
    QImage picture = upsideDown.mirrored();
    if (backdrop == Backdrop::Transparent)
        return picture;
    picture.reinterpretAsFormat(QImage::Format_RGBX8888); // VTK leaves alpha 0 in the background
    return picture;
}

void VtkWidget::paintGL()
{
    if (std::exchange(m_isOld, false)) {
        if (beforePainting)
            beforePainting();
        m_window->SetMultiSamples(m_isFine ? samples : 0);
        m_window->Render();
        if (!m_isFine)
            m_still.start();
    }
    copyToWidget();
}

void VtkWidget::copyToWidget()
{
    QOpenGLExtraFunctions* gl = context()->extraFunctions();
    const GLenum target = GL_COLOR_ATTACHMENT0;
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    gl->glDrawBuffers(1, &target);
    const int* size = m_window->GetRenderFramebuffer()->GetLastSize();
    m_window->BlitDisplayFramebuffer(0, 0, 0, size[0], size[1], 0, 0, size[0], size[1],
                                     GL_COLOR_BUFFER_BIT, GL_NEAREST);

    // VTK leaves alpha 0 in the background, through which the desktop would shine.
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    vtkOpenGLState* state = m_window->GetState();
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglColorMask(false, false, false, true);
    state->vtkglClearColor(0, 0, 0, 1);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
    state->vtkglColorMask(true, true, true, true);
}

} // namespace ripstop
