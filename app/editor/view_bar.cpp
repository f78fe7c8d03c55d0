#include "editor/view_bar.h"

#include "start/parameter_field.h"
#include "viewport/viewport.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QLayout>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int fromLowerEdge = 10; // pixels, from the lower edge of the view
constexpr int fieldWidth = 110;   // pixels

} // namespace

ViewBar::ViewBar(Viewport& viewport, const QString& name)
    : QFrame(&viewport)
    , m_viewport(viewport)
{
    setObjectName(name);
    setAutoFillBackground(true);
    setFrameShape(QFrame::StyledPanel);
    setAttribute(Qt::WA_NoMousePropagation); // clicks beside its fields are not for the view
    hide();
    viewport.installEventFilter(this);
}

void ViewBar::settle()
{
    layout()->activate();
    adjustSize();
    move(std::max((m_viewport.width() - width()) / 2, 0),
         m_viewport.height() - height() - fromLowerEdge);
    raise();
    tellView();
}

void ViewBar::hideEvent(QHideEvent* event)
{
    QFrame::hideEvent(event);
    tellView();
}

// What lies over the view makes room for the bar, once it is where it will be.
void ViewBar::tellView()
{
    QCoreApplication::postEvent(&m_viewport, new QEvent(QEvent::LayoutRequest));
}

QComboBox* ViewBar::chooser(const QString& name, const QString& help, const QStringList& choices,
                            int chosen, const std::function<void(int)>& choose)
{
    auto* box = new QComboBox;
    box->addItems(choices);
    box->setCurrentIndex(chosen);
    box->setToolTip(help);
    box->setAccessibleName(name);
    connect(box, &QComboBox::activated, this, choose);
    return box;
}

ParameterField* ViewBar::numberField(const Parameter& parameter, double value,
                                     const std::function<void(double)>& take)
{
    auto* number = new ParameterField(parameter);
    number->setValue(value);
    number->setMaximumWidth(fieldWidth);
    connect(number, &ParameterField::changed, this, [number, take] {
        if (number->isInRange())
            take(number->value());
    });
    return number;
}

bool ViewBar::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &m_viewport && event->type() == QEvent::Resize && isVisible())
        settle();
    return QFrame::eventFilter(watched, event);
}

} // namespace ripstop
