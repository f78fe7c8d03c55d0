// The scale of colours beside the view: name, unit and round numbers at a bar.
//
// The largest value of the moment stands below it. An end of the bar is an arrow while values lie
// beyond it, as in the plots of Matplotlib. A click on the bar asks for another range, one
// on the largest value goes to what has it. It is hidden when the view shows materials. Values come
// in SI units and are shown as people say them: shares in per cent, large pulls in kN. Where
// nothing in the scene has the quantity, all is grey and there is no bar: it says what is missing,
// and its tip what to do.
#pragma once

#include "document/spoken.h"
#include "look/color_map.h"
#include "look/quantity_values.h"
#include "look/theme.h"
#include "scene/id.h"

#include <QWidget>

#include <optional>

namespace ripstop {

class Legend final : public QWidget
{
    Q_OBJECT

public:
    explicit Legend(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void setScale(ColorBy colorBy, const ValueRange& range, const ColorMap& colors);
    // The largest value of the moment, in SI units; nothing when nothing has the quantity.
    // `extent` is from the smallest to the largest of all values.
    void setPeak(const std::optional<Peak>& peak, const ValueRange& extent = {0.0, 0.0});

    QString title() const { return m_title; }
    QString unit() const { return m_unit; }
    bool hasRange() const { return !m_title.isEmpty() && m_isKnown && !m_isState; }
    const ValueRange& range() const { return m_range; } // in the unit of the legend
    ValueRange meant(const ValueRange& shown) const     // in SI units
    {
        return {shown.low * m_scale.factor, shown.high * m_scale.factor};
    }
    QStringList labels() const; // from the bottom up

    QString peakText() const; // "peak 12.3"; empty when there is none
    bool goesAbove() const;   // values lie above the colours
    bool goesBelow() const;

signals:
    void peakClicked(ripstop::Id id);
    void rangeClicked();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override; // kept from the view, as is the release
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    struct Mark
    {
        double share; // 0 at the bottom, 1 at the top
        QString text;
        bool isLimit = false; // where things break: drawn across the bar
    };
    std::vector<Mark> marks() const;
    void fit();                     // size, tip and cursor to what is shown
    bool isBeyond(double by) const; // by so much, in SI units
    void paintBar(QPainter& painter, const QRect& bar) const;

    Theme m_theme = Theme::light();
    const ColorMap* m_colors = nullptr;
    ValueRange m_range; // as shown: strain in per cent
    QString m_title;
    QString m_unit;
    QString m_unknown; // said where nothing has the quantity
    QString m_remedy;  // what would give it something
    bool m_isKnown = true;
    bool m_isState = false;    // marked by names, without range and peak
    bool m_marksLimit = false; // of margins, at 1
    SpokenScale m_scale;       // of what is shown
    Peak m_peak;
    ValueRange m_extent{0.0, 0.0}; // of the values, in SI units
};

} // namespace ripstop
