#include "start/builder_dialog.h"

#include "document/words.h"
#include "start/parameter_field.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr int patience = 120; // ms after the last change

QString text(std::string_view words)
{
    return QString::fromUtf8(words.data(), qsizetype(words.size()));
}

QString summary(const Scene& scene)
{
    qsizetype particles = 0;
    qsizetype links = 0;
    qsizetype panels = 0;
    double mass = 0.0; // kg
    forEachPart(scene, [&](Id, const Part& part) {
        particles += qsizetype(part.particles.size());
        links += qsizetype(part.links.size());
        panels += qsizetype(part.panels.size());
        for (const Particle& row : part.particles)
            mass += row.mass;
    });
    QStringList facts{counted(Kind::Particle, particles), counted(Kind::Link, links)};
    if (panels > 0)
        facts << counted(Kind::Panel, panels);
    facts << BuilderDialog::tr("%1 kg").arg(QString::number(mass, 'g', 4));
    return facts.join(QStringLiteral(", "));
}

} // namespace

BuilderDialog::BuilderDialog(const QString& builder, QWidget* parent)
    : QDialog(parent)
    , m_builders(new QComboBox)
    , m_help(new QLabel)
    , m_form(new QScrollArea)
    , m_counts(new QLabel)
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel
                                     | QDialogButtonBox::RestoreDefaults))
    , m_worker(
          [](const Job& job) {
              return Outcome{build(*job.builder, job.parameters), job.number};
          },
          [this] {
              QMetaObject::invokeMethod(this, &BuilderDialog::collect, Qt::QueuedConnection);
          })
{
    setWindowTitle(tr("Build a design"));
    for (const Builder& one : allBuilders())
        m_builders->addItem(text(one.label), text(one.name));
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
}

void BuilderDialog::layOut()
{
    m_builders->setObjectName(QStringLiteral("builder"));
    m_builders->setAccessibleName(tr("Design"));
    m_help->setWordWrap(true);
    m_help->setForegroundRole(QPalette::PlaceholderText);
    m_counts->setObjectName(QStringLiteral("counts"));
    m_counts->setWordWrap(true);
    m_counts->setMinimumHeight(2 * fontMetrics().lineSpacing()); // for a long sentence
    m_form->setWidgetResizable(true);
    m_form->setFrameShape(QFrame::NoFrame);
    m_form->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    QPushButton* build = m_buttons->button(QDialogButtonBox::Ok);
    build->setText(tr("Build"));
    QPushButton* defaults = m_buttons->button(QDialogButtonBox::RestoreDefaults);
    defaults->setText(tr("Defaults"));
    defaults->setToolTip(tr("Sets every parameter to what it was at first."));

    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_builders);
    layout->addWidget(m_help);
    layout->addWidget(m_form, 1);
    layout->addWidget(m_counts);
    layout->addWidget(m_buttons);
    resize(440, 560);
}

QString BuilderDialog::builder() const { return m_builders->currentData().toString(); }

const Builder& BuilderDialog::chosen() const
{
    return allBuilders()[std::size_t(m_builders->currentIndex())];
}

void BuilderDialog::showParameters()
{
    m_help->setText(text(chosen().help));
    m_fields.clear();
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins(0, 4, 8, 4);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    for (const Parameter& parameter : chosen().parameters) {
        auto* field = new ParameterField(parameter);
        field->setObjectName(text(parameter.key));
        auto* label = new QLabel(ParameterField::label(parameter));
        label->setToolTip(field->toolTip());
        label->setBuddy(field);
        form->addRow(label, field);
        m_fields.push_back(field);
        connect(field, &ParameterField::changed, this, &BuilderDialog::buildSoon);
    }
    m_form->setWidget(page); // the page before it is deleted
    post();
}

void BuilderDialog::restoreDefaults()
{
    for (ParameterField* field : m_fields)
        field->setValue(field->parameter().initial);
    post();
}

void BuilderDialog::buildSoon()
{
    m_built = false;
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(false);
    m_delay.start();
}

void BuilderDialog::post()
{
    m_delay.stop();
    m_built = false;
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(false);
    Parameters parameters;
    for (const ParameterField* field : m_fields) {
        if (std::isnan(field->value())) {
            ++m_number; // what is being built is not wanted any more
            m_refusal = tr("%1 is not a number.").arg(ParameterField::label(field->parameter()));
            showResult();
            return;
        }
        parameters[std::string(field->parameter().key)] = field->value();
    }
    m_worker.post({&chosen(), std::move(parameters), ++m_number});
}

void BuilderDialog::collect()
{
    const auto outcome = m_worker.take();
    if (!outcome || outcome->number != m_number || m_delay.isActive())
        return; // of values that have changed since
    m_built = bool(outcome->scene);
    if (m_built)
        m_scene = *outcome->scene;
    else
        m_refusal = QString::fromStdString(outcome->scene.message());
    showResult();
}

void BuilderDialog::showResult()
{
    m_counts->setText(m_built ? summary(m_scene) : m_refusal);
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(m_built);
}

} // namespace ripstop
