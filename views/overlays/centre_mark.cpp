// Changes of document and selection only mark the masses as old. show() is called for each picture
// and weighs again when they are; weigh() notes the mass of each particle of the layout, 0 for
// those that are not meant. place() sums up mass times place of the frame. paintEvent() draws the
// sign and the card with the mass beside it, in grams below one kilogram.
#include "overlays/centre_mark.h"

#include "document/document.h"
#include "document/selection.h"
#include "document/spoken.h"
#include "document/words.h"
#include "shaping/movable.h"

#include <QPainter>

#include <algorithm>
#include <numeric>

namespace ripstop {
namespace {

constexpr double radius = 8.0; // pixels
constexpr int quarter = 90 * 16;

} // namespace

CentreMark::CentreMark(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_selection(selection)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
    const auto renew = [this] {
        m_weighed.reset();
        update();
    };
    connect(&document, &Document::changed, this, renew);
    connect(&document, &Document::replaced, this, renew);
    connect(&selection, &Selection::changed, this, renew);
}

void CentreMark::setMarked(bool marked)
{
    m_marked = marked;
    setVisible(marked);
}

void CentreMark::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

void CentreMark::show(const std::shared_ptr<const Frame>& frame, const Camera& camera)
{
    if (!m_marked || !frame)
        return;
    setGeometry(parentWidget()->rect());
    m_frame = frame;
    m_camera = camera;
    if (m_weighed != frame->layout)
        weigh();
    update();
}

// Masses are those of the scene, found by id. A twin that a tear has made has the id of whom it
// came from, so it counts with the authored mass as well.
void CentreMark::weigh()
{
    const std::vector<Id> meant = particlesOf(m_document.scene(), m_selection.ids());
    const std::vector<std::uint32_t>& ids = m_frame->layout->particleId;
    m_mass.assign(ids.size(), 0.0);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (!meant.empty() && !std::ranges::binary_search(meant, Id{ids[i]}))
            continue;
        const auto ref = ripstop::find(m_document.scene(), Id{ids[i]});
        if (const auto* row = ref ? std::get_if<const Particle*>(&*ref) : nullptr)
            m_mass[i] = (*row)->mass;
    }
    m_total = std::accumulate(m_mass.begin(), m_mass.end(), 0.0);
    m_weighed = m_frame->layout;
}

std::optional<Vec3> CentreMark::place() const
{
    if (!m_frame || m_total <= 0.0 || m_mass.size() != m_frame->position.size())
        return std::nullopt;
    Vec3 moment = Vec3::Zero();
    for (std::size_t i = 0; i < m_mass.size(); ++i)
        moment += m_mass[i] * m_frame->position[i];
    return moment / m_total;
}

// The sign of drawings: a circle of two light and two dark quarters.
void CentreMark::paintEvent(QPaintEvent*)
{
    if (m_frame && m_weighed != m_frame->layout)
        weigh();
    const auto centre = place();
    const auto pixel =
        centre ? CameraProjection{m_camera, double(width()), double(height())}.pixel(*centre)
               : std::nullopt;
    if (!pixel)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF circle(pixel->x() - radius, pixel->y() - radius, 2.0 * radius, 2.0 * radius);
    painter.setPen(Qt::NoPen);
    for (int i = 0; i < 4; ++i) {
        painter.setBrush(i % 2 == 0 ? Qt::black : QColor(0xff, 0xd6, 0x4a));
        painter.drawPie(circle, i * quarter, quarter);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_theme.isDark() ? Qt::white : Qt::black, 1.5));
    painter.drawEllipse(circle);

    const QString text = spokenText(m_total, "kg");
    QRectF card = painter.fontMetrics().boundingRect(text).adjusted(-6, -2, 6, 2);
    card.moveTopLeft(*pixel + QPointF(radius + 4.0, radius + 2.0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.card);
    painter.drawRoundedRect(card, 3.0, 3.0);
    painter.setPen(m_theme.text);
    painter.drawText(card, Qt::AlignCenter, text);
}

} // namespace ripstop
