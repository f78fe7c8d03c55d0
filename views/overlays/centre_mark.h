#pragma once

#include "camera/camera_projection.h"
#include "look/theme.h"
#include "run/frame.h"
#include "scene/id.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace ripstop {

class Document;
class Selection;

// Marks the centre of gravity of what is selected, or of the whole design, where it is at this
// instant, and says its mass. Off at first.
class CentreMark final : public QWidget
{
    Q_OBJECT

public:
    CentreMark(Document& document, Selection& selection, QWidget* parent);

    void setMarked(bool marked);
    void setTheme(const Theme& theme);
    void show(const std::shared_ptr<const Frame>& frame, const Camera& camera);
    using QWidget::show;

    std::optional<Vec3> place() const;      // m; nothing when there is no mass
    double mass() const { return m_total; } // kg

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void weigh();

    Document& m_document;
    Selection& m_selection;
    Theme m_theme = Theme::light();
    Camera m_camera;
    std::shared_ptr<const Frame> m_frame;
    std::shared_ptr<const Layout> m_weighed; // what the masses are those of
    std::vector<double> m_mass;              // [particles] kg, 0 of what is not meant
    double m_total = 0.0;                    // kg
    bool m_marked = false;
};

} // namespace ripstop
