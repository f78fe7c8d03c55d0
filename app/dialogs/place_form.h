// The part of BuilderDialog that asks where in the open design a built one goes (moved by metres
// along x, y and z if wanted), and which of its surroundings and instruments come along.
//
// It reads the ground once, to choose sensible values, and changes nothing; wish() is what it asks
// for.
#pragma once

#include "shaping/insert.h"

#include <QGroupBox>

#include <array>

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace ripstop {

class PlaceForm final : public QGroupBox
{
    Q_OBJECT

public:
    PlaceForm(const InsertGround& ground, const Vec3& focus, QWidget* parent = nullptr);

    QString refusal() const; // empty while the numbers can be read
    InsertWish wish() const; // without a label

signals:
    void changed();

private:
    QWidget* shiftRow();
    void showShift();

    Vec3 m_focus; // m, what the view turns about
    QComboBox* m_at;
    std::array<QLineEdit*, 3> m_shift{};
    QCheckBox* m_surroundings;
    QCheckBox* m_instruments;
};

} // namespace ripstop
