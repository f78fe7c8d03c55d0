#include "editor/export_dialog.h"

#include "compile/compile.h"
#include "editor/ask_file.h"
#include "export/export_run.h"
#include "io/control_track.h"
#include "io/tear_table.h"
#include "run/tear_report.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace ripstop {
namespace {

enum class Content { Mesh, Tears, Controls, Series }; // of now, until now twice, of another run

struct Format
{
    const char* ending; // after the name of the scene
    const char* label;
    Content content;
};

constexpr Format formats[]{
    {".obj", QT_TRANSLATE_NOOP("ExportDialog", "Mesh of this moment, OBJ"), Content::Mesh},
    {".ply", QT_TRANSLATE_NOOP("ExportDialog", "Mesh of this moment, PLY"), Content::Mesh},
    {".vtp", QT_TRANSLATE_NOOP("ExportDialog", "Mesh of this moment with strains and loads, VTP"),
     Content::Mesh},
    {".pvd", QT_TRANSLATE_NOOP("ExportDialog", "Series for ParaView, PVD and VTP"),
     Content::Series},
    {".csv", QT_TRANSLATE_NOOP("ExportDialog", "Table of the probes, CSV"), Content::Series},
    {"_tears.csv", QT_TRANSLATE_NOOP("ExportDialog", "Table of what has torn, CSV"),
     Content::Tears},
    {"_controls.csv", QT_TRANSLATE_NOOP("ExportDialog", "Control track of this run, CSV"),
     Content::Controls}};

QString extensionOf(const Format& format)
{
    return QString(format.ending).mid(QString(format.ending).indexOf('.'));
}

QString tearsInWords(const Frame* frame)
{
    if (!frame || frame->tears.empty())
        return ExportDialog::tr("Nothing has torn in the run on the screen: the table will be "
                                "empty.");
    const TearReport report = tearReport(frame->tears);
    const auto rounded = [](double value) { return QString::number(value, 'g', 4); };
    return ExportDialog::tr("Links that broke in the run on the screen: %1, the first at %2 s. The "
                            "tear went %3 m far and released %4 J.")
        .arg(report.count)
        .arg(rounded(frame->tears.front().time), rounded(report.front.back().distance),
             rounded(report.energy));
}

QString inWords(Content content, const Frame* now)
{
    switch (content) {
    case Content::Mesh:
        return ExportDialog::tr("The shape that the view shows now.");
    case Content::Tears:
        return tearsInWords(now);
    case Content::Controls:
        return now && !(now->commands.empty() && now->hands.empty())
                   ? ExportDialog::tr(
                         "What the pilot and your hands did in this run: %1 commands, %2 moves of "
                         "the hand. ripstop-cli run --controls does them again, in this or "
                         "another design.")
                         .arg(now->commands.size())
                         .arg(now->hands.size())
                   : ExportDialog::tr("No control and no hand has moved anything in this run.");
    case Content::Series:
        break;
    }
    return ExportDialog::tr("The scene is simulated anew from its start, without what was changed "
                            "by hand during the run on the screen.");
}

std::optional<Failure> writeNow(Content content, const Scene& scene, const Frame& now,
                                const std::filesystem::path& file)
{
    if (content == Content::Tears)
        return writeTears(scene, now.tears, file);
    if (content == Content::Controls)
        return writeControlTrack(scene, trackOf(now), file);
    return writeMoment(now, Dress(scene), file);
}

QDoubleSpinBox* seconds(double value)
{
    auto* box = new QDoubleSpinBox;
    box->setRange(0.0, 100000.0);
    box->setDecimals(2);
    box->setSuffix(" s");
    box->setValue(value);
    return box;
}

} // namespace

ExportDialog::ExportDialog(const Scene& scene, std::shared_ptr<const Frame> now,
                           const QString& stem, QWidget* parent)
    : QDialog(parent)
    , m_scene(scene)
    , m_now(std::move(now))
    , m_stem(stem)
    , m_format(new QComboBox)
    , m_target(new QLineEdit)
    , m_from(seconds(0.0))
    , m_to(seconds(m_now && m_now->time > 0.0 ? m_now->time : 10.0))
    , m_fps(new QDoubleSpinBox)
    , m_message(new QLabel)
    , m_progress(new QProgressBar)
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Cancel))
{
    setWindowTitle(tr("Export"));
    for (const Format& format : formats)
        m_format->addItem(tr(format.label));
    m_fps->setRange(0.1, 10000.0);
    m_fps->setValue(25.0);
    m_fps->setSuffix(tr(" per s"));
    m_fps->setToolTip(tr("Pictures per second of simulated time; a table has a row for each."));

    auto* browse = new QToolButton;
    browse->setText(tr("…"));
    browse->setToolTip(tr("Choose the file"));
    auto* file = new QHBoxLayout;
    file->addWidget(m_target);
    file->addWidget(browse);

    auto* form = new QFormLayout;
    form->addRow(tr("Format"), m_format);
    form->addRow(tr("File"), file);
    form->addRow(tr("From"), m_from);
    form->addRow(tr("To"), m_to);
    form->addRow(tr("Rate"), m_fps);

    m_message->setWordWrap(true);
    m_progress->setRange(0, 1000);
    m_progress->hide();
    QPushButton* go = m_buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
    go->setDefault(true);

    auto* layout = new QVBoxLayout(this);
    layout->addLayout(form);
    layout->addWidget(m_message);
    layout->addWidget(m_progress);
    layout->addWidget(m_buttons);
    setMinimumWidth(520);

    connect(m_format, &QComboBox::currentIndexChanged, this, &ExportDialog::chooseFormat);
    connect(browse, &QToolButton::clicked, this, &ExportDialog::browse);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &ExportDialog::start);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &ExportDialog::reject);
    connect(&m_watch, &QTimer::timeout, this, &ExportDialog::watch);
    chooseFormat();
}

ExportDialog::~ExportDialog()
{
    m_cancelled = true;
    if (m_work.valid())
        m_work.wait();
}

QString ExportDialog::target() const { return m_target->text(); }

void ExportDialog::chooseFormat()
{
    const Format& format = formats[m_format->currentIndex()];
    m_target->setText(m_stem + format.ending);
    for (QWidget* field :
         {static_cast<QWidget*>(m_from), static_cast<QWidget*>(m_to), static_cast<QWidget*>(m_fps)})
        field->setEnabled(format.content == Content::Series);
    m_message->setText(inWords(format.content, m_now.get()));
}

void ExportDialog::browse()
{
    const QString extension = extensionOf(formats[m_format->currentIndex()]);
    const QString file =
        askWhereToSave(this, tr("Export as"), m_target->text(), "*" + extension, extension.mid(1));
    if (file.isEmpty())
        return;
    m_target->setText(file);
    m_mayReplace = file; // the file dialog has asked
}

void ExportDialog::start()
{
    if (m_work.valid())
        return;
    if (!mayWrite())
        return;
    const std::filesystem::path file = m_target->text().toStdString();
    const Content content = formats[m_format->currentIndex()].content;
    if (content != Content::Series) {
        if (!m_now)
            return end(tr("There is nothing on the screen to export; see the list of problems."));
        const auto failure = writeNow(content, m_scene, *m_now, file);
        return failure ? end(QString::fromStdString(failure->message)) : accept();
    }
    if (m_to->value() <= m_from->value())
        return end(tr("The series ends before it begins: make To later than From."));

    m_cancelled = false;
    m_done = 0.0;
    m_progress->show();
    m_progress->setValue(0);
    const ExportRange range{m_from->value(), m_to->value(), m_fps->value()};
    m_work = std::async(std::launch::async, [this, file, range]() -> QString {
        const auto system = compile(m_scene);
        if (!system)
            return QString::fromStdString(system.message());
        Simulation simulation(*system);
        const auto failure = ripstop::exportRun(simulation, Dress(m_scene), range, file, [this](double done) {
            m_done = done;
            return !m_cancelled;
        });
        return failure ? QString::fromStdString(failure->message) : QString();
    });
    m_watch.start(50);
}

bool ExportDialog::mayWrite()
{
    const QString file = m_target->text();
    if (!QFileInfo::exists(file) || file == m_mayReplace)
        return true;
    const auto answer = QMessageBox::question(
        this, tr("Replace the file?"),
        tr("%1 exists already. Replace it?").arg(QDir::toNativeSeparators(file)));
    return answer == QMessageBox::Yes;
}

void ExportDialog::watch()
{
    m_progress->setValue(int(1000 * m_done));
    if (m_work.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return;
    m_watch.stop();
    const QString failure = m_work.get();
    if (failure.isEmpty())
        accept(); // also when it was done before it saw that it should stop
    else
        end(m_cancelled ? tr("Cancelled; nothing was kept.") : failure);
}

void ExportDialog::end(const QString& failure)
{
    m_progress->hide();
    m_message->setText(failure);
}

void ExportDialog::reject()
{
    if (m_work.valid())
        m_cancelled = true; // watch() sees the end of it
    else
        QDialog::reject();
}

} // namespace ripstop
