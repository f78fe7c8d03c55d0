// A change of the form disables the button and starts a delay (workSoon); after it the wishes are
// posted to the worker (post); a timer shows the progress (watch); and take() shows what comes
// back: the preview, the list of findings, the counts, and what the form chose by itself. Choosing
// a finding marks its places in the preview. A preview that shows the same mesh again is left
// alone, so that its camera and its marks stay.
#include "import/import_dialog.h"

#include "document/plain_text.h"
#include "document/spoken.h"
#include "document/words.h"
#include "icons/icon.h"
#include "import/import_form.h"
#include "import/mesh_preview.h"
#include "shapes/mesh_file.h"
#include "shapes/packed_pictures.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int patience = 150;   // ms after the last change
constexpr int watchEvery = 100; // ms

// Empty where the mesh has faces only.
QString linesText(const PreparedMesh& mesh)
{
    const auto [count, length] = linesOf(mesh);
    if (count == 0)
        return {};
    return count == 1 ? ImportDialog::tr("1 line, %1 long").arg(spokenText(length, "m"))
                      : ImportDialog::tr("%1 lines, %2 long together")
                            .arg(QLocale().toString(qulonglong(count)), spokenText(length, "m"));
}

// All three lengths are in one unit, so that they can be compared.
QString sizeText(const PreparedMesh& mesh)
{
    const Vec3& size = mesh.size;
    const double largest = size.maxCoeff(); // m
    const double scale = largest >= 1.0 ? 1.0 : largest >= 0.01 ? 100.0 : 1000.0;
    const QString unit = largest >= 1.0    ? ImportDialog::tr("m")
                         : largest >= 0.01 ? ImportDialog::tr("cm")
                                           : ImportDialog::tr("mm");
    const auto text = [&](double metres) {
        return QLocale().toString(scale * metres, 'g', 4) + QChar(0x202f) + unit;
    };
    const QString box = ImportDialog::tr("%1 wide, %2 high, %3 deep")
                            .arg(text(size.x()), text(size.y()), text(size.z()));
    const QString lines = linesText(mesh);
    return lines.isEmpty() ? box : box + QStringLiteral(" \u00b7 ") + lines;
}

QString reportText(const MeshFinding& finding)
{
    QString text = translated(finding.text());
    const auto count = qulonglong(finding.count);
    return text.replace(QString::number(count), QLocale().toString(count));
}

QString massText(double kilograms) { return spokenText(kilograms, "kg"); }

QString countsText(const MeshImport& made)
{
    QStringList links;
    if (made.rods > 0)
        links << (made.rods == 1
                      ? ImportDialog::tr("1 rod")
                      : ImportDialog::tr("%1 rods").arg(QLocale().toString(qulonglong(made.rods))));
    if (made.springs > 0)
        links << (made.springs == 1 ? ImportDialog::tr("1 spring")
                                    : ImportDialog::tr("%1 springs")
                                          .arg(QLocale().toString(qulonglong(made.springs))));
    if (links.isEmpty())
        links << ImportDialog::tr("no links");
    return QStringList{counted(Kind::Particle, qsizetype(made.particles)), links.join(", "),
                       counted(Kind::Panel, qsizetype(made.panels)),
                       spokenText(made.area, "m\u00b2"), massText(made.mass)}
        .join(QStringLiteral(" \u00b7 "));
}

// Empty where no picture within the file is printed on the fabric.
QString picturesText(const MeshImport& made)
{
    QStringList names;
    for (const PolygonMesh::PackedPicture& picture : made.pictures)
        names << QFileInfo(QString::fromStdString(picture.file)).fileName();
    return names.isEmpty() ? QString()
                           : ImportDialog::tr("Pictures that lie within the file will be written "
                                              "beside it: %1.")
                                 .arg(names.join(QStringLiteral(", ")));
}

// As wide as the form in it, whose choices grow with what a file holds.
class FormScroll final : public QScrollArea
{
public:
    QSize minimumSizeHint() const override
    {
        const int width =
            widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width();
        return {width, QScrollArea::minimumSizeHint().height()};
    }

private:
    bool eventFilter(QObject* target, QEvent* event) override
    {
        if (target == widget() && event->type() == QEvent::LayoutRequest)
            updateGeometry();
        return QScrollArea::eventFilter(target, event);
    }
};

} // namespace

ImportDialog::ImportDialog(const Scene& scene, const QString& file, QWidget* parent)
    : QDialog(parent)
    , m_scene(scene)
    , m_fileName(new QLabel)
    , m_preview(new MeshPreview)
    , m_form(new ImportForm(scene))
    , m_size(new QLabel)
    , m_counts(new QLabel)
    , m_report(new QListWidget)
    , m_progress(new QProgressBar)
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel))
{
    setWindowTitle(tr("Import a mesh"));
    layOut();
    m_delay.setSingleShot(true);
    m_delay.setInterval(patience);
    m_watch.setInterval(watchEvery);
    connect(&m_delay, &QTimer::timeout, this, &ImportDialog::post);
    connect(&m_watch, &QTimer::timeout, this, &ImportDialog::watch);
    connect(&m_work, &ImportWork::finished, this, &ImportDialog::take);
    connect(m_form, &ImportForm::changed, this, &ImportDialog::workSoon);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(this, &QDialog::rejected, &m_work, &ImportWork::stop);
    connect(m_report, &QListWidget::currentRowChanged, this, [this](int row) {
        const auto findings = m_shown ? m_shown->report.findings() : std::vector<MeshFinding>();
        m_preview->mark(row >= 0 && std::size_t(row) < findings.size()
                            ? findings[std::size_t(row)].places
                            : std::vector<Vec3>());
    });
    openFile(file);
}

QString ImportDialog::askFile(QWidget* parent, const QString& folder)
{
    QStringList endings;
    for (const std::string_view extension : meshExtensions())
        endings << QStringLiteral("*.%1").arg(
            QLatin1String(extension.data(), qsizetype(extension.size())));
    return QFileDialog::getOpenFileName(parent, tr("Import a mesh"), folder,
                                        tr("Meshes (%1);;All files (*)").arg(endings.join(' ')));
}

bool ImportDialog::isMesh(const QString& file)
{
    const std::string ending = QFileInfo(file).suffix().toLower().toStdString();
    return std::ranges::find(meshExtensions(), ending) != meshExtensions().end();
}

QWidget* ImportDialog::filePlace()
{
    auto* choose = new QPushButton(icon(QStringLiteral("open")), tr("Another file\u2026"));
    choose->setToolTip(tr("OBJ, STL, PLY, OFF, glTF, GLB, Collada, VTP or VTU."));
    choose->setAutoDefault(false);
    connect(choose, &QPushButton::clicked, this, &ImportDialog::chooseFile);
    m_fileName->setTextFormat(Qt::PlainText);
    m_fileName->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* place = new QWidget;
    auto* row = new QHBoxLayout(place);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_fileName, 1);
    row->addWidget(choose);
    return place;
}

void ImportDialog::layOut()
{
    m_size->setObjectName(QStringLiteral("resultingSize"));
    m_size->setWordWrap(true); // lines make it longer than the preview is wide
    m_counts->setTextFormat(Qt::PlainText);
    m_counts->setObjectName(QStringLiteral("counts"));
    m_counts->setWordWrap(true);
    m_report->setObjectName(QStringLiteral("report"));
    m_report->setAccessibleName(tr("What was found in the mesh"));
    m_report->setWordWrap(true);
    m_report->setToolTip(tr("Choose a line to see in the picture where the first ones are."));
    m_report->setMinimumHeight(4 * fontMetrics().lineSpacing() + 12);
    m_report->setMaximumHeight(9 * fontMetrics().lineSpacing());
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_progress->setMaximumHeight(6);
    QSizePolicy keepsPlace = m_progress->sizePolicy();
    keepsPlace.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(keepsPlace);
    m_progress->hide();
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("Import"));

    auto* seen = new QVBoxLayout;
    seen->addWidget(m_preview, 1);
    seen->addWidget(m_size);
    seen->addWidget(m_report);

    auto* scroll = new FormScroll;
    scroll->setWidget(m_form);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(14);
    columns->addLayout(seen, 1);
    columns->addWidget(scroll);

    auto* layout = new QVBoxLayout(this);
    layout->addWidget(filePlace());
    layout->addLayout(columns, 1);
    layout->addWidget(m_counts);
    layout->addWidget(m_progress);
    layout->addWidget(m_buttons);
    resize(940, 660);
}

void ImportDialog::chooseFile()
{
    const QString file = askFile(this, QFileInfo(m_file).path());
    if (!file.isEmpty())
        openFile(file);
}

void ImportDialog::openFile(const QString& file)
{
    m_file = file;
    m_fileName->setText(QFileInfo(file).fileName());
    m_fileName->setToolTip(shownAsIs(QDir::toNativeSeparators(QFileInfo(file).absoluteFilePath())));
    m_form->startFile(file);
    m_shown = nullptr;
    m_preview->setMesh(nullptr);
    m_preview->setHint(tr("Reading\u2026"));
    post();
}

void ImportDialog::setReady(bool isReady)
{
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(isReady);
    m_counts->setEnabled(isReady);
}

void ImportDialog::workSoon()
{
    setReady(false);
    m_delay.start();
}

void ImportDialog::post()
{
    m_delay.stop();
    setReady(false);
    m_outcome = nullptr;
    m_work.post(
        {m_file, m_form->shape(), m_form->fabric(), m_form->name(), surroundingsOf(m_scene)});
    m_watch.start();
}

void ImportDialog::watch()
{
    m_progress->setVisible(m_work.isBusy());
    m_progress->setValue(int(1000.0 * m_work.share()));
    if (!m_work.isBusy())
        m_watch.stop();
}

void ImportDialog::take(std::shared_ptr<const ImportOutcome> outcome)
{
    watch();
    m_outcome = std::move(outcome);
    m_form->follow(*m_outcome);
    if (!m_outcome->refusal.isEmpty())
        m_preview->setHint(tr("There is nothing to show."));
    if (!m_outcome->mesh || m_outcome->mesh != m_shown) { // else the camera and the marks stay
        m_shown = m_outcome->mesh;
        m_preview->setMesh(m_shown);
        m_size->setText(m_shown ? sizeText(*m_shown) : QString());
        showReport();
    }
    QStringList lines{isReady() ? countsText(m_outcome->made) : m_outcome->refusal};
    if (const QString pictures = picturesText(m_outcome->made); !pictures.isEmpty())
        lines << pictures;
    if (const auto off = threadsComplaint(m_outcome->made); off && isReady())
        lines << translated(*off);
    m_counts->setText(lines.join(QChar('\n')));
    setReady(isReady() && !m_delay.isActive());
    m_counts->setEnabled(!m_delay.isActive()); // a refusal is to be read, too
    if (!m_delay.isActive())
        emit settled();
}

// What cannot be written does not stop the import: the check names the materials that miss it.
void ImportDialog::accept()
{
    QStringList refusals;
    for (const PolygonMesh::PackedPicture& picture : result().pictures)
        if (const auto failure = unpack(picture))
            refusals << translated(failure->message);
    if (!refusals.isEmpty())
        QMessageBox::warning(this, tr("Fabric without its picture"),
                             shownAsIs(refusals.join(QChar('\n'))));
    QDialog::accept();
}

void ImportDialog::showReport()
{
    const QSignalBlocker quiet(m_report);
    m_report->clear();
    if (!m_shown)
        return;
    const char* const icons[]{"about", "ok", "warning"}; // in the order of MeshGravity
    for (const MeshFinding& finding : m_shown->report.findings())
        m_report->addItem(new QListWidgetItem(
            icon(QLatin1String(icons[int(gravityOf(finding.fault))])), reportText(finding)));
    if (m_report->count() == 0)
        m_report->addItem(new QListWidgetItem(icon(QStringLiteral("ok")),
                                              tr("Nothing is wrong with this mesh.")));
}

} // namespace ripstop
