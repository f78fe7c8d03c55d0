#pragma once

#include "editor/view_bar.h"

#include "tools/draw_tool.h"

#include <functional>
#include <vector>

class QAction;
class QComboBox;
class QLabel;

namespace ripstop {

class Actions;
class Document;
class ParameterField;
struct Parameter;
class Viewport;

// Over the lower edge of the view while a draw tool is in use: what is drawn, of what, and in which
// plane.
class DrawBar final : public ViewBar
{
    Q_OBJECT

public:
    DrawBar(Document& document, Viewport& viewport, DrawSettings& settings, const Actions& actions);

    void refresh();

private:
    struct Hint
    {
        QAction* tool;
        QString title;
        QString words;
    };

    void startOver();
    void layOut();
    QWidget* field(const Parameter& parameter, double value,
                   const std::function<void(double)>& take);
    template <typename T>
    void fillItems(QComboBox& box, Id chosen, const QString& fresh);

    Document& m_document;
    DrawSettings& m_settings;
    std::vector<Hint> m_hints;
    QLabel* m_title;
    QLabel* m_hint;
    QComboBox* m_part;
    QComboBox* m_material;
    QWidget* m_mass;
    std::vector<QWidget*> m_onLinks; // that only links have
};

} // namespace ripstop
