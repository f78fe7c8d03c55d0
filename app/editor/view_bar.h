#pragma once

#include <QFrame>

#include <functional>

class QComboBox;

namespace ripstop {

class Viewport;

// A bar over the lower edge of the view, in its middle, with what the tool in use can be told.
class ViewBar : public QFrame
{
    Q_OBJECT

public:
    bool eventFilter(QObject* watched, QEvent* event) override;

protected:
    ViewBar(Viewport& viewport, const QString& name); // hidden at first

    void settle(); // at its place, as large as what it shows now
    QComboBox* chooser(const QString& name, const QString& help, const QStringList& choices,
                       int chosen, const std::function<void(int)>& choose);

    Viewport& m_viewport;
};

} // namespace ripstop
