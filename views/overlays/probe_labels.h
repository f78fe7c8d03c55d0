// What probes read, on cards beside what they look at; off at first.
//
// Probes of one target share a card; those of the whole scene have one in the upper left corner.
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

    // For tests: the lines of the card of a target, noId for the whole scene.
    QStringList linesOf(Id target) const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Card
    {
        Id target; // noId for the whole scene
        std::vector<Id> probes;
    };

    void collect();

    Document& m_document;
    Theme m_theme = Theme::light();
    Camera m_camera;
    std::shared_ptr<const Frame> m_frame;
    std::vector<Card> m_cards;
    bool m_old = true; // the cards have to be collected again
};

} // namespace ripstop
