// Items are made anew when others are the best; their pictures come as they are drawn.
#include "study/design_gallery.h"

#include "document/plain_text.h"
#include "study/design_pictures.h"
#include "study/shown_value.h"
#include "study/study_search.h"

#include <QSignalBlocker>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int pictureSize = 112; // px
constexpr int cellWidth = 168;   // px
constexpr int linesOfText = 4;

// "69.2 °, 10.3 N", in the order of the objectives.
QString wantedText(const OpenedStudy& study, const FlightResult& flight)
{
    QStringList all;
    for (const std::size_t measure : study.wanted)
        all << measuredText(QString::fromStdString(study.headings[measure]),
                            flight.measured[measure]);
    return all.join(QStringLiteral(", "));
}

QString valuesText(const OpenedStudy& study, std::size_t point)
{
    const std::vector<std::string> values = study.points.values(point);
    QStringList lines;
    for (std::size_t v = 0; v < values.size(); ++v)
        lines << valueOfVariable(study, v, values[v]);
    return lines.join('\n');
}

QString wholeText(const OpenedStudy& study, const FlightResult& flight, std::size_t point)
{
    QStringList lines;
    for (const std::size_t measure : study.wanted) {
        const QString heading = QString::fromStdString(study.headings[measure]);
        lines << DesignGallery::tr("%1 is %2. ")
                     .arg(wordsOfHeading(heading).name,
                          measuredText(heading, flight.measured[measure]))
                     .trimmed();
    }
    return lines.join('\n') + '\n' + valuesText(study, point);
}

} // namespace

DesignGallery::DesignGallery(QWidget* parent)
    : QListWidget(parent)
    , m_pictures(new DesignPictures(this))
{
    setAccessibleName(tr("Best designs"));
    setViewMode(QListView::IconMode);
    setMovement(QListView::Static);
    setResizeMode(QListView::Adjust);
    setWordWrap(true);
    setTextElideMode(Qt::ElideRight);
    setUniformItemSizes(true);
    setFrameShape(QFrame::NoFrame);
    setIconSize({pictureSize, pictureSize});
    setGridSize({cellWidth, pictureSize + (linesOfText + 1) * fontMetrics().lineSpacing()});
    connect(this, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0)
            emit chosen(m_points[std::size_t(row)]);
    });
    connect(m_pictures, &DesignPictures::drawn, this, [this](const QString& key) {
        const auto place = std::ranges::find(m_keys, key.toStdString()) - m_keys.begin();
        if (place < std::ptrdiff_t(m_keys.size()))
            setPicture(std::size_t(place));
    });
}

void DesignGallery::show(const OpenedStudy& study, const StudyFlights& flights)
{
    const std::vector<std::size_t> best = bestDesigns(study, flights, mostDesigns);
    std::vector<std::string> keys;
    for (const std::size_t point : best)
        keys.push_back(study.key(point));
    if (keys != m_keys || best != m_points) {
        const QSignalBlocker silent(this);
        clear();
        m_points = best;
        m_keys = std::move(keys);
        for (std::size_t i = 0; i < best.size(); ++i) {
            auto* item = new QListWidgetItem(
                tr("%1. %2").arg(i + 1).arg(wantedText(study, *flights[best[i]])) + '\n'
                    + valuesText(study, best[i]),
                this);
            item->setToolTip(shownAsIs(wholeText(study, *flights[best[i]], best[i])));
            item->setTextAlignment(Qt::AlignHCenter | Qt::AlignTop);
            setPicture(i);
        }
    }
    m_pictures->want(study, best, int(pictureSize * devicePixelRatioF()));
}

void DesignGallery::setPicture(std::size_t place)
{
    QPixmap picture = QPixmap::fromImage(m_pictures->picture(m_keys[place]));
    if (picture.isNull()) { // room for what is being drawn
        picture = QPixmap(pictureSize, pictureSize);
        picture.fill(Qt::transparent);
    } else {
        picture.setDevicePixelRatio(devicePixelRatioF());
    }
    item(int(place))->setIcon(picture);
}

void DesignGallery::mark(std::optional<std::size_t> chosen)
{
    const QSignalBlocker silent(this);
    const auto place = chosen ? std::ranges::find(m_points, *chosen) : m_points.end();
    if (place == m_points.end()) {
        setCurrentRow(-1);
        clearSelection();
    } else {
        setCurrentRow(int(place - m_points.begin()));
    }
}

void DesignGallery::clear()
{
    const QSignalBlocker silent(this);
    QListWidget::clear();
    m_points.clear();
    m_keys.clear();
}

} // namespace ripstop
