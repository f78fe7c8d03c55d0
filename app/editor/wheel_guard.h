// Keeps the wheel from changing values while a person scrolls a form.
//
// A choice, a number or a slider that passes under the mouse would take the wheel for itself, and a
// design would silently be another one. This event filter of the application lets the wheel pass to
// what scrolls around such a field unless the field has the focus, and keeps the wheel from giving
// it the focus. The main window makes it; only its thread uses it.
#pragma once

#include <QObject>

namespace ripstop {

class WheelGuard final : public QObject
{
    Q_OBJECT

public:
    explicit WheelGuard(QObject* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace ripstop
