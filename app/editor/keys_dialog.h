#pragma once

#include "scene/scene.h"

#include <QDialog>

#include <vector>

class QAction;

namespace ripstop {

// All keys on one page: those of the actions, and those of the controls of a scene.
class KeysDialog final : public QDialog
{
    Q_OBJECT

public:
    KeysDialog(const std::vector<QAction*>& actions, const Scene& scene, QWidget* parent);
};

} // namespace ripstop
