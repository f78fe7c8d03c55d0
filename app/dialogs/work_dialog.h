#pragma once

#include "base/progress.h"

#include <QString>

#include <functional>

class QWidget;

namespace ripstop {

// Does something long on a thread of its own and waits, with a bar that can be cancelled once it
// takes longer than a moment. The window goes on being drawn.
void workWithProgress(QWidget* parent, const QString& title,
                      const std::function<void(const Progress&)>& work);

} // namespace ripstop
