// The dock of controls: one row for each Control of the scene, with its name, its keys as buttons,
// and how far it has moved. It reads the document and the frames of the player and steers through
// Player::nudge(). Only the window's thread uses it.
#pragma once

#include "scene/scene.h"

#include <QWidget>

#include <vector>

class QGridLayout;
class QLabel;

namespace ripstop {

class Document;
class Player;
class ValueBar;

class ControlStrip final : public QWidget
{
    Q_OBJECT

public:
    ControlStrip(Document& document, Player& player, QWidget* parent = nullptr);

private:
    struct Row
    {
        Id control;
        ValueBar* bar;
    };

    void refresh(); // rebuilds the rows when the controls have changed
    void rebuild();
    void addRow(Id id, const Control& control);
    QWidget* nudgeButton(Id id, const Control& control, int direction);
    void showValues();

    Document& m_document;
    Player& m_player;
    std::vector<Entry> m_controls; // as the rows show them
    std::vector<Row> m_rows;
    QWidget* m_body = nullptr;
    QGridLayout* m_grid = nullptr;
    QLabel* m_empty;
};

} // namespace ripstop
