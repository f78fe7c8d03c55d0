#include "editor/builder_dialog.h"

#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "document/words.h"
#include "editor/figures_text.h"
#include "start/parameter_form.h"
#include "viewport/viewport.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int patience = 120;            // ms after the last change
constexpr std::size_t mostShown = 20000; // particles that are shown while one types
constexpr int formWidth = 440;           // pixels
constexpr int margin = 24;               // pixels, from the edge of the window

QString text(std::string_view words)
{
    return QString::fromUtf8(words.data(), qsizetype(words.size()));
}

} // namespace

// A view with a document of its own.
struct BuilderDialog::Preview
{
    Document document;
    Selection selection{document};
    Player player{document};
    Viewport* view = new Viewport(document, selection, player); // the dialog owns it
};

BuilderDialog::BuilderDialog(const QString& builder, QWidget* parent)
    : BuilderDialog(builder, std::nullopt, parent)
{}

BuilderDialog::BuilderDialog(const QString& builder, const OpenDesign& open, QWidget* parent)
    : BuilderDialog(builder, std::optional(open), parent)
{}

BuilderDialog::BuilderDialog(const QString& builder, std::optional<OpenDesign> open,
                             QWidget* parent)
    : QDialog(parent)
    , m_open(open)
    , m_builders(new QComboBox)
    , m_help(new QLabel)
    , m_scroll(new QScrollArea)
    , m_figures(new QLabel)
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel
                                     | QDialogButtonBox::RestoreDefaults))
    , m_worker(outcomeOf, [this] {
        QMetaObject::invokeMethod(this, &BuilderDialog::collect, Qt::QueuedConnection);
    })
{
    setWindowTitle(m_open ? tr("Insert") : tr("New from builder"));
    for (const Builder& one : allBuilders())
        m_builders->addItem(text(one.label), text(one.name));
    if (m_open) {
        m_selected = m_open->selection.ids();
        m_ground = std::make_shared<const InsertGround>(groundOf(m_open->document.scene()));
    } else {
        m_preview = std::make_unique<Preview>();
    }
    layOut();

    m_delay.setSingleShot(true);
    m_delay.setInterval(patience);
    connect(&m_delay, &QTimer::timeout, this, &BuilderDialog::post);
    connect(m_builders, &QComboBox::currentIndexChanged, this, &BuilderDialog::showParameters);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
            &BuilderDialog::restoreDefaults);

    m_builders->setCurrentIndex(std::max(m_builders->findData(builder), 0));
    showParameters();
    if (m_open && parent) // beside the design, not on it
        move(parent->geometry().right() - width() - margin, parent->geometry().top() + 3 * margin);
}

BuilderDialog::~BuilderDialog()
{
    if (m_preview)
        delete m_preview->view; // before the document that it shows
}

void BuilderDialog::layOut()
{
    m_builders->setObjectName(QStringLiteral("builder"));
    m_builders->setAccessibleName(tr("Design"));
    m_help->setWordWrap(true);
    m_help->setForegroundRole(QPalette::PlaceholderText);
    m_figures->setObjectName(QStringLiteral("counts"));
    m_figures->setWordWrap(true);
    m_figures->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_figures->setMinimumHeight(4 * fontMetrics().lineSpacing()); // does not jump as it fills
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_buttons->button(QDialogButtonBox::Ok)->setText(m_open ? tr("Insert") : tr("Build"));
    QPushButton* defaults = m_buttons->button(QDialogButtonBox::RestoreDefaults);
    defaults->setText(tr("Defaults"));
    defaults->setToolTip(tr("Sets every parameter to what it was at first."));

    auto* form = new QVBoxLayout;
    form->addWidget(m_builders);
    form->addWidget(m_help);
    form->addWidget(m_scroll, 1);
    if (m_open)
        form->addWidget(placeBox());
    form->addWidget(m_figures);
    form->addWidget(m_buttons);
    auto* layout = new QHBoxLayout(this);
    layout->addLayout(form);
    if (m_preview) {
        m_preview->view->setMinimumWidth(320);
        layout->insertWidget(0, m_preview->view, 1);
        resize(formWidth + 520, 620);
    } else {
        resize(formWidth, 660);
    }
}

QGroupBox* BuilderDialog::placeBox()
{
    m_at = new QComboBox;
    m_at->setObjectName(QStringLiteral("at"));
    m_at->addItems({tr("Where the builder has it"), tr("Beside what is there"),
                    tr("In the middle of the view"), tr("Moved by")}); // in the order of PlaceAt
    m_at->setToolTip(tr("Builders put their designs over the origin, at the height that they fly "
                        "or hang at. Afterwards G moves what was inserted."));
    auto* place = new QHBoxLayout;
    for (int axis = 0; axis < 3; ++axis) {
        auto* field = m_place[std::size_t(axis)] = new QLineEdit(QStringLiteral("0"));
        field->setObjectName(QStringLiteral("place %1").arg(QChar('x' + axis)));
        field->setAccessibleName(tr("Moved by, %1").arg(QChar('x' + axis)));
        place->addWidget(new QLabel(QChar('x' + axis)));
        place->addWidget(field);
        connect(field, &QLineEdit::textEdited, this, &BuilderDialog::buildSoon);
    }
    place->addWidget(new QLabel(QStringLiteral("m")));

    m_surroundings = new QCheckBox(tr("Its ground, wind and settings"));
    m_surroundings->setObjectName(QStringLiteral("surroundings"));
    m_surroundings->setToolTip(tr("A second wind adds to the first. On at first where the design "
                                  "has neither ground nor wind."));
    m_surroundings->setChecked(!hasSurroundings(m_ground->scene));
    m_instruments = new QCheckBox(tr("Its controls and probes"));
    m_instruments->setObjectName(QStringLiteral("instruments"));
    m_instruments->setChecked(true);
    m_instruments->setToolTip(tr("Keys that steer it and what is measured of it."));
    m_show = new QCheckBox(tr("Show in the view"));
    m_show->setObjectName(QStringLiteral("show"));
    m_show->setChecked(true);
    m_show->setToolTip(tr("The design shows what will be inserted while this dialog is open."));

    auto* box = new QGroupBox(tr("Place"));
    auto* layout = new QVBoxLayout(box);
    layout->setSpacing(4);
    layout->addWidget(m_at);
    layout->addLayout(place);
    layout->addWidget(m_surroundings);
    layout->addWidget(m_instruments);
    layout->addWidget(m_show);
    m_at->setCurrentIndex(m_ground->box.isEmpty() ? int(PlaceAt::Origin) : int(PlaceAt::Beside));
    showPlace();
    connect(m_at, &QComboBox::currentIndexChanged, this, &BuilderDialog::showPlace);
    connect(m_at, &QComboBox::currentIndexChanged, this, &BuilderDialog::buildSoon);
    for (QCheckBox* choice : {m_surroundings, m_instruments, m_show})
        connect(choice, &QCheckBox::toggled, this, &BuilderDialog::buildSoon);
    return box;
}

void BuilderDialog::showPlace()
{
    for (QLineEdit* field : m_place)
        field->setEnabled(PlaceAt(m_at->currentIndex()) == PlaceAt::Shift);
}

const Builder& BuilderDialog::chosen() const
{
    return allBuilders()[std::size_t(m_builders->currentIndex())];
}

void BuilderDialog::showParameters()
{
    const Builder& builder = chosen();
    m_isNew = true;
    m_help->setText(text(builder.help));
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    m_form = new ParameterForm(builder.parameters);
    layout->addWidget(m_form);
    connect(m_form, &ParameterForm::changed, this, &BuilderDialog::buildSoon);
    m_table = nullptr;
    if (builder.table) {
        m_table = new QPlainTextEdit;
        m_table->setObjectName(text(builder.table->key));
        m_table->setAccessibleName(choiceLabel(builder.table->key));
        m_table->setTabChangesFocus(true);
        m_table->setPlaceholderText(tr("Empty: by the numbers above. Or paste from a spreadsheet."));
        m_table->setToolTip(text(builder.table->help));
        m_table->setFixedHeight(5 * fontMetrics().lineSpacing());
        auto* label = new QLabel(tr("%1 (%2)").arg(choiceLabel(builder.table->key),
                                                   text(builder.table->unit)));
        label->setBuddy(m_table);
        layout->addWidget(label);
        layout->addWidget(m_table);
        connect(m_table, &QPlainTextEdit::textChanged, this, &BuilderDialog::buildSoon);
    }
    layout->addStretch(1);
    m_scroll->setWidget(page); // the page before it is deleted
    m_scroll->setMinimumWidth(page->minimumSizeHint().width() + 20);
    post();
}

void BuilderDialog::restoreDefaults()
{
    m_form->restoreDefaults();
    if (m_table)
        m_table->clear();
    post();
}

void BuilderDialog::buildSoon()
{
    m_outcome.reset();
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(false);
    m_delay.start();
}

std::optional<BuildJob> BuilderDialog::job()
{
    BuildJob job;
    job.builder = &chosen();
    if (const QString refusal = m_form->refusal(); !refusal.isEmpty()) {
        refuse(refusal);
        return std::nullopt;
    }
    job.parameters = m_form->values();
    if (m_table) {
        Result<NumberRows> table =
            tableFromText(*job.builder->table, m_table->toPlainText().toStdString());
        if (!table) {
            refuse(QString::fromStdString(table.message()));
            return std::nullopt;
        }
        setTable(job.parameters, *job.builder->table, *table);
    }
    if (!m_open)
        return job;
    job.ground = m_ground;
    job.nextId = m_open->document.scene().nextId;
    job.wish = {std::string(job.builder->label), PlaceAt(m_at->currentIndex()), m_open->focus,
                m_surroundings->isChecked(), m_instruments->isChecked()};
    if (job.wish.at == PlaceAt::Shift)
        for (int axis = 0; axis < 3; ++axis) {
            bool isNumber = false;
            const QString typed = m_place[std::size_t(axis)]->text();
            job.wish.place[axis] = QLocale::c().toDouble(typed, &isNumber);
            if (!isNumber) {
                refuse(tr("%1 must be a number of metres, not \"%2\".")
                           .arg(QChar('x' + axis))
                           .arg(typed));
                return std::nullopt;
            }
        }
    return job;
}

void BuilderDialog::post()
{
    m_delay.stop();
    m_outcome.reset();
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(false);
    const int number = ++m_number; // what is being built is not wanted any more
    if (std::optional<BuildJob> wanted = job()) {
        wanted->number = number;
        m_worker.post(std::move(*wanted));
    }
}

void BuilderDialog::collect()
{
    auto outcome = m_worker.take();
    if (!outcome || outcome->number != m_number || m_delay.isActive())
        return; // of values that have changed since
    if (!outcome->refusal.empty())
        return refuse(QString::fromStdString(outcome->refusal));
    m_outcome = std::move(outcome);
    QStringList lines{textOf(m_outcome->figures)};
    if (m_outcome->insertion.substeps > 0)
        lines << tr("Raises the substeps of the scene to %1.").arg(m_outcome->insertion.substeps);
    if (m_outcome->figures.particles > mostShown)
        lines << tr("Too large to be shown while you type.");
    m_figures->setText(lines.join(QChar('\n')));
    preview();
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(true);
}

void BuilderDialog::refuse(const QString& why)
{
    takeBack();
    m_figures->setText(why);
}

void BuilderDialog::preview()
{
    takeBack();
    if (m_outcome->figures.particles > mostShown)
        return;
    if (m_preview) {
        m_preview->document.replace(m_outcome->scene);
    } else if (m_show->isChecked()) {
        m_gesture = m_open->document.beginGesture();
        m_open->document.drag(m_outcome->insertion.edit, m_gesture);
        if (m_isNew)
            emit shown();
        m_isNew = false;
    }
}

void BuilderDialog::takeBack()
{
    if (m_preview && (!m_outcome || m_outcome->figures.particles > mostShown))
        m_preview->document.replace(Scene{});
    if (m_gesture == 0)
        return;
    m_open->document.cancel(m_gesture);
    m_gesture = 0;
    m_open->selection.set(m_selected);
}

void BuilderDialog::accept()
{
    if (!m_outcome)
        return;
    takeBack();
    if (m_open) {
        m_open->document.push(m_outcome->insertion.edit);
        m_open->selection.set(m_outcome->insertion.bodies);
    }
    QDialog::accept();
}

void BuilderDialog::reject()
{
    m_delay.stop();
    ++m_number; // what comes now is not wanted
    takeBack();
    QDialog::reject();
}

} // namespace ripstop
