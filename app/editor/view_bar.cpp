// settle() gives a bar its place: as wide as its words in one line, where that leaves the strip of
// tools free, else from the strip to the other edge with its words in several lines.
#include "editor/view_bar.h"

#include "icons/complaint.h"
#include "start/parameter_field.h"
#include "tools/tool_strip.h"
#include "viewport/viewport.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QLabel>
#include <QLayout>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int fromEdge = 10;    // pixels, from the lower edge of the view, and from its sides
constexpr int fieldWidth = 110; // pixels, of a number with its unit
constexpr int bareWidth = 75;   // pixels, of one that has none

} // namespace

ViewBar::ViewBar(Viewport& viewport, const QString& name)
    : QFrame(&viewport)
    , m_viewport(viewport)
    , m_hint(new QLabel)
    , m_complaint(new Complaint(this))
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
    m_complaint->tell(refusal());
    for (QLabel* words : {m_hint, static_cast<QLabel*>(m_complaint)})
        words->setWordWrap(false);
    layout()->activate();
    QRect place(QPoint(), layout()->totalSizeHint());
    place.moveLeft(std::max((m_viewport.width() - place.width()) / 2, fromEdge));
    place.moveTop(m_viewport.height() - fromEdge - place.height());
    place.moveLeft(besideTools(m_viewport, place));
    if (place.x() + place.width() > m_viewport.width() - fromEdge)
        place = inSeveralLines();
    setGeometry(place);
    raise();
    tellView();
}

QString ViewBar::refusal() const
{
    const auto wrong = std::ranges::find_if(m_numbers, [this](const ParameterField* number) {
        return number->isVisibleTo(this) && !number->refusal().isEmpty();
    });
    return wrong == m_numbers.end() ? QString() : (*wrong)->refusal();
}

// From the strip of tools, wherever it ends, to the other edge; over the strip only where the view
// has no room for the fields otherwise.
QRect ViewBar::inSeveralLines()
{
    for (QLabel* words : {m_hint, static_cast<QLabel*>(m_complaint)})
        words->setWordWrap(true);
    layout()->activate();
    const int right = m_viewport.width() - fromEdge;
    const int least = layout()->totalMinimumSize().width();
    int left = besideTools(m_viewport, {fromEdge, 0, right, m_viewport.height()});
    if (right - left < least)
        left = fromEdge;
    const int width = std::max(right - left, least);
    const int height = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width)
                                                     : layout()->totalSizeHint().height();
    return {left, m_viewport.height() - fromEdge - height, width, height};
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
    number->setMaximumWidth(parameter.unit.empty() ? bareWidth : fieldWidth);
    m_numbers.push_back(number);
    connect(number, &ParameterField::changed, this, [this, number, take] {
        if (number->isInRange())
            take(number->value());
        if (isVisible())
            settle();
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
