// What probes read, on cards beside what they look at; off at first.
//
// Probes of one target share a card; those of the whole scene have one in the upper left corner,
// which grows in width. However many there are, they leave the picture to what is measured: a card
// at a target has few lines, and cards that others have driven too far away are counted in one.
// Values are those of the frame, in the units of its layout; a value that is not known is a dash.
// Names are those of the scene.
// It is a transparent widget over the view that takes no mouse.
#pragma once

#include "camera/camera_projection.h"
#include "look/theme.h"
#include "scene/id.h"
#include "simulation/frame.h"

#include <QStringList>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace ripstop {

class Document;

class ProbeLabels final : public QWidget
{
    Q_OBJECT

public:
    ProbeLabels(Document& document, QWidget* parent);

    void setWanted(bool wanted);
    void setTheme(const Theme& theme);
    void show(const std::shared_ptr<const Frame>& frame, const Camera& camera);
    using QWidget::show;

    // The lines of the card of a target, noId for the whole scene, with those that are not shown.
    QStringList linesOf(Id target) const;

    // A card as it is painted, in pixels of the view.
    struct Shown
    {
        QRect box;
        QStringList columns;          // each of several lines
        std::optional<QPoint> target; // where a dot is
    };
    std::vector<Shown> shown();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Card
    {
        Id target; // noId for the whole scene
        std::vector<Id> probes;
    };

    void collect();
    Shown beside(const QStringList& lines) const;   // a card at a target
    Shown inCorner(const QStringList& lines) const; // that of the whole scene
    Shown card(QStringList columns) const;

    Document& m_document;
    Theme m_theme = Theme::light();
    Camera m_camera;
    std::shared_ptr<const Frame> m_frame;
    std::vector<Card> m_cards;
    bool m_old = true; // the cards have to be collected again
};

} // namespace ripstop
