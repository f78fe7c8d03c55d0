// Marks the centre of gravity of what is selected, or of the whole design, and says its mass.
//
// Masses are those of the scene, noted for each layout and again after an edit or another
// selection; places are those of the frame, so that the mark goes with the flight. It is a
// transparent widget over the view that takes no mouse. It is off at first.
#pragma once

#include "camera/camera_projection.h"
#include "look/theme.h"
#include "scene/id.h"
#include "simulation/frame.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace ripstop {

class Document;
class Selection;

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
    std::shared_ptr<const Layout> m_weighed; // the layout that the masses belong to
    std::vector<double> m_mass;              // [particles] kg, 0 for those that are not meant
    double m_total = 0.0;                    // kg
    bool m_marked = false;
};

} // namespace ripstop
