// captionOf() says name and unit of each quantity. setScale() takes quantity, range and colours and
// returns when nothing of it has changed; setPeak() follows with each picture. fit() sizes the
// widget for its widest text, or for two lines where nothing has the quantity. marks() finds the
// round numbers: four or five steps over the range. paintBar() draws the colours, with an arrow at
// an end beyond which values lie; paintEvent() card, title, bar, marks and peak. A release of the
// mouse in the lowest line means the peak, any other one the range.
#include "overlays/legend.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

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
    QString unknown; // when nothing has what it is measured by
    QString remedy;  // what would give it something
};

QString ofPanelsThatPull()
{
    return Legend::tr(
        "Panels that carry the pull of their fabric have it: let the fabric of a part "
        "pull by panels.");
}

QString ofWhatIsPainted()
{
    return Legend::tr("Every factor is 1. Paint with the brush, or type another one for what is "
                      "selected.");
}

Caption captionOf(ColorBy colorBy)
{
    switch (colorBy) {
    case ColorBy::Material:
        break;
    case ColorBy::Strain:
        return {Legend::tr("Strain"), QStringLiteral("%"), Legend::tr("no links here"),
                Legend::tr("Strain is that of links, and of panels that carry the pull of their "
                           "fabric.")};
    case ColorBy::Tension:
        return {Legend::tr("Tension"), QStringLiteral("N"), Legend::tr("no links here"),
                Legend::tr("Tension is that of links. What panels carry is their fabric stress.")};
    case ColorBy::Speed:
        return {Legend::tr("Speed"), QStringLiteral("m/s"), Legend::tr("no particles here"),
                Legend::tr("Draw particles, or insert a design.")};
    case ColorBy::PanelLoad:
        return {Legend::tr("Panel load"), QStringLiteral("N/m\u00b2"), Legend::tr("no panels here"),
                Legend::tr("The air pushes panels: draw some between particles.")};
    case ColorBy::TearLoad:
        return {Legend::tr("Of tear limit"), QStringLiteral("%"), Legend::tr("nothing tears here"),
                Legend::tr("Choose what a material tears by, and its limit or its strengths.")};
    case ColorBy::Stress:
        return {Legend::tr("Fabric stress"), QStringLiteral("N/m"),
                Legend::tr("no fabric of known width"),
                Legend::tr("Fabric has a stress where panels carry its pull, and where threads "
                           "have a width.")};
    case ColorBy::Margin:
        return {
            Legend::tr("Margin"),
            {},
            Legend::tr("no strength here"),
            Legend::tr("Give materials a line strength, a warp strength or a breaking moment.")};
    case ColorBy::Stiffness:
        return {Legend::tr("Stiffness factor"),
                {},
                Legend::tr("all as their materials"),
                ofWhatIsPainted()};
    case ColorBy::Strength:
        return {Legend::tr("Strength factor"),
                {},
                Legend::tr("all as their materials"),
                ofWhatIsPainted()};
    case ColorBy::Grain:
        return {Legend::tr("Grain"), QStringLiteral("\u00b0"), Legend::tr("no elastic panels"),
                ofPanelsThatPull()};
    case ColorBy::Wrinkles:
        return {Legend::tr("Wrinkles"), {}, Legend::tr("no elastic panels"), ofPanelsThatPull()};
    }
    return {};
}

} // namespace

Legend::Legend(QWidget* parent)
    : QWidget(parent)
{
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
    const auto [quantity, siUnit, unknown, remedy] = captionOf(colorBy);
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
    m_remedy = remedy;
    m_range = scaled;
    m_colors = &colors;
    setVisible(!m_title.isEmpty());
    fit();
}

void Legend::fit()
{
    setToolTip(m_isKnown
                   ? tr("Click the colours to type their range. The largest value of the moment "
                        "stands below; click that to select what has it. An arrow at an end of the "
                        "colours: some values lie beyond.")
                   : m_remedy);
    setCursor(hasRange() ? Qt::PointingHandCursor : Qt::ArrowCursor);
    const QFontMetrics metrics(font());
    update();
    if (!m_isKnown) {
        resize(std::max(metrics.horizontalAdvance(m_title), metrics.horizontalAdvance(m_unknown))
                   + 2 * inset,
               2 * metrics.height() + gap + 2 * inset);
        return;
    }
    int widest = 0;
    for (const Mark& mark : marks())
        widest = std::max(widest, metrics.horizontalAdvance(mark.text));
    const int content =
        std::max({barWidth + gap + widest, metrics.horizontalAdvance(m_title),
                  metrics.horizontalAdvance(tr("peak %1").arg(QStringLiteral("0000.00")))});
    resize(content + 2 * inset,
           barHeight + 2 * (metrics.height() + gap) + metrics.ascent() + 2 * inset);
}

void Legend::setPeak(const std::optional<Peak>& peak, const ValueRange& extent)
{
    m_peak = peak.value_or(Peak{});
    m_extent = extent;
    if (std::exchange(m_isKnown, peak.has_value()) != m_isKnown)
        fit();
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
    if (!hasRange())
        return; // names have no range and no peak
    if (event->position().y() < peakTop)
        emit rangeClicked();
    else if (m_peak.id != 0)
        emit peakClicked(Id{m_peak.id});
}

std::vector<Legend::Mark> Legend::marks() const
{
    if (!m_isKnown)
        return {};
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

    painter.drawText(inset, height() - inset - metrics.descent(), peakText());
    if (!m_isKnown)
        return;

    const QRect bar(inset, inset + metrics.height() + gap, barWidth, barHeight);
    paintBar(painter, bar);
    painter.setPen(m_theme.text);
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (const Mark& mark : marks()) {
        const int y = bar.top() + int(std::lround((1.0 - mark.share) * (bar.height() - 1)));
        painter.drawLine(mark.isLimit ? bar.left() : bar.right() + 1, y, bar.right() + 4, y);
        painter.drawText(bar.right() + gap, y + metrics.ascent() / 2 - 1, mark.text);
    }
}

} // namespace ripstop
