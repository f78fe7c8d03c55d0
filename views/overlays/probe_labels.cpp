// Edits mark the cards as old; collect() then sorts the probes of the scene by target. show() takes
// frame and camera of each picture. paintEvent() makes the text of each card from the frame, finds
// the middle of its target in the picture, and moves the card down while it lies over one that is
// painted already.
#include "overlays/probe_labels.h"

#include "base/quantity.h"
#include "document/document.h"
#include "document/spoken.h"
#include "look/element_places.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr int corner = 12; // pixels, from the edge of the view
constexpr int aside = 10;  // pixels, from what is measured
constexpr int padding = 6; // pixels
constexpr int dot = 3;     // pixels

Vec3 middleOf(const std::vector<Vec3>& places)
{
    Vec3 sum = Vec3::Zero();
    for (const Vec3& place : places)
        sum += place;
    return sum / double(places.size());
}

} // namespace

ProbeLabels::ProbeLabels(Document& document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
    const auto renew = [this] {
        m_old = true;
        update();
    };
    connect(&document, &Document::changed, this, renew);
    connect(&document, &Document::replaced, this, renew);
}

void ProbeLabels::setWanted(bool wanted) { setVisible(wanted); }

void ProbeLabels::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

void ProbeLabels::show(const std::shared_ptr<const Frame>& frame, const Camera& camera)
{
    if (isHidden() || !frame)
        return;
    setGeometry(parentWidget()->rect());
    m_frame = frame;
    m_camera = camera;
    update();
}

void ProbeLabels::collect()
{
    m_cards.clear();
    m_old = false;
    for (const Entry& entry : m_document.scene().items) {
        const Probe* probe = std::get_if<Probe>(&entry.item);
        if (!probe)
            continue;
        const auto of = rowOf(probe->quantity).of;
        const bool isWhole = of == QuantityRow::Of::Whole || of == QuantityRow::Of::Probes;
        const Id target = isWhole ? noId : probe->target;
        auto card = std::ranges::find(m_cards, target, &Card::target);
        if (card == m_cards.end()) {
            m_cards.push_back({target, {}});
            card = m_cards.end() - 1;
        }
        card->probes.push_back(entry.id);
    }
}

QStringList ProbeLabels::linesOf(Id target) const
{
    QStringList lines;
    const auto card = std::ranges::find(m_cards, target, &Card::target);
    if (!m_frame || card == m_cards.end())
        return lines;
    const auto& probes = m_frame->layout->probes;
    for (const Id id : card->probes) {
        const auto row = std::ranges::find(probes, std::uint32_t(id), &Layout::Probe::id);
        if (row == probes.end())
            continue;
        const double value = m_frame->probe[std::size_t(row - probes.begin())];
        const auto* probe = findItem<Probe>(m_document.scene(), id);
        const Quantity quantity = probe ? probe->quantity : Quantity::Formula;
        // another name makes no other system, so that frames may have the one of before
        const std::string& name = probe ? probe->name : row->name;
        lines << QString::fromStdString(name) + "  " + readingText(quantity, value, row->unit);
    }
    return lines;
}

void ProbeLabels::paintEvent(QPaintEvent*)
{
    if (!m_frame)
        return;
    if (m_old)
        collect();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const CameraProjection projection{m_camera, double(width()), double(height())};
    const QFontMetrics metrics = painter.fontMetrics();
    std::vector<QRect> taken;
    for (const Card& card : m_cards) {
        const QString text = linesOf(card.target).join('\n');
        if (text.isEmpty())
            continue;
        QRect box = metrics.boundingRect(QRect(0, 0, width(), height()), Qt::AlignLeft, text)
                        .adjusted(-padding, -padding / 2, padding, padding / 2);
        if (card.target == noId) {
            box.moveTopLeft({corner + 48, corner}); // beside the tools
        } else {
            const auto places = placesOf(*m_frame, m_document.scene(), {card.target});
            const auto pixel = places.empty() ? std::nullopt : projection.pixel(middleOf(places));
            if (!pixel || !rect().contains(pixel->toPoint()))
                continue;
            painter.setPen(Qt::NoPen);
            painter.setBrush(m_theme.text);
            painter.drawEllipse(*pixel, dot, dot);
            box.moveTopLeft(pixel->toPoint() + QPoint(aside, aside));
            box.moveRight(std::min(box.right(), width() - corner));
            box.moveBottom(std::min(box.bottom(), height() - corner));
        }
        for (const QRect& other : taken) // those further down the list stand below
            if (box.intersects(other))
                box.moveTop(other.bottom() + padding / 2);
        taken.push_back(box);
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_theme.card);
        painter.drawRoundedRect(box, 3.0, 3.0);
        painter.setPen(m_theme.text);
        painter.drawText(box.adjusted(padding, padding / 2, -padding, -padding / 2), Qt::AlignLeft,
                         text);
    }
}

} // namespace ripstop
