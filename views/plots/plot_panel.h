#pragma once

#include <QWidget>

namespace ripstop {

class Document;
class Player;

// Live curves of the probes of the scene, one strip for each unit over a common time axis. A list
// at the side says which probes are drawn and what they read now.
class PlotPanel final : public QWidget
{
    Q_OBJECT

public:
    PlotPanel(Document& document, Player& player, QWidget* parent = nullptr);
};

} // namespace ripstop
