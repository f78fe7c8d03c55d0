// Stages: the constructor decides which of the three uses it has: a part of the open design, an
// insertion into it, or a new design with a view of its own. Each change goes through buildSoon(),
// which waits for a pause in typing, and post(), which reads the form and gives the thread a
// numbered job; collect() takes the outcome on the thread of the window and drops those of an
// older number. preview() shows it in the open design, beside its history, unless a run is shown or
// it has too many particles; takeBack() undoes that before the next preview, before it is accepted
// and when it is dismissed.
#include "dialogs/builder_dialog.h"

#include "author/chosen_materials.h"
#include "dialogs/beside.h"
#include "dialogs/figures_text.h"
#include "dialogs/place_form.h"
#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "document/words.h"
#include "icons/complaint.h"
#include "start/parameter_form.h"
#include "viewport/viewport.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr int patience = 120;            // ms after the last change
constexpr std::size_t mostShown = 20000; // particles that are shown while one types
constexpr int formWidth = 440;           // pixels

// What was changed in the form of one design and is the same number, or the same choices, of
// another one.
Parameters takenOver(const Builder& from, const Parameters& values, const Builder& to)
{
    Parameters taken;
    for (const Parameter& parameter : to.parameters) {
        const auto like = std::ranges::find(from.parameters, parameter.key, &Parameter::key);
        if (like == from.parameters.end() || like->unit != parameter.unit
            || like->whole != parameter.whole
            || !std::ranges::equal(like->choices, parameter.choices))
            continue;
        const std::string key(parameter.key);
        const double value = values.at(key);
        if (value != like->atFirst() && value >= parameter.low && value <= parameter.high)
            taken[key] = value;
    }
    return taken;
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
    , m_show(new QCheckBox(tr("Show in the view")))
    , m_figures(new QLabel)
    , m_lost(new Complaint)
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel
                                     | QDialogButtonBox::RestoreDefaults))
    , m_ideal(m_buttons->addButton(tr("Ideal materials"), QDialogButtonBox::ResetRole))
    , m_worker(outcomeOf, [this] {
        QMetaObject::invokeMethod(this, &BuilderDialog::collect, Qt::QueuedConnection);
    })
{
    for (const Builder& one : allBuilders())
        m_builders->addItem(translated(one.label), text(one.name));
    const Part* part = m_open ? findItem<Part>(m_open->document.scene(), m_open->part) : nullptr;
    if (part) {
        setWindowTitle(tr("Parameters of %1").arg(QString::fromStdString(part->name)));
        m_scene = std::make_shared<const Scene>(m_open->document.scene());
    } else if (m_open) {
        setWindowTitle(tr("Insert"));
        m_ground = std::make_shared<const InsertGround>(groundOf(m_open->document.scene()));
    } else {
        setWindowTitle(tr("New from builder"));
        m_preview = std::make_unique<Preview>();
    }
    if (m_open)
        m_selected = m_open->selection.ids();
    layOut();

    m_delay.setSingleShot(true);
    m_delay.setInterval(patience);
    connect(&m_delay, &QTimer::timeout, this, &BuilderDialog::post);
    connect(m_builders, &QComboBox::currentIndexChanged, this, &BuilderDialog::showParameters);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
            &BuilderDialog::restoreDefaults);
    connect(m_ideal, &QPushButton::clicked, this, [this] {
        m_form->setValues(unsaid(chosen()));
        post();
    });

    m_builders->setCurrentIndex(std::max(m_builders->findData(builder), 0));
    m_builders->setEnabled(!part);
    showParameters();
    if (part)
        showValuesOf(*part);
    if (m_open)
        moveBesideDesign(*this, parent);
}

BuilderDialog::~BuilderDialog()
{
    if (m_preview)
        delete m_preview->view; // it has to go before the document that it shows
}

void BuilderDialog::layOut()
{
    m_builders->setObjectName(QStringLiteral("builder"));
    m_builders->setAccessibleName(tr("Design"));
    m_help->setWordWrap(true);
    m_help->setForegroundRole(QPalette::PlaceholderText);
    m_figures->setTextFormat(Qt::PlainText);
    m_figures->setObjectName(QStringLiteral("counts"));
    m_figures->setWordWrap(true);
    m_figures->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_lost->setObjectName(QStringLiteral("lost"));
    m_figures->setMinimumHeight(4 * fontMetrics().lineSpacing()); // does not jump as it fills
    m_show->setObjectName(QStringLiteral("show"));
    const bool showsRun = m_open && m_open->showsRun;
    m_show->setEnabled(!showsRun);
    m_show->setChecked(!showsRun);
    if (showsRun)
        m_show->setText(tr("Show in the view (not in a run)"));
    m_show->setToolTip(
        !showsRun ? tr("The design shows the outcome while this dialog is open.")
        : m_scene ? tr("The view shows a run, which stays as it is until the part is changed; the "
                       "view goes back to the start then. To see it before, go there first.")
                  : tr("The view shows a run, which goes on as it is. What is inserted comes into "
                       "it; to see it before, go back to the start first."));
    connect(m_show, &QCheckBox::toggled, this, &BuilderDialog::post);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    QPushButton* build = m_buttons->button(QDialogButtonBox::Ok);
    build->setText(m_scene ? tr("Change") : m_ground ? tr("Insert") : tr("Build"));
    QPushButton* defaults = m_buttons->button(QDialogButtonBox::RestoreDefaults);
    // Enter must not undo what was typed: Qt would take the first of the row while there is
    // nothing to build yet.
    defaults->setAutoDefault(false);
    m_ideal->setAutoDefault(false);
    build->setDefault(true);
    defaults->setText(tr("Defaults"));
    defaults->setToolTip(tr("Sets every parameter to what it was at first."));
    m_ideal->setObjectName(QStringLiteral("ideal"));
    m_ideal->setToolTip(tr("Sets every parameter to what goes with ideal cloth, lines and spars: "
                           "deltas, gliders and parachutes are those of the papers then."));

    auto* form = new QVBoxLayout;
    form->addWidget(m_builders);
    form->addWidget(m_help);
    form->addWidget(m_scroll, 1);
    if (m_ground) {
        m_place = new PlaceForm(*m_ground, m_open->focus);
        form->addWidget(m_place);
        connect(m_place, &PlaceForm::changed, this, [this] {
            m_isNew = true; // it comes elsewhere
            buildSoon();
        });
    }
    form->addWidget(m_show);
    m_show->setVisible(m_open.has_value()); // a design of its own has a view of its own
    form->addWidget(m_figures);
    form->addWidget(m_lost);
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

const Builder& BuilderDialog::chosen() const
{
    return allBuilders()[std::size_t(m_builders->currentIndex())];
}

void BuilderDialog::showParameters()
{
    const Builder& builder = chosen();
    m_isNew = true;
    m_help->setText(translated(builder.help));
    m_ideal->setVisible(std::ranges::any_of(
        builder.parameters, [](const Parameter& parameter) { return bool(parameter.offered); }));
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    keepTyped();
    m_form = new ParameterForm(builder.parameters);
    fillForm();
    layout->addWidget(m_form);
    connect(m_form, &ParameterForm::changed, this, [this] {
        followCloth();
        buildSoon();
    });
    m_table = nullptr;
    if (builder.table) {
        m_table = new QPlainTextEdit;
        m_table->setObjectName(text(builder.table->key));
        m_table->setAccessibleName(choiceLabel(builder.table->key));
        m_table->setTabChangesFocus(true);
        m_table->setPlaceholderText(
            tr("Empty: by the numbers above. Or paste from a spreadsheet."));
        m_table->setToolTip(translated(builder.table->help));
        m_table->setFixedHeight(5 * fontMetrics().lineSpacing());
        m_table->setPlainText(m_typed[&builder].table);
        auto* label = new QLabel(
            tr("%1 (%2)").arg(choiceLabel(builder.table->key), text(builder.table->unit)));
        label->setBuddy(m_table);
        layout->addWidget(label);
        layout->addWidget(m_table);
        connect(m_table, &QPlainTextEdit::textChanged, this, &BuilderDialog::buildSoon);
    }
    layout->addStretch(1);
    m_scroll->setWidget(page); // setWidget() deletes the page before
    m_scroll->setMinimumWidth(page->minimumSizeHint().width() + 20);
    m_shown = &builder;
    post();
}

void BuilderDialog::keepTyped()
{
    if (m_shown)
        m_typed[m_shown] = {m_form->values(), m_form->said(),
                            m_table ? m_table->toPlainText() : QString()};
}

// What was typed for this design before, or else what of the one before it means the same here.
void BuilderDialog::fillForm()
{
    const Builder& builder = chosen();
    const auto before = m_typed.find(&builder);
    if (before == m_typed.end()) {
        if (m_shown)
            m_form->say(takenOver(*m_shown, m_typed.at(m_shown).values, builder));
        return;
    }
    const auto isUnread = [](const auto& value) { return !std::isfinite(value.second); };
    Typed typed = before->second;
    std::erase_if(typed.values, isUnread);
    std::erase_if(typed.said, isUnread);
    m_form->setValues(typed.values);
    m_form->say(typed.said);
}

bool BuilderDialog::clothIsIdeal() const
{
    const Parameters values = m_form->values();
    const auto cloth = values.find("cloth");
    return cloth != values.end() && cloth->second == 0.0;
}

// Whoever makes the cloth of a new design ideal wants that of the papers, and whoever makes it real
// again what is offered beside real cloth, as on the command line. What they have set themselves
// stays. A part that is built again keeps what it has.
void BuilderDialog::followCloth()
{
    if (m_scene || clothIsIdeal() == m_clothIsIdeal)
        return;
    m_clothIsIdeal = clothIsIdeal();
    const Parameters said = m_form->said();
    Parameters all = newDesign(chosen(), said);
    all.merge(unsaid(chosen()));
    std::erase_if(all, [&](const auto& value) { return said.contains(value.first); });
    m_form->setValues(all);
}

// Fills the form with what the part was built with.
void BuilderDialog::showValuesOf(const Part& part)
{
    m_form->setValues(chosenNow(*m_scene, m_open->part).parameters);
    if (m_table) {
        QStringList rows;
        for (const std::vector<double>& row : tableOf(part.parameters, *chosen().table)) {
            QStringList cells;
            for (const double cell : row)
                cells << QString::number(cell, 'g', QLocale::FloatingPointShortest);
            rows << cells.join(QChar('\t'));
        }
        m_table->setPlainText(rows.join(QChar('\n')));
    }
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
            refuse(translated(table.message()));
            return std::nullopt;
        }
        setTable(job.parameters, *job.builder->table, *table);
    }
    if (m_open)
        job.nextId = m_open->document.scene().nextId;
    if (m_scene) {
        job.scene = m_scene;
        job.part = m_open->part;
    }
    if (m_ground) {
        if (const QString refusal = m_place->refusal(); !refusal.isEmpty()) {
            refuse(refusal);
            return std::nullopt;
        }
        job.ground = m_ground;
        job.wish = m_place->wish();
        job.wish.label = job.builder->label;
    }
    return job;
}

void BuilderDialog::post()
{
    m_delay.stop();
    m_outcome.reset();
    m_clothIsIdeal = clothIsIdeal();
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(false);
    const int number = ++m_number; // outcomes of older numbers are dropped
    if (std::optional<BuildJob> wanted = job()) {
        wanted->number = number;
        m_worker.post(std::move(*wanted));
    }
}

void BuilderDialog::collect()
{
    auto outcome = m_worker.take();
    if (!outcome || outcome->number != m_number || m_delay.isActive())
        return; // it was built of values that have changed since
    if (!outcome->refusal.empty())
        return refuse(translated(outcome->refusal));
    m_outcome = std::move(outcome);
    QStringList lines{textOf(m_outcome->figures)};
    if (m_outcome->substeps > 0)
        lines << tr("Raises the substeps of the scene to %1.").arg(m_outcome->substeps);
    if (const QString staying = textOf(m_outcome->staying); !staying.isEmpty())
        lines << staying;
    if (m_outcome->painted > 0)
        lines << tr("Strength, stiffness and grain that were painted stay at their places: on %1 "
                    "of the links and panels.")
                     .arg(m_outcome->painted);
    if (m_outcome->figures.particles > mostShown)
        lines << tr("Too large to be shown while you type.");
    m_figures->setText(lines.join(QChar('\n')));
    m_lost->tell(textOf(m_outcome->lost, m_outcome->letGo));
    preview();
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(true);
}

void BuilderDialog::refuse(const QString& why)
{
    takeBack();
    m_figures->setText(why);
    m_lost->tell({});
}

void BuilderDialog::preview()
{
    takeBack();
    if (m_outcome->figures.particles > mostShown)
        return;
    if (m_preview) {
        m_preview->document.replace(m_outcome->scene);
    } else if (m_show->isChecked()) {
        m_open->document.tryOut(m_outcome->edit);
        if (m_isNew)
            emit shown(m_outcome->bodies);
        m_isNew = false;
    }
}

void BuilderDialog::takeBack()
{
    if (m_preview && (!m_outcome || m_outcome->figures.particles > mostShown))
        m_preview->document.replace(Scene{});
    if (m_open && m_open->document.takeBack())
        m_open->selection.set(m_selected);
}

void BuilderDialog::accept()
{
    if (!m_outcome)
        return;
    takeBack();
    if (m_open) {
        emit agreed();
        m_open->document.push(m_outcome->edit);
        m_open->selection.set(m_outcome->bodies);
        if (m_isNew)
            emit shown(m_outcome->bodies);
    }
    QDialog::accept();
}

void BuilderDialog::reject()
{
    m_delay.stop();
    ++m_number; // an outcome that still comes is dropped
    takeBack();
    QDialog::reject();
}

} // namespace ripstop
