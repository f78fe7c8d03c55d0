// Stages: the constructor makes the list of places, in the order of PlaceAt, and two boxes: where
// something stands already the place beside it is chosen, and where there is neither ground nor
// wind those of the builder come along. refusal() and wish() read the three numbers only where the
// chosen place needs them.
#include "dialogs/place_form.h"

#include "scene/typed_number.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

namespace ripstop {

PlaceForm::PlaceForm(const InsertGround& ground, const Vec3& focus, QWidget* parent)
    : QGroupBox(tr("Place"), parent)
    , m_focus(focus)
    , m_at(new QComboBox)
    , m_surroundings(new QCheckBox(tr("Its ground, wind and settings")))
    , m_instruments(new QCheckBox(tr("Its controls and probes")))
{
    m_at->setObjectName(QStringLiteral("at"));
    m_at->setAccessibleName(tr("Place"));
    m_at->addItems({tr("Where the builder has it"), tr("Beside what is there"),
                    tr("In the middle of the view"), tr("Moved by")}); // in the order of PlaceAt
    m_at->setToolTip(tr("Builders put their designs over the origin, at the height that they fly "
                        "or hang at. Afterwards G moves what was inserted."));
    m_at->setCurrentIndex(int(ground.box.isEmpty() ? PlaceAt::Origin : PlaceAt::Beside));
    m_surroundings->setObjectName(QStringLiteral("surroundings"));
    m_surroundings->setToolTip(tr("A second wind adds to the first. On at first where the design "
                                  "has neither ground nor wind."));
    m_surroundings->setChecked(!hasSurroundings(ground.scene));
    m_instruments->setObjectName(QStringLiteral("instruments"));
    m_instruments->setToolTip(tr("Keys that steer it and what is measured of it."));
    m_instruments->setChecked(true);

    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(4);
    layout->addWidget(m_at);
    layout->addWidget(shiftRow());
    layout->addWidget(m_surroundings);
    layout->addWidget(m_instruments);
    showShift();
    connect(m_at, &QComboBox::currentIndexChanged, this, [this] {
        showShift();
        emit changed();
    });
    for (QCheckBox* choice : {m_surroundings, m_instruments})
        connect(choice, &QCheckBox::toggled, this, &PlaceForm::changed);
}

QWidget* PlaceForm::shiftRow()
{
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    for (int axis = 0; axis < 3; ++axis) {
        const QChar name('x' + axis);
        auto* field = m_shift[std::size_t(axis)] = new QLineEdit(QStringLiteral("0"));
        field->setObjectName(QStringLiteral("place %1").arg(name));
        field->setAccessibleName(tr("Moved by, %1").arg(name));
        field->setAlignment(Qt::AlignRight);
        layout->addWidget(new QLabel(name));
        layout->addWidget(field);
        connect(field, &QLineEdit::textEdited, this, &PlaceForm::changed);
    }
    layout->addWidget(new QLabel(QStringLiteral("m")));
    return row;
}

void PlaceForm::showShift()
{
    const bool moves = PlaceAt(m_at->currentIndex()) == PlaceAt::Shift;
    m_shift.front()->parentWidget()->setVisible(moves);
}

QString PlaceForm::refusal() const
{
    if (PlaceAt(m_at->currentIndex()) != PlaceAt::Shift)
        return {};
    for (int axis = 0; axis < 3; ++axis) {
        const QString typed = m_shift[std::size_t(axis)]->text();
        if (!typedValue(typed.toStdString(), "m").number)
            return tr("%1 must be a number of metres, not \"%2\".")
                .arg(QChar('x' + axis))
                .arg(typed);
    }
    return {};
}

InsertWish PlaceForm::wish() const
{
    InsertWish wish;
    wish.at = PlaceAt(m_at->currentIndex());
    wish.place = m_focus;
    if (wish.at == PlaceAt::Shift)
        for (int axis = 0; axis < 3; ++axis)
            if (const Typed typed =
                    typedValue(m_shift[std::size_t(axis)]->text().toStdString(), "m");
                typed.number)
                wish.place[axis] = typed.number->number;
    wish.withSurroundings = m_surroundings->isChecked();
    wish.withInstruments = m_instruments->isChecked();
    return wish;
}

} // namespace ripstop
