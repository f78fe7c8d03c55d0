// Stages: layOut() makes one form for all formats, and chooseFormat() shows the rows that a format
// needs. Every change leads to showPreview(), which says what would be written, or by whyNot() why
// nothing can be. What is written, and how, is in export_dialog_work.cpp.
#include "files/export_dialog.h"

#include "document/ask_file.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double unflownSeconds = 10.0; // s, of a flight that nobody has seen yet

QDoubleSpinBox* seconds(double value)
{
    auto* box = new QDoubleSpinBox;
    box->setRange(0.0, 100000.0);
    box->setDecimals(2);
    box->setSuffix(" s");
    box->setValue(value);
    return box;
}

QSpinBox* pixels(int value, const QString& name)
{
    auto* box = new QSpinBox;
    box->setAccessibleName(name);
    box->setRange(16, 16384);
    box->setValue(value);
    return box;
}

QWidget* inOneRow(std::initializer_list<QWidget*> widgets)
{
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins({});
    for (QWidget* widget : widgets)
        layout->addWidget(widget);
    layout->addStretch();
    return row;
}

bool wasDoneByHand(const Frame* frame)
{
    return frame && !(frame->commands.empty() && frame->hands.empty());
}

// ".csv" of "_tears.csv".
QString extensionOf(const ExportChoice& choice)
{
    return choice.ending.mid(choice.ending.lastIndexOf('.'));
}

} // namespace

ExportDialog::ExportDialog(const Matter& matter, const QString& stem, Draw draw, QSize view,
                           QWidget* parent)
    : QDialog(parent)
    , m_scene(matter.scene)
    , m_appearance(m_scene)
    , m_now(matter.now)
    , m_recording(matter.recording)
    , m_stem(stem)
    , m_draw(std::move(draw))
    , m_choices(exportChoices())
    , m_fields(new QWidget)
    , m_form(new QFormLayout(m_fields))
    , m_format(new QComboBox)
    , m_target(new QLineEdit)
    , m_source(new QComboBox)
    , m_from(seconds(0.0))
    , m_to(seconds(m_now && m_now->time > 0.0 ? m_now->time : unflownSeconds))
    , m_fps(new QDoubleSpinBox)
    , m_speed(new QDoubleSpinBox)
    , m_again(new QCheckBox(tr("Do again what the pilot and your hands did")))
    , m_width(pixels(view.width(), tr("Width")))
    , m_height(pixels(view.height(), tr("Height")))
    , m_size(inOneRow({m_width, new QLabel(tr("×")), m_height, new QLabel(tr("pixels"))}))
    , m_overlays(new QCheckBox(tr("&Legend and compass")))
    , m_time(new QCheckBox(tr("T&ime")))
    , m_probes(new QCheckBox(tr("&Probes that are plotted")))
    , m_pins(new QCheckBox(tr("Pi&ns")))
    , m_shown(inOneRow({m_time, m_probes, m_overlays, m_pins}))
    , m_transparent(new QCheckBox(tr("Transparent &background")))
    , m_note(new QLabel)
    , m_message(new QLabel)
    , m_progress(new QProgressBar)
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Cancel))
{
    setWindowTitle(tr("Export"));
    layOut();
    connect(m_format, &QComboBox::currentIndexChanged, this, &ExportDialog::chooseFormat);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &ExportDialog::start);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &ExportDialog::reject);
    m_target->setAccessibleName(tr("File"));
    connect(m_target, &QLineEdit::textEdited, this, &ExportDialog::followEnding);
    connect(m_target, &QLineEdit::textChanged, this, &ExportDialog::showPreview);
    // where a name without a folder goes is to be seen
    connect(m_target, &QLineEdit::editingFinished, this, [this, folder = QFileInfo(stem).dir()] {
        const QString typed = m_target->text();
        if (!typed.isEmpty() && QFileInfo(typed).isRelative())
            m_target->setText(folder.absoluteFilePath(typed));
        followEnding(m_target->text());
    });
    for (QDoubleSpinBox* box : {m_from, m_to, m_fps, m_speed})
        connect(box, &QDoubleSpinBox::valueChanged, this, &ExportDialog::showPreview);
    for (QSpinBox* box : {m_width, m_height})
        connect(box, &QSpinBox::valueChanged, this, &ExportDialog::showPreview);
    connect(m_source, &QComboBox::currentIndexChanged, this, &ExportDialog::chooseSource);
    connect(&m_watch, &QTimer::timeout, this, &ExportDialog::watch);
    if (m_recording && !isFlight())
        m_source->setCurrentIndex(m_source->count() - 1);
    chooseSource();
    if (matter.range && isFlight()) {
        m_from->setValue(matter.range->first);
        m_to->setValue(matter.range->second);
    }
    chooseFormat();
}

void ExportDialog::layOut()
{
    for (const ExportChoice& choice : m_choices)
        m_format->addItem(choice.label);
    m_format->setMaxVisibleItems(int(m_choices.size()));
    if (m_recording)
        m_source->addItem(tr("The run as it was recorded"));
    m_source->addItem(tr("Simulated anew from the start of the scene"));
    m_fps->setRange(0.1, 10000.0);
    const double steps = 1.0 / m_scene.settings.timeStep;             // a second
    m_fps->setValue(steps / std::max(1.0, std::round(steps / 25.0))); // a frame every so many steps
    m_fps->setSuffix(tr(" per s"));
    m_fps->setToolTip(tr("Frames per second: of simulated time for meshes and tables, of the film "
                         "for films."));
    m_speed->setRange(0.001, 1000.0);
    m_speed->setDecimals(3);
    m_speed->setValue(1.0);
    m_speed->setPrefix(tr("× "));
    m_speed->setToolTip(
        tr("How fast the film shows the flight; 0.1 is ten times slower than it is."));
    m_again->setChecked(true);
    const std::pair<QWidget*, const char*> names[]{
        {m_source, "source"},   {m_from, "from"},
        {m_to, "to"},           {m_fps, "rate"},
        {m_speed, "speed"},     {m_width, "width"},
        {m_height, "height"},   {m_transparent, "transparent"},
        {m_message, "message"}, {m_pins, "pins"}};
    for (const auto& [field, name] : names)
        field->setObjectName(name);
    m_overlays->setChecked(true);
    m_time->setChecked(true);
    m_pins->setToolTip(tr("The marks of particles that are held in place."));

    auto* browse = new QToolButton;
    browse->setText(tr("…"));
    browse->setToolTip(tr("Choose the file"));
    connect(browse, &QToolButton::clicked, this, &ExportDialog::browse);
    auto* file = new QWidget;
    auto* fileRow = new QHBoxLayout(file);
    fileRow->setContentsMargins({});
    fileRow->addWidget(m_target);
    fileRow->addWidget(browse);
    file->setFocusProxy(m_target);

    m_form->addRow(tr("F&ormat"), m_format);
    m_note->setWordWrap(true);
    m_note->setForegroundRole(QPalette::PlaceholderText);
    m_form->addRow(QString(), m_note);
    m_form->addRow(tr("Fi&le"), file);
    qobject_cast<QLabel*>(m_form->labelForField(file))->setBuddy(m_target);
    m_form->addRow(tr("F&light"), m_source);
    m_form->addRow(tr("F&rom"), m_from);
    m_form->addRow(tr("&To"), m_to);
    m_form->addRow(tr("R&ate"), m_fps);
    m_form->addRow(tr("&Speed"), m_speed);
    m_form->addRow(tr("Si&ze"), m_size);
    qobject_cast<QLabel*>(m_form->labelForField(m_size))->setBuddy(m_width);
    m_form->addRow(tr("Show"), m_shown);
    m_form->addRow(QString(), m_transparent);
    m_form->addRow(QString(), m_again);

    m_message->setTextFormat(Qt::PlainText);
    m_message->setWordWrap(true);
    m_message->setMinimumHeight(3 * fontMetrics().lineSpacing());
    m_message->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_progress->setRange(0, 1000);
    QSizePolicy policy = m_progress->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(policy);
    m_progress->hide();
    m_go = m_buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
    m_go->setObjectName(QStringLiteral("go"));
    m_go->setDefault(true);

    auto* layout = new QVBoxLayout(this);
    m_form->setContentsMargins({});
    for (int row = 0; row < m_form->rowCount(); ++row)
        if (const QLayoutItem* label = m_form->itemAt(row, QFormLayout::LabelRole))
            // an underlined letter breaks the kerning, which the hint forgets
            label->widget()->setMinimumWidth(label->sizeHint().width() + 4);
    layout->addWidget(m_fields);
    layout->addWidget(m_message);
    layout->addStretch();
    layout->addWidget(m_progress);
    layout->addWidget(m_buttons);
    setMinimumWidth(560);
    m_format->setFocus();
}

// The file always has the extension of the chosen format, because exporters go by it.
QString ExportDialog::target() const
{
    const QString extension = extensionOf(choice());
    const QString typed = m_target->text();
    return typed.endsWith(extension, Qt::CaseInsensitive) ? typed : typed + extension;
}

const ExportChoice& ExportDialog::choice() const
{
    return m_choices[std::size_t(m_format->currentIndex())];
}

ExportRange ExportDialog::range() const
{
    const double perSecond = choice().film() ? m_fps->value() / m_speed->value() : m_fps->value();
    const bool isPaced = choice().film() || (choice().mesh() && choice().mesh()->isPaced);
    return {m_from->value(), std::max(m_to->value(), m_from->value()), perSecond, isPaced};
}

std::size_t ExportDialog::frames() const
{
    const double timeStep =
        isRecorded() ? RecordedFrames(m_recording).timeStep() : m_scene.settings.timeStep;
    return choice().isSeries() ? frameCount(range(), timeStep) : 1;
}

// The fields show hundredths of a second: what is recorded begins at the next and ends at the last,
// so that all between them is in reach.
std::pair<double, double> ExportDialog::recorded() const
{
    const RecordedFrames frames(m_recording);
    const double begin = std::ceil(100.0 * frames.begin() - 0.01) / 100.0;
    return {begin, std::max(begin, std::floor(100.0 * frames.end() + 0.01) / 100.0)};
}

bool ExportDialog::isFlight() const { return m_recording && recorded().first < recorded().second; }

bool ExportDialog::isRecorded() const { return m_recording && m_source->currentIndex() == 0; }

ExportDialog::Job ExportDialog::job() const
{
    return {choice(),
            target(),
            range(),
            isRecorded(),
            m_now && m_again->isChecked() ? trackOf(*m_now) : ControlTrack(),
            m_fps->value(),
            {.size = QSize(m_width->value(), m_height->value()),
             .overlays = m_overlays->isChecked(),
             .time = m_time->isChecked(),
             .probes = m_probes->isChecked(),
             // the picture of a bundle is the view as it is
             .pins = m_pins->isChecked() || !choice().film(),
             .transparent = m_transparent->isChecked(),
             .inPercent = sharesOf(m_scene)}};
}

// A recording has a beginning and an end; what is simulated goes on as long as one likes.
void ExportDialog::chooseSource()
{
    if (isRecorded()) {
        const auto [begin, end] = recorded();
        for (QDoubleSpinBox* box : {m_from, m_to})
            box->setRange(begin, end);
        m_from->setValue(begin);
        m_to->setValue(end);
    } else {
        for (QDoubleSpinBox* box : {m_from, m_to})
            box->setRange(0.0, 100000.0);
        if (m_to->value() <= m_from->value()) // as after a recording of one moment
            m_to->setValue(m_from->value() + unflownSeconds);
    }
    chooseFormat();
}

// The ending that is typed says which format, as it does in the terminal: of several with the same
// one that which is chosen, or the first. The name stays when another format is chosen after it.
void ExportDialog::followEnding(const QString& typed)
{
    const auto has = [&typed](const ExportChoice& choice) {
        return typed.endsWith(choice.ending, Qt::CaseInsensitive);
    };
    m_stem = has(choice()) ? typed.chopped(choice().ending.size()) : typed;
    const auto isNumbered = [](const QString& name) {
        return name.contains(QString::fromUtf8(framePlaceholder.data()));
    };
    if (typed.endsWith(extensionOf(choice()), Qt::CaseInsensitive)
        && isNumbered(typed) == isNumbered(choice().ending))
        return;
    // a sequence of files ends as one file of it does, and with more before that
    const auto meant = std::ranges::max_element(
        m_choices, {}, [&](const ExportChoice& one) { return has(one) ? one.ending.size() : 0; });
    if (!has(*meant))
        return;
    m_stem = typed.chopped(meant->ending.size());
    m_format->setCurrentIndex(int(meant - m_choices.begin()));
}

// Whole rows of the form are hidden, which QFormLayout can do since Qt 6.4.
void ExportDialog::chooseFormat()
{
    const ExportChoice& chosen = choice();
    if (!m_target->text().endsWith(chosen.ending, Qt::CaseInsensitive))
        m_target->setText(m_stem + chosen.ending);
    m_note->setText(chosen.note);
    m_note->setMinimumHeight(2 * m_note->fontMetrics().lineSpacing()); // the longest has two
    m_form->setRowVisible(m_source, chosen.isFlown() && m_recording);
    for (QWidget* field : {m_from, m_fps})
        m_form->setRowVisible(field, chosen.isSeries());
    // a recording is bundled as a whole
    m_form->setRowVisible(m_to, chosen.isSeries() || (chosen.isBundle() && !isRecorded()));
    m_form->setRowVisible(m_again, chosen.isFlown() && !isRecorded() && wasDoneByHand(m_now.get()));
    for (QWidget* field : std::initializer_list<QWidget*>{m_speed, m_size, m_shown})
        m_form->setRowVisible(field, chosen.film() != nullptr);
    m_form->setRowVisible(m_transparent,
                          chosen.film() && chosen.film()->alpha == FilmFormat::Alpha::Kept);
    showPreview();
}

// Why nothing can be written as the fields stand; empty when it can.
QString ExportDialog::whyNot() const
{
    if (const FilmFormat* film = choice().film())
        if (const QString why = whyNoFilm(*film); !why.isEmpty())
            return why;
    if (choice().isSeries() && m_to->value() <= m_from->value())
        return tr("The series ends before it begins: make To later than From.");
    const QFileInfo file(target());
    if (file.completeBaseName().isEmpty())
        return tr("Give the file a name before its ending.");
    if (!file.dir().exists())
        return tr("There is no folder %1; choose another.")
            .arg(QDir::toNativeSeparators(file.path()));
    return {};
}

void ExportDialog::showPreview()
{
    if (m_work.valid())
        return;
    const QString why = whyNot();
    m_go->setEnabled(why.isEmpty());
    if (!why.isEmpty())
        return m_message->setText(why);
    QString text = previewOf(choice(), target(), frames(), m_appearance, m_scene, m_now.get(),
                             QSize(m_width->value(), m_height->value()));
    if (choice().isFlown())
        text += ' '
                + (isRecorded() ? tr("It is taken from the recording, as it was flown.")
                   : isFlight() ? tr("The scene is simulated anew from its start.")
                                : tr("No flight is recorded, so the scene is simulated anew from "
                                     "its start."));
    m_message->setText(text);
}

void ExportDialog::browse()
{
    const QString extension = extensionOf(choice());
    const QString file =
        askWhereToSave(this, tr("Export as"), m_target->text(), "*" + extension, extension.mid(1));
    if (file.isEmpty())
        return;
    m_target->setText(file);
    m_mayReplace = file; // the file dialog has asked already
}

void ExportDialog::choose(const QString& ending)
{
    for (std::size_t i = 0; i < m_choices.size(); ++i)
        if (m_choices[i].ending == ending)
            m_format->setCurrentIndex(int(i));
}

QString ExportDialog::ending() const { return choice().ending; }

} // namespace ripstop
