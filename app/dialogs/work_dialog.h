// Does something long on a thread of its own and returns when it is done.
//
// An event loop runs meanwhile, so the window goes on being drawn, and a bar that can be cancelled
// appears once it takes longer than 0.4 s, which says after a while how long it goes on. It has to
// be called on the thread of the window; `work` runs on the other thread, must not touch widgets,
// and is asked to stop by its Progress returning false. It has no result: the caller lets `work`
// write into its own variables.
#pragma once

#include "base/progress.h"

#include <QString>

#include <functional>

class QWidget;

namespace ripstop {

void workWithProgress(QWidget* parent, const QString& title,
                      const std::function<void(const Progress&)>& work);

} // namespace ripstop
