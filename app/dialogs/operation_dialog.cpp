// Stages: outcomeOf() and weightOf() put an edit into words. A change of the form starts a short
// timer; preview() then takes the last preview back, applies the operation to the design, says
// what it does or why not, and tries it out. accept() does the same once more, as an ordinary edit,
// so that nothing depends on whether a preview stood there.
#include "dialogs/operation_dialog.h"

#include "dialogs/beside.h"
#include "document/document.h"
#include "document/selection.h"
#include "document/spoken.h"
#include "document/words.h"
#include "select/element_counts.h"
#include "shaping/movable.h"
#include "start/parameter_form.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int previewDelay = 150;           // ms after the last change
constexpr std::size_t mostSelected = 20000; // particles that are selected

// What the particles whose mass the edit sets weigh afterwards and before.
QString weightOf(const Scene& before, const Edit& edit)
{
    const Property* property = &propertyOf<&Particle::mass>();
    for (const Change& change : edit.changes) {
        const auto* values = std::get_if<SetValues>(&change);
        if (!values || values->property != property)
            continue;
        double now = 0.0, then = 0.0; // kg
        for (std::size_t i = 0; i < values->targets.size(); ++i) {
            now += std::get<double>(values->values[values->values.size() == 1 ? 0 : i]);
            then += std::get<double>(property->get(*find(before, values->targets[i])));
        }
        return OperationDialog::tr("They weigh %1, before %2.")
            .arg(spokenText(now, "kg"), spokenText(then, "kg"));
    }
    return {};
}

// "Adds 5 particles, 10 links. Removes 1 link."
QString outcomeOf(const Scene& before, const Edit& edit)
{
    const EditCounts counts = editCountsOf(edit);
    QStringList said;
    if (const QString added = countsOf(counts.added); !added.isEmpty())
        said << OperationDialog::tr("Adds %1.").arg(added);
    if (const QString removed = countsOf(counts.removed); !removed.isEmpty())
        said << OperationDialog::tr("Removes %1.").arg(removed);
    std::size_t most = 0;
    for (const Change& change : edit.changes)
        if (const auto* values = std::get_if<SetValues>(&change))
            if (values->property->kind == Kind::Particle)
                most = std::max(most, values->targets.size());
    if (most > 0)
        said << OperationDialog::tr("Changes %1.").arg(counted(Kind::Particle, qsizetype(most)));
    if (const QString weight = weightOf(before, edit);
        edit.changes.size() == 1 && !weight.isEmpty()) // nothing but masses
        said << weight;
    return said.join(QChar(' '));
}

} // namespace

OperationDialog::OperationDialog(const Operation& operation, Document& document,
                                 Selection& selection, QWidget* parent)
    : QDialog(parent)
    , m_operation(operation)
    , m_document(document)
    , m_selection(selection)
    , m_ids(selection.ids())
    , m_form(new ParameterForm(operation.parameters))
    , m_preview(new QCheckBox(tr("Show in the view")))
    , m_outcome(new QLabel)
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel))
{
    setWindowTitle(translated(operation.label));
    layOut();
    m_pause.setSingleShot(true);
    m_pause.setInterval(previewDelay);
    connect(&m_pause, &QTimer::timeout, this, &OperationDialog::preview);
    connect(m_preview, &QCheckBox::toggled, this, &OperationDialog::preview);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    preview();
    adjustSize();
    moveBesideDesign(*this, parent);
}

void OperationDialog::layOut()
{
    auto* help = new QLabel(translated(m_operation.help));
    help->setWordWrap(true);
    help->setForegroundRole(QPalette::PlaceholderText);
    connect(m_form, &ParameterForm::changed, this, &OperationDialog::soon);
    // a large design takes too long to be shown at each key
    m_preview->setChecked(particlesOf(m_document.scene(), m_ids).size() <= mostSelected);
    m_preview->setToolTip(tr("The design shows the outcome while this dialog is open."));
    m_outcome->setTextFormat(Qt::PlainText);
    m_outcome->setObjectName(QStringLiteral("outcome"));
    m_outcome->setWordWrap(true);
    m_outcome->setMinimumHeight(3 * fontMetrics().lineSpacing()); // for a long sentence
    m_outcome->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_buttons->button(QDialogButtonBox::Ok)->setText(translated(m_operation.label));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(help);
    layout->addWidget(m_form);
    layout->addWidget(m_preview);
    layout->addWidget(m_outcome);
    layout->addWidget(m_buttons);
    setMinimumWidth(380);
}

void OperationDialog::soon() { m_pause.start(); }

Result<Shaped> OperationDialog::shaped() const
{
    if (const QString refusal = m_form->refusal(); !refusal.isEmpty())
        return Failure(Message::verbatim(refusal.toStdString()));
    return m_operation.apply(m_document.scene(), m_ids, m_form->values());
}

void OperationDialog::takeBack()
{
    m_document.takeBack();
    m_selection.set(m_ids); // what the preview removed has left the selection
}

void OperationDialog::say(const QString& words, bool isRefusal)
{
    m_outcome->setText(words);
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(!isRefusal);
}

void OperationDialog::preview()
{
    m_pause.stop();
    takeBack();
    Result<Shaped> outcome = shaped();
    if (!outcome)
        return say(translated(outcome.message()), true);
    say(outcomeOf(m_document.scene(), outcome->edit), false);
    if (!m_preview->isChecked() || outcome->edit.changes.empty())
        return;
    m_document.tryOut(std::move(outcome->edit));
}

void OperationDialog::accept()
{
    m_pause.stop();
    takeBack();
    Result<Shaped> outcome = shaped();
    if (!outcome)
        return say(translated(outcome.message()), true);
    m_document.push(std::move(outcome->edit));
    if (outcome->selected)
        m_selection.set(std::move(*outcome->selected));
    QDialog::accept();
}

void OperationDialog::reject()
{
    m_pause.stop();
    takeBack();
    QDialog::reject();
}

} // namespace ripstop
