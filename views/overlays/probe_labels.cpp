// Edits mark the cards as old; collect() then sorts the probes of the scene by target. show() takes
// frame and camera of each picture. shown() makes the text of each card from the frame, finds the
// middle of its target in the picture, and moves the card down while it lies over one that is there
// already, or counts it where that is too far. paintEvent() paints them.
#include "overlays/probe_labels.h"

#include "base/quantity.h"
#include "document/document.h"
#include "document/spoken.h"
#include "document/words.h"
#include "look/element_places.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr int corner = 12;         // pixels, from the edge of the view
constexpr int aside = 10;          // pixels, from what is measured
constexpr int padding = 6;         // pixels
constexpr int dot = 3;             // pixels
constexpr int besideTools = 48;    // pixels, from the corner
constexpr int betweenColumns = 14; // pixels
constexpr qsizetype mostLines = 4; // of a column
constexpr int farthest = 7;        // lines, that others may drive a card away

Vec3 middleOf(const std::vector<Vec3>& places)
{
    Vec3 sum = Vec3::Zero();
    for (const Vec3& place : places)
        sum += place;
    return sum / double(places.size());
}

// The dock Plots lists the values of all of them.
QString moreText(qsizetype count) { return words("and %1 more in Plots").arg(count); }

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

ProbeLabels::Shown ProbeLabels::card(QStringList columns) const
{
    int width = 0, height = 0;
    for (const QString& column : columns) {
        const QSize size = fontMetrics().size(0, column);
        width += size.width() + (width > 0 ? betweenColumns : 0);
        height = std::max(height, size.height());
    }
    return {QRect(0, 0, width + 2 * padding, height + padding), std::move(columns), {}};
}

ProbeLabels::Shown ProbeLabels::beside(const QStringList& lines) const
{
    if (lines.size() <= mostLines)
        return card({lines.join('\n')});
    QStringList few = lines.mid(0, mostLines - 1);
    few << moreText(lines.size() - few.size());
    return card({few.join('\n')});
}

// As many columns as find place.
ProbeLabels::Shown ProbeLabels::inCorner(const QStringList& lines) const
{
    QStringList columns;
    Shown made = card({});
    for (qsizetype i = 0; i < lines.size(); i += mostLines) {
        columns << lines.mid(i, mostLines).join('\n');
        Shown wider = card(columns);
        if (i > 0 && wider.box.width() > width() - besideTools - 2 * corner) {
            columns.back() = moreText(lines.size() - i);
            made = card(columns);
            break;
        }
        made = std::move(wider);
    }
    made.box.moveTopLeft({corner + besideTools, corner});
    return made;
}

std::vector<ProbeLabels::Shown> ProbeLabels::shown()
{
    std::vector<Shown> cards;
    if (!m_frame)
        return cards;
    if (m_old)
        collect();
    const CameraProjection projection{m_camera, double(width()), double(height())};
    std::optional<QRect> gone; // where the first card would be that finds no place
    qsizetype goneLines = 0;
    for (const Card& one : m_cards) {
        const QStringList lines = linesOf(one.target);
        if (lines.isEmpty())
            continue;
        Shown made = one.target == noId ? inCorner(lines) : beside(lines);
        if (one.target != noId) {
            const auto places = placesOf(*m_frame, m_document.scene(), {one.target});
            const auto pixel = places.empty() ? std::nullopt : projection.pixel(middleOf(places));
            if (!pixel || !rect().contains(pixel->toPoint()))
                continue;
            made.target = pixel->toPoint();
            made.box.moveTopLeft(*made.target + QPoint(aside, aside));
            made.box.moveRight(std::min(made.box.right(), width() - corner));
            made.box.moveBottom(std::min(made.box.bottom(), height() - corner));
        }
        const int wanted = made.box.top();
        for (const Shown& other : cards) // those further down the list stand below
            if (made.box.intersects(other.box))
                made.box.moveTop(other.box.bottom() + padding / 2);
        if (made.box.top() - wanted > farthest * fontMetrics().lineSpacing()) {
            gone = gone.value_or(made.box);
            goneLines += lines.size();
            made.box = {};
        }
        cards.push_back(std::move(made));
    }
    if (gone) {
        Shown rest = card({moreText(goneLines)});
        rest.box.moveTopLeft(gone->topLeft());
        cards.push_back(std::move(rest));
    }
    return cards;
}

void ProbeLabels::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const std::vector<Shown> cards = shown();
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.text);
    for (const Shown& one : cards)
        if (one.target)
            painter.drawEllipse(*one.target, dot, dot);
    for (const Shown& one : cards) {
        if (one.box.isEmpty())
            continue;
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_theme.card);
        painter.drawRoundedRect(one.box, 3.0, 3.0);
        painter.setPen(m_theme.text);
        QRect inside = one.box.adjusted(padding, padding / 2, -padding, -padding / 2);
        for (const QString& column : one.columns) {
            painter.drawText(inside, Qt::AlignLeft | Qt::TextDontClip, column);
            inside.setLeft(inside.left() + fontMetrics().size(0, column).width() + betweenColumns);
        }
    }
}

} // namespace ripstop
