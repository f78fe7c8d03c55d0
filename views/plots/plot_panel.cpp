#include "plots/plot_panel.h"

namespace ripstop {

PlotPanel::PlotPanel(Document&, Player&, QWidget* parent)
    : QWidget(parent)
{}

} // namespace ripstop
