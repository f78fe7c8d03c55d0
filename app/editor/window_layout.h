// Where the window and its docks are, kept in the settings from run to run.
#pragma once

class QMainWindow;

namespace ripstop {

void keepLayout(const QMainWindow& window);
void restoreLayout(QMainWindow& window); // as it was kept; as it is when nothing was

} // namespace ripstop
