// layOut() makes the form, takeKept() sets what was chosen last. chooseSize() follows the list of
// sizes; a number that is typed goes there as a size of one's own, and the other one follows it.
// preview() draws the picture as large as its place is.
#include "files/picture_dialog.h"

#include "viewport/viewport.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <array>

namespace ripstop {
namespace {

constexpr std::array endings{"png", "jpg", "svg", "pdf"};
constexpr QSize previewSize(420, 300); // pixels
constexpr int paperWidth = 3000;       // pixels: 25 cm at 300 dots per inch
constexpr int previewDelay = 120;      // ms
enum Size { Window, Twice, FourTimes, Paper, Own };

QSpinBox* pixels(const QString& name)
{
    auto* box = new QSpinBox;
    box->setRange(16, mostPixels);
    box->setAccessibleName(name);
    return box;
}

// What shows through a transparent picture, as in programs that edit pictures.
QPixmap onChequers(const QImage& picture)
{
    constexpr int side = 8;
    QPixmap page(picture.size());
    QPainter painter(&page);
    for (int y = 0; y < page.height(); y += side)
        for (int x = 0; x < page.width(); x += side)
            painter.fillRect(x, y, side, side,
                             (x / side + y / side) % 2 ? QColor(204, 204, 204) : Qt::white);
    painter.drawImage(0, 0, picture);
    return page;
}

} // namespace

PictureDialog::PictureDialog(Viewport& viewport, QWidget* parent)
    : QDialog(parent)
    , m_viewport(viewport)
    , m_view(viewport.size() * viewport.devicePixelRatioF())
    , m_format(new QComboBox)
    , m_sizes(new QComboBox)
    , m_width(pixels(tr("Width")))
    , m_height(pixels(tr("Height")))
    , m_backdrop(new QComboBox)
    , m_overlays(new QCheckBox(tr("&Legend and compass")))
    , m_pins(new QCheckBox(tr("&Pins")))
    , m_note(new QLabel)
    , m_preview(new QLabel)
{
    setWindowTitle(tr("Picture of the view"));
    layOut();
    takeKept();
    chooseSize();

    m_soon.setSingleShot(true);
    m_soon.setInterval(previewDelay);
    connect(&m_soon, &QTimer::timeout, this, &PictureDialog::preview);
    const auto soon = [this] { m_soon.start(); };
    connect(m_sizes, &QComboBox::currentIndexChanged, this, &PictureDialog::chooseSize);
    connect(m_width, &QSpinBox::valueChanged, this, [this] { keepShape(*m_width, *m_height); });
    connect(m_height, &QSpinBox::valueChanged, this, [this] { keepShape(*m_height, *m_width); });
    for (QSpinBox* box : {m_width, m_height})
        connect(box, &QSpinBox::valueChanged, this, soon);
    for (QComboBox* list : {m_format, m_sizes, m_backdrop})
        connect(list, &QComboBox::currentIndexChanged, this, soon);
    for (QCheckBox* box : {m_overlays, m_pins})
        connect(box, &QCheckBox::toggled, this, soon);
    preview();
}

void PictureDialog::layOut()
{
    m_format->addItems({tr("PNG: pixels, may be transparent"), tr("JPEG: pixels, small"),
                        tr("SVG: legend and compass as text"), tr("PDF: a page, with text")});
    m_sizes->addItems({tr("As in the window"), tr("Twice as large"), tr("Four times as large"),
                       tr("For a page (3000 pixels wide)"), tr("Own size")});
    m_backdrop->addItems(
        {tr("Sky and ground"), tr("White paper, with shadows"), tr("Transparent")});
    const std::pair<QWidget*, const char*> names[]{
        {m_format, "format"}, {m_sizes, "sizes"},       {m_width, "width"},
        {m_height, "height"}, {m_backdrop, "backdrop"}, {m_overlays, "overlays"},
        {m_pins, "pins"}};
    for (const auto& [field, name] : names)
        field->setObjectName(name);
    m_note->setWordWrap(true);
    m_note->setForegroundRole(QPalette::PlaceholderText);
    m_preview->setAlignment(Qt::AlignCenter);
    m_preview->setFixedSize(previewSize);
    m_preview->setFrameShape(QFrame::StyledPanel);

    auto* size = new QWidget;
    auto* row = new QHBoxLayout(size);
    row->setContentsMargins({});
    for (QWidget* part : std::initializer_list<QWidget*>{m_width, new QLabel(tr("×")), m_height,
                                                         new QLabel(tr("pixels"))})
        row->addWidget(part);
    row->addStretch();
    auto* form = new QFormLayout;
    form->addRow(tr("&Kind:"), m_format);
    form->addRow(tr("&Size:"), m_sizes);
    form->addRow(QString(), size);
    form->addRow(tr("&Background:"), m_backdrop);
    m_pins->setToolTip(tr("The marks of particles that are held in place."));
    auto* shown = new QHBoxLayout;
    shown->addWidget(m_overlays);
    shown->addWidget(m_pins);
    shown->addStretch();
    form->addRow(QString(), shown);
    form->addRow(m_note);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    auto* go = buttons->addButton(tr("Choose the &file…"), QDialogButtonBox::AcceptRole);
    go->setObjectName("go");
    go->setDefault(true);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        keep();
        accept();
    });
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_preview);
    layout->addLayout(form);
    layout->addWidget(buttons);
}

void PictureDialog::takeKept()
{
    const QSettings settings;
    m_format->setCurrentIndex(
        std::clamp(settings.value("picture/kind", 0).toInt(), 0, int(endings.size()) - 1));
    m_sizes->setCurrentIndex(
        std::clamp(settings.value("picture/size", int(Paper)).toInt(), int(Window), int(Paper)));
    m_backdrop->setCurrentIndex(std::clamp(settings.value("picture/backdrop", 0).toInt(), 0, 2));
    m_overlays->setChecked(settings.value("picture/overlays", true).toBool());
    m_pins->setChecked(settings.value("picture/pins", false).toBool());
}

PictureLook PictureDialog::look() const
{
    return {QSize(m_width->value(), m_height->value()), Backdrop(m_backdrop->currentIndex()),
            m_overlays->isChecked(), m_pins->isChecked()};
}

QString PictureDialog::ending() const
{
    return QString::fromLatin1(endings[std::size_t(m_format->currentIndex())]);
}

void PictureDialog::chooseSize()
{
    const int chosen = m_sizes->currentIndex();
    if (chosen == Own)
        return;
    const QSize size = chosen == Paper ? sizeOfWidth(paperWidth, m_view)
                                       : m_view
                                             * (chosen == Twice       ? 2
                                                : chosen == FourTimes ? 4
                                                                      : 1);
    const QSignalBlocker width(m_width), height(m_height);
    m_width->setValue(size.width());
    m_height->setValue(size.height());
}

void PictureDialog::keepShape(QSpinBox& changed, QSpinBox& other)
{
    const QSize shape = &changed == m_width ? m_view : m_view.transposed();
    const QSignalBlocker blocker(&other);
    other.setValue(sizeOfWidth(changed.value(), shape).height());
    m_sizes->setCurrentIndex(Own);
}

void PictureDialog::preview()
{
    PictureLook look = this->look();
    const bool keepsAlpha = ending() != QLatin1String("jpg");
    if (look.backdrop == Backdrop::Transparent && !keepsAlpha)
        look.backdrop = Backdrop::White;
    m_note->setText(keepsAlpha || m_backdrop->currentIndex() != int(Backdrop::Transparent)
                        ? tr("%1 cm wide at 300 dots per inch.")
                              .arg(QLocale().toString(look.size.width() / 300.0 * 2.54, 'f', 1))
                        : tr("JPEG has no transparency: the background will be white."));
    look.size.scale(previewSize, Qt::KeepAspectRatio);
    m_preview->setPixmap(onChequers(pixelsOf(m_viewport, look)));
}

void PictureDialog::keep() const
{
    QSettings settings;
    settings.setValue("picture/kind", m_format->currentIndex());
    if (m_sizes->currentIndex() != Own)
        settings.setValue("picture/size", m_sizes->currentIndex());
    settings.setValue("picture/backdrop", m_backdrop->currentIndex());
    settings.setValue("picture/overlays", m_overlays->isChecked());
    settings.setValue("picture/pins", m_pins->isChecked());
}

} // namespace ripstop
