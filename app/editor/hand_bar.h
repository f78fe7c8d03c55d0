// The bar over the lower edge of the view while a hand, a knife or a fan is chosen: its numbers
// (stiffness in N/m, greatest force in N, speed in m/s, half angle of the jet in degrees), what
// the mouse does, and the pins that hands have left in the run.
//
// It edits the HandSettings of the view. The main window makes it, over the view, which owns it,
// and calls refresh() when a wheel has changed the settings. It lives on the thread of the window.
#pragma once

#include "editor/view_bar.h"

#include "tools/hand_settings.h"

#include <functional>
#include <vector>

class QAction;
class QLabel;
class QPushButton;

namespace ripstop {

class Actions;
class Document;
class Player;
class ValueEdit;
class Viewport;

class HandBar final : public ViewBar
{
    Q_OBJECT

public:
    HandBar(Document& document, Player& player, Viewport& viewport, const Actions& actions);

    void refresh();

private:
    // A number of the settings. Where the user has set none, the field is empty and shows the
    // number that the program chooses.
    struct Field
    {
        QAction* tool;
        QWidget* row;
        ValueEdit* edit;
        QString unit;
        double low, high;
        std::function<double()> value;
        std::function<bool()> isOwn;
        std::function<void(std::optional<double>)> set;
    };
    struct Hint
    {
        QAction* tool;
        QString title;
        QString words;
    };

    void layOut(QAction* through);
    void addField(const QString& name, Field field, const QString& help);
    void addFields();
    QString refusal() const override;
    QString complaintAbout(const Field& field, const QString& text) const; // empty when it is fine
    void take(const Field& field, const QString& text);
    const Hint* shown() const;

    Document& m_document;
    Player& m_player;
    HandSettings& m_settings;
    std::vector<Hint> m_hints;
    std::vector<Field> m_fields;
    QLabel* m_title;
    QWidget* m_through;
    QPushButton* m_unpin;
};

} // namespace ripstop
