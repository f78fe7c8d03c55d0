// The best designs of a study as small pictures, the best first, with what is wanted of each and
// its values. A click chooses the flight, as one of the map does. Only the window's thread uses it.
#pragma once

#include "study/study_run.h"

#include <QListWidget>

#include <optional>
#include <vector>

namespace ripstop {

class DesignPictures;

class DesignGallery final : public QListWidget
{
    Q_OBJECT

public:
    explicit DesignGallery(QWidget* parent = nullptr);

    static constexpr std::size_t mostDesigns = 12;

    void show(const OpenedStudy& study, const StudyFlights& flights);
    using QWidget::show;
    void mark(std::optional<std::size_t> chosen); // where it is among them
    void clear();

    const std::vector<std::size_t>& designs() const { return m_points; }

signals:
    void chosen(std::size_t point); // of the study

private:
    void setPicture(std::size_t place);

    DesignPictures* m_pictures;
    std::vector<std::size_t> m_points; // [items]
    std::vector<std::string> m_keys;   // [items]
};

} // namespace ripstop
