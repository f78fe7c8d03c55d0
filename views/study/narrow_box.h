// A choice that takes little room, as the panel stands in a dock: what does not fit ends in an
// ellipsis, and stands whole in the list and in the tool tip.
#pragma once

#include <QComboBox>
#include <QStringList>

namespace ripstop {

class NarrowBox final : public QComboBox
{
    Q_OBJECT

public:
    //   letters  that there is room for at least
    explicit NarrowBox(const QString& name, const QStringList& texts = {}, int letters = 4);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void tellWhole();

    QString m_name;
};

} // namespace ripstop
