// captionOf() says name and unit of each quantity. setScale() takes quantity, range and colours,
// returns when nothing of it has changed, and otherwise sizes the widget for its widest text;
// setPeak() follows with each picture. marks() finds the round numbers: four or five steps over the
// range. paintBar() draws the colours, with an arrow at an end beyond which values lie;
// paintEvent() card, title, bar, marks and peak. A release of the mouse in the lowest
// line means the peak, any other one the range.
#include "overlays/legend.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr int inset = 12;         // pixels
constexpr int barWidth = 16;      // pixels
constexpr int barHeight = 200;    // pixels
constexpr int gap = 8;            // pixels
constexpr int arrow = 7;          // pixels, of an end beyond which values lie
constexpr int stops = 64;         // of the gradient, from end to end
constexpr double mostSteps = 5.0; // between round numbers, over the bar
constexpr double rounding = 1e-6; // of the range: not beyond it yet

struct Caption
{
    QString quantity; // empty: no legend
    QString unit;
    QString unknown = {}; // instead of the peak, when nothing has what it is measured by
};

Caption captionOf(ColorBy colorBy)
{
    switch (colorBy) {
    case ColorBy::Material:
        break;
    case ColorBy::Strain:
        return {Legend::tr("Strain"), QStringLiteral("%")};
    case ColorBy::Tension:
        return {Legend::tr("Tension"), QStringLiteral("N")};
    case ColorBy::Speed:
        return {Legend::tr("Speed"), QStringLiteral("m/s")};
    case ColorBy::PanelLoad:
        return {Legend::tr("Panel load"), QStringLiteral("N/m\u00b2")};
    case ColorBy::TearLoad:
        return {Legend::tr("Of tear limit"), QStringLiteral("%"), Legend::tr("nothing tears here")};
    case ColorBy::Stress:
        return {Legend::tr("Fabric stress"), QStringLiteral("N/m"),
                Legend::tr("no fabric of known width")};
    case ColorBy::Margin:
        return {Legend::tr("Margin"), {}, Legend::tr("no strength here")};
    case ColorBy::Stiffness:
        return {Legend::tr("Stiffness factor"), {}, Legend::tr("all as their materials")};
    case ColorBy::Strength:
        return {Legend::tr("Strength factor"), {}, Legend::tr("all as their materials")};
    case ColorBy::Grain:
        return {Legend::tr("Grain"), QStringLiteral("\u00b0"), Legend::tr("no elastic panels")};
    case ColorBy::Wrinkles:
        return {Legend::tr("Wrinkles"), {}, Legend::tr("no elastic panels")};
    }
    return {};
}

} // namespace

Legend::Legend(QWidget* parent)
    : QWidget(parent)
{
    setToolTip(
        tr("Click the colours to type their range. The largest value of the moment stands "
           "below; click that to select what has it. An arrow at an end of the colours: some "
           "values lie beyond."));
    setCursor(Qt::PointingHandCursor);
    hide();
}

void Legend::setTheme(const Theme& theme)
{
    m_theme = theme;
    update();
}

void Legend::setScale(ColorBy colorBy, const ValueRange& range, const ColorMap& colors)
{
    const bool isShare = colorBy == ColorBy::Strain || colorBy == ColorBy::TearLoad;
    const auto [quantity, siUnit, unknown] = captionOf(colorBy);
    const double largest = std::max(std::abs(range.low), std::abs(range.high));
    m_scale = spokenScale(largest, isShare ? std::string() : siUnit.toStdString(), isShare);
    const QString& unit = m_scale.unit;
    const ValueRange scaled{range.low / m_scale.factor, range.high / m_scale.factor};
    const QString title = unit.isEmpty() ? quantity : QStringLiteral("%1, %2").arg(quantity, unit);
    if (title == m_title && scaled == m_range && &colors == m_colors)
        return;
    m_title = title;
    m_unit = unit;
    m_isState = isState(colorBy);
    m_marksLimit = colorBy == ColorBy::Margin;
    m_unknown = unknown;
    m_range = scaled;
    m_colors = &colors;
    setVisible(!m_title.isEmpty());

    const QFontMetrics metrics(font());
    int widest = 0;
    for (const Mark& mark : marks())
        widest = std::max(widest, metrics.horizontalAdvance(mark.text));
    const int content =
        std::max({barWidth + gap + widest, metrics.horizontalAdvance(m_title),
                  metrics.horizontalAdvance(m_unknown),
                  metrics.horizontalAdvance(tr("peak %1").arg(QStringLiteral("0000.00")))});
    resize(content + 2 * inset,
           barHeight + 2 * (metrics.height() + gap) + metrics.ascent() + 2 * inset);
    update();
}

void Legend::setPeak(const std::optional<Peak>& peak, const ValueRange& extent)
{
    m_peak = peak.value_or(Peak{});
    m_extent = extent;
    m_isKnown = peak.has_value();
    update();
}

QString Legend::peakText() const
{
    if (!m_isKnown)
        return m_unknown;
    return m_peak.id == 0 || m_isState ? QString()
                                       : tr("peak %1").arg(m_scale.number(m_peak.value));
}

bool Legend::goesAbove() const { return isBeyond(m_extent.high - meant(m_range).high); }

bool Legend::goesBelow() const { return isBeyond(meant(m_range).low - m_extent.low); }

bool Legend::isBeyond(double by) const
{
    const ValueRange range = meant(m_range);
    return m_isKnown && !m_isState && by > rounding * (range.high - range.low);
}

void Legend::mousePressEvent(QMouseEvent*) {}

void Legend::mouseReleaseEvent(QMouseEvent* event)
{
    const int peakTop = height() - inset - QFontMetrics(font()).height() - gap;
    if (m_isState)
        return; // names have no range and no peak
    if (event->position().y() < peakTop)
        emit rangeClicked();
    else if (m_peak.id != 0)
        emit peakClicked(Id{m_peak.id});
}

std::vector<Legend::Mark> Legend::marks() const
{
    if (m_isState)
        return {{1.0 / 6.0, tr("slack")}, {0.5, tr("wrinkled")}, {5.0 / 6.0, tr("taut")}};
    std::vector<Mark> result;
    const double span = m_range.high - m_range.low;
    const double step = roundStep(span / mostSteps);
    if (!(step > 0.0))
        return result;
    const auto first = std::llround(std::ceil(m_range.low / step - 1e-9));
    const auto last = std::llround(std::floor(m_range.high / step + 1e-9));
    for (auto i = first; i <= last; ++i) {
        const double value = double(i) * step;
        const QString text = SpokenScale().atStep(value, step);
        result.push_back({(value - m_range.low) / span, text});
    }
    if (m_marksLimit && m_range.low <= 1.0 && m_range.high >= 1.0) {
        const double share = (1.0 - m_range.low) / span;
        const auto isBeside = [&](const Mark& mark) { // its number would be under the word
            return std::abs(mark.share - share) * barHeight < QFontMetrics(font()).height();
        };
        std::erase_if(result, isBeside);
        result.push_back({share, tr("1, breaks"), true});
    }
    return result;
}

QStringList Legend::labels() const
{
    QStringList texts;
    for (const Mark& mark : marks())
        texts.push_back(mark.text);
    return texts;
}

void Legend::paintBar(QPainter& painter, const QRect& bar) const
{
    const auto colorAt = [this](double share) {
        const auto [r, g, b] = m_colors->at(share);
        return QColor(r, g, b);
    };
    // One fill: the card would shine through between rows where a picture is of another size.
    QLinearGradient colors(0.0, bar.top() + bar.height(), 0.0, bar.top());
    for (int i = 0; !m_isState && i <= stops; ++i) {
        const double share = double(i) / stops;
        colors.setColorAt(share, colorAt(share));
    }
    for (int state = 0; m_isState && state < 3; ++state) { // each has a third
        colors.setColorAt(state / 3.0, colorAt(0.5 * state));
        colors.setColorAt((state + 1) / 3.0 - rounding, colorAt(0.5 * state));
    }
    painter.fillRect(bar, colors);
    painter.setPen(Qt::NoPen);
    const auto paintArrow = [&](double share, int base, int tip) {
        painter.setBrush(colorAt(share));
        painter.drawPolygon(
            QPolygonF({QPointF(bar.left(), base), QPointF(bar.left() + bar.width(), base),
                       QPointF(bar.left() + 0.5 * bar.width(), tip)}));
    };
    if (goesAbove())
        paintArrow(1.0, bar.top(), bar.top() - arrow);
    if (goesBelow())
        paintArrow(0.0, bar.top() + bar.height(), bar.top() + bar.height() + arrow);
}

void Legend::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.card);
    painter.drawRoundedRect(rect(), 8, 8);

    const QFontMetrics metrics(font());
    painter.setPen(m_theme.text);
    painter.drawText(inset, inset + metrics.ascent(), m_title);

    const QRect bar(inset, inset + metrics.height() + gap, barWidth, barHeight);
    paintBar(painter, bar);
    painter.setPen(m_theme.text);
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (const Mark& mark : marks()) {
        const int y = bar.top() + int(std::lround((1.0 - mark.share) * (bar.height() - 1)));
        painter.drawLine(mark.isLimit ? bar.left() : bar.right() + 1, y, bar.right() + 4, y);
        painter.drawText(bar.right() + gap, y + metrics.ascent() / 2 - 1, mark.text);
    }
    painter.drawText(inset, height() - inset - metrics.descent(), peakText());
}

} // namespace ripstop
