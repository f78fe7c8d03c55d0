// The list of numbers is made of what is selected when the dialog opens. look() tries the formula
// at each change and says what it gives; accept() makes the map.
#include "dialogs/map_dialog.h"

#include "document/document.h"
#include "document/selection.h"
#include "document/spoken.h"
#include "document/words.h"
#include "icons/icon.h"
#include "select/elements.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ripstop {

MapDialog::MapDialog(Document& document, Selection& selection, QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_selection(selection)
    , m_number(new QComboBox)
    , m_formula(new QLineEdit)
    , m_picture(new QLineEdit)
    , m_verdict(new QLabel)
{
    setWindowTitle(tr("Map by a formula"));
    auto* words = new QLabel(
        tr("Each selected element gets the number that the formula gives where it lies: x, y and z "
           "in metres, u and v across and up the picture on the fabric, value what it has now, "
           "grey the picture below at u and v, 0 for black and 1 for white."));
    words->setWordWrap(true);
    m_formula->setClearButtonEnabled(true);
    m_picture->setPlaceholderText(tr("none", "picture"));
    m_picture->setClearButtonEnabled(true);
    m_verdict->setTextFormat(Qt::PlainText);
    m_verdict->setWordWrap(true);
    m_verdict->setMinimumHeight(2 * fontMetrics().lineSpacing()); // a message may need two lines
    m_verdict->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* browse = new QToolButton;
    browse->setIcon(icon(QStringLiteral("open")));
    browse->setToolTip(tr("Choose a picture"));
    browse->setAccessibleName(browse->toolTip());
    connect(browse, &QToolButton::clicked, this, &MapDialog::choosePicture);
    auto* picture = new QHBoxLayout;
    picture->addWidget(m_picture, 1);
    picture->addWidget(browse);

    auto* form = new QFormLayout;
    form->addRow(tr("&Number"), m_number);
    form->addRow(tr("&Formula"), m_formula);
    auto* ofPicture = new QLabel(tr("&Picture"));
    ofPicture->setBuddy(m_picture);
    form->addRow(ofPicture, picture);
    m_picture->setAccessibleName(tr("Picture"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    connect(buttons, &QDialogButtonBox::accepted, this, &MapDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(words);
    layout->addLayout(form);
    layout->addWidget(m_verdict);
    layout->addWidget(buttons);
    resize(560, sizeHint().height());

    fillNumbers();
    connect(m_number, &QComboBox::currentIndexChanged, this, [this] {
        offerFormula();
        look();
    });
    connect(m_formula, &QLineEdit::textChanged, this, &MapDialog::look);
    connect(m_picture, &QLineEdit::textChanged, this, &MapDialog::look);
    look();
}

// The numbers of the kinds that are selected. The choice to begin with is a strength of which each
// element has a value, as not all materials have a tear limit.
void MapDialog::fillNumbers()
{
    const Elements elements = sortedElements(m_document.scene(), m_selection.ids());
    const auto add = [&](Kind kind, bool isThere) {
        if (!isThere)
            return;
        for (const Property* property : mappableNumbers(kind)) {
            m_number->addItem(labelled(kindPluralLabel(kind), labelOf(*property)));
            m_numbers.push_back(property);
        }
    };
    add(Kind::Link, !elements.links.empty());
    add(Kind::Panel, !elements.panels.empty());
    add(Kind::Particle, !elements.particles.empty());
    for (const Property* strength :
         {&propertyOf<&Link::tearLimit>(), &propertyOf<&Panel::strengthFactor>(),
          &propertyOf<&Link::strengthFactor>()})
        if (setNumber(*strength), offerFormula(); map())
            break;
}

// One about the elements that have the number, as long as nobody has written another.
void MapDialog::offerFormula()
{
    if (m_number->currentIndex() < 0 || m_formula->text() != m_offered)
        return;
    const Scene& scene = m_document.scene();
    m_offered =
        QString::fromStdString(fadingSpot(scene, *m_numbers[std::size_t(m_number->currentIndex())],
                                          elementsOf(scene, m_selection.ids())));
    m_formula->setText(m_offered);
}

void MapDialog::setFormula(const QString& formula) { m_formula->setText(formula); }

void MapDialog::setNumber(const Property& property)
{
    const auto found = std::ranges::find(m_numbers, &property);
    if (found != m_numbers.end())
        m_number->setCurrentIndex(int(found - m_numbers.begin()));
}

QString MapDialog::verdict() const { return m_verdict->text(); }

void MapDialog::choosePicture()
{
    const QString file = QFileDialog::getOpenFileName(this, tr("Choose a picture"), {},
                                                      tr("Pictures (*.png *.pgm)"));
    if (file.isEmpty())
        return;
    m_picture->setText(file);
    if (!m_formula->text().contains(QLatin1String("grey"))) // which would leave it unseen
        m_formula->setText(QStringLiteral("0.2 + 0.8 * grey"));
}

Result<MappedNumbers> MapDialog::map() const
{
    if (m_number->currentIndex() < 0)
        return Failure("Select particles, links or panels to map.");
    const Property& property = *m_numbers[std::size_t(m_number->currentIndex())];
    return mappedByPicture(m_document.scene(), property,
                           elementsOf(m_document.scene(), m_selection.ids()),
                           m_formula->text().toStdString(), m_picture->text().toStdU16String());
}

void MapDialog::look()
{
    const Result<MappedNumbers> made = map();
    m_ok->setEnabled(bool(made));
    if (!made)
        return m_verdict->setText(translated(made.message()));
    const Property& property = *std::get<SetValues>(made->edit.changes.front()).property;
    //: how many elements, and between which numbers
    m_verdict->setText(tr("%1: %2 to %3")
                           .arg(counted(property.kind, qsizetype(made->count)),
                                spokenText(made->least, property.unit),
                                spokenText(made->most, property.unit)));
}

void MapDialog::accept()
{
    Result<MappedNumbers> made = map();
    if (!made)
        return look();
    m_document.push(std::move(made->edit));
    QDialog::accept();
}

} // namespace ripstop
