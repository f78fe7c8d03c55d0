// refresh() reads sizes and units from the fields, the table from the text of the file and the fit
// from the model, and says at the first of them that fails why. draw() shows all points, the range
// and the line over it; a rectangle that is drawn over the plot becomes the range. save() asks for
// what an own material needs besides (own_material_dialog.h has the same rules).
#include "inspector/material_test_dialog.h"

#include "document/spoken.h"
#include "document/words.h"
#include "materials/own_materials.h"
#include "scene/typed_number.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <qcustomplot.h>

#include <cmath>

namespace ripstop {
namespace {

constexpr qint64 longestFile = 20 * 1024 * 1024; // bytes

std::string textOf(const QLineEdit* field) { return field->text().trimmed().toStdString(); }

// A positive length, or what is wrong with what was typed.
Result<double> lengthIn(const QLineEdit* field, const Message& what)
{
    const Typed typed = typedValue(textOf(field), "m");
    if (!typed.number)
        return Failure("%1: it %2.", what, typed.complaint);
    if (!(typed.number->number > 0.0))
        return Failure("%1: it must be above 0.", what);
    return typed.number->number;
}

} // namespace

MaterialTestDialog::MaterialTestDialog(QWidget* parent)
    : QDialog(parent)
    , m_choose(new QPushButton(tr("Choose a &file…")))
    , m_specimen(new QComboBox)
    , m_direction(new QComboBox)
    , m_length(new QLineEdit("200 mm"))
    , m_width(new QLineEdit("50 mm"))
    , m_forceUnit(new QLineEdit)
    , m_elongationUnit(new QLineEdit)
    , m_from(new QLineEdit)
    , m_to(new QLineEdit)
    , m_result(new QLabel)
    , m_label(new QLineEdit)
    , m_save(new QPushButton(tr("&Save as own material")))
    , m_plot(new QCustomPlot)
{
    setWindowTitle(tr("Material from a test"));
    setAttribute(Qt::WA_DeleteOnClose);
    makePlot();
    layOut();
    connect(m_choose, &QPushButton::clicked, this, &MaterialTestDialog::choose);
    connect(m_specimen, &QComboBox::currentIndexChanged, this, &MaterialTestDialog::refresh);
    connect(m_direction, &QComboBox::currentIndexChanged, this, &MaterialTestDialog::refresh);
    for (QLineEdit* field :
         {m_length, m_width, m_forceUnit, m_elongationUnit, m_from, m_to, m_label})
        connect(field, &QLineEdit::textChanged, this, &MaterialTestDialog::refresh);
    connect(m_save, &QPushButton::clicked, this, &MaterialTestDialog::save);
    refresh();
    resize(900, 560);
}

void MaterialTestDialog::makePlot()
{
    const QColor ink = palette().color(QPalette::Text);
    m_plot->setBackground(palette().brush(QPalette::Base));
    for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis}) {
        axis->setBasePen(ink);
        axis->setTickPen(ink);
        axis->setSubTickPen(ink);
        axis->setTickLabelColor(ink);
        axis->setLabelColor(ink);
        QColor faint = ink;
        faint.setAlpha(40);
        axis->grid()->setPen(faint);
        axis->grid()->setZeroLinePen(faint);
    }
    const QColor accent = palette().color(QPalette::Highlight);
    QCPGraph* points = m_plot->addGraph();
    points->setLineStyle(QCPGraph::lsNone);
    points->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, ink, 5));
    QCPGraph* used = m_plot->addGraph();
    used->setLineStyle(QCPGraph::lsNone);
    used->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, accent, 6));
    m_plot->addGraph()->setPen(QPen(accent, 2));
    m_plot->setMinimumSize(320, 280);
    m_plot->setSelectionRectMode(QCP::srmCustom);
    connect(m_plot->selectionRect(), &QCPSelectionRect::accepted, this, [this](const QRect& rect) {
        const double a = m_plot->xAxis->pixelToCoord(rect.left());
        const double b = m_plot->xAxis->pixelToCoord(rect.right());
        const QString unit(QString::fromUtf8(elongationUnit(m_size.specimen).data()));
        m_from->setText(spokenNumber(std::min(a, b)) + ' ' + unit);
        m_to->setText(spokenNumber(std::max(a, b)) + ' ' + unit);
    });
}

QFormLayout* MaterialTestDialog::fields()
{
    m_specimen->addItems({tr("Strip of cloth, pulled"), tr("Line, pulled"),
                          tr("Rod on two supports, pressed in the middle")}); // as Specimen
    m_direction->addItems({tr("Along the warp"), tr("Across the warp")});     // as PullDirection
    m_forceUnit->setPlaceholderText(tr("of the header, as in “force (N)”"));
    m_elongationUnit->setPlaceholderText(tr("of the header, as in “elongation (mm)”"));
    m_from->setPlaceholderText(tr("where 10 % of the largest force is"));
    m_to->setPlaceholderText(tr("where 60 % of the largest force is"));
    const QString range = tr("Or draw a rectangle over the plot.");
    m_from->setToolTip(range);
    m_to->setToolTip(range);
    m_label->setPlaceholderText(tr("name of the material"));
    auto* form = new QFormLayout;
    form->addRow(m_choose);
    form->addRow(tr("S&pecimen"), m_specimen);
    form->addRow(tr("&Pulled"), m_direction);
    form->addRow(tr("&Length"), m_length);
    form->addRow(tr("&Width"), m_width);
    form->addRow(tr("&Unit of force"), m_forceUnit);
    form->addRow(tr("Unit of &elongation"), m_elongationUnit);
    form->addRow(tr("F&it from elongation"), m_from);
    form->addRow(tr("&to elongation"), m_to);
    form->addRow(tr("&Called"), m_label);
    return form;
}

void MaterialTestDialog::layOut()
{
    m_result->setTextFormat(Qt::PlainText);
    m_result->setWordWrap(true);
    m_result->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_result->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_result->setMinimumHeight(110);
    auto* left = new QVBoxLayout;
    left->addLayout(fields());
    left->addWidget(m_result, 1);
    auto* top = new QHBoxLayout;
    top->addLayout(left, 2);
    top->addWidget(m_plot, 3);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(m_save, QDialogButtonBox::ActionRole);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(top, 1);
    layout->addWidget(buttons);
}

void MaterialTestDialog::choose()
{
    const QString file = QFileDialog::getOpenFileName(
        this, tr("Test of a material"), m_file, tr("Tables (*.csv *.txt *.tsv);;All files (*)"));
    if (!file.isEmpty())
        read(file);
}

void MaterialTestDialog::read(const QString& file)
{
    m_file = file;
    m_text.clear();
    QFile in(file);
    if (!in.open(QIODevice::ReadOnly) || in.size() > longestFile) {
        m_file.clear();
        refresh();
        return fail(tr("%1 cannot be read, or is larger than 20 MB.").arg(file));
    }
    m_text = in.readAll().toStdString();
    m_choose->setText(QFileInfo(file).fileName());
    if (m_label->text().isEmpty())
        m_label->setText(QFileInfo(file).completeBaseName());
    refresh();
}

Result<SpecimenSize> MaterialTestDialog::size() const
{
    SpecimenSize size;
    size.specimen = Specimen(m_specimen->currentIndex());
    size.direction = PullDirection(m_direction->currentIndex());
    const Result<double> length = lengthIn(m_length, Message("Length"));
    if (!length)
        return length.failure();
    size.length = *length;
    if (size.specimen != Specimen::Strip)
        return size;
    const Result<double> width = lengthIn(m_width, Message("Width"));
    if (!width)
        return width.failure();
    size.width = *width;
    return size;
}

// Fields that are empty leave it to the fit; one alone goes from or to the end of the test.
Result<std::optional<ElongationRange>> MaterialTestDialog::range() const
{
    if (textOf(m_from).empty() && textOf(m_to).empty())
        return std::optional<ElongationRange>();
    ElongationRange range{m_points.front().elongation, m_points.back().elongation};
    const std::string_view unit = m_specimen->currentIndex() == int(Specimen::Rod) ? "m" : "";
    for (const auto& [field, end] : {std::pair(m_from, &range.from), std::pair(m_to, &range.to)}) {
        if (textOf(field).empty())
            continue;
        const Typed typed = typedValue(textOf(field), unit);
        if (!typed.number)
            return Failure("The range: it %1.", typed.complaint);
        *end = typed.number->number;
    }
    return std::optional(range);
}

void MaterialTestDialog::fail(const QString& why)
{
    m_fit.reset();
    m_result->setText(why);
    m_save->setEnabled(false);
}

void MaterialTestDialog::refresh()
{
    m_points.clear();
    const auto specimen = Specimen(m_specimen->currentIndex());
    m_width->setEnabled(specimen == Specimen::Strip);
    m_direction->setEnabled(specimen == Specimen::Strip);
    const auto failed = [this](const Message& why) {
        fail(translated(why));
        draw(m_size);
    };
    const Result<SpecimenSize> size = this->size();
    if (!size)
        return failed(size.message());
    m_size = *size;
    if (m_file.isEmpty()) {
        fail(tr("A table with a column for the force and one for the elongation, and a header: "
                "force (N),elongation (mm)"));
        return draw(m_size);
    }
    auto test = readMaterialTest(m_text, QFileInfo(m_file).fileName().toStdString(), m_size,
                                 {textOf(m_forceUnit), textOf(m_elongationUnit)});
    if (!test)
        return failed(test.message());
    m_points = std::move(test->points);
    const auto range = this->range();
    if (!range)
        return failed(range.message());
    const Result<MaterialFit> fit = fitMaterialTest(m_points, m_size, *range);
    if (!fit)
        return failed(fit.message());
    m_fit = *fit;
    tell(*fit, m_size);
    if (const auto skipped = skippedText(*test))
        m_result->setText(m_result->text() + QChar('\n') + translated(*skipped));
    draw(m_size);
}

void MaterialTestDialog::tell(const MaterialFit& fit, const SpecimenSize& size)
{
    QStringList lines{translated(summaryOf(fit, size)),
                      tr("Residual %1 N").arg(spokenNumber(fit.residual))};
    const QString at = spokenNumber(shownElongation(fit.highestAt, size.specimen)) + ' '
                       + QString::fromUtf8(elongationUnit(size.specimen).data());
    lines << (fit.broke ? tr("Broke at %1 N and %2").arg(spokenNumber(fit.highest), at)
                        : tr("Did not break: largest force %1 N, at %2")
                              .arg(spokenNumber(fit.highest), at));
    m_result->setText(lines.join('\n'));
    m_save->setEnabled(!materialNameOf(textOf(m_label)).empty());
}

void MaterialTestDialog::draw(const SpecimenSize& size)
{
    QVector<double> x, force, usedX, usedForce, lineX, line;
    for (const TestPoint& point : m_points) {
        const double shown = shownElongation(point.elongation, size.specimen);
        const bool used = m_fit && point.elongation >= m_fit->range.from
                          && point.elongation <= m_fit->range.to
                          && point.elongation <= m_fit->highestAt;
        (used ? usedX : x) << shown;
        (used ? usedForce : force) << point.force;
    }
    if (m_fit)
        for (const double end : {-m_fit->offset / m_fit->slope, m_fit->highestAt}) {
            lineX << shownElongation(end, size.specimen);
            line << m_fit->offset + m_fit->slope * end;
        }
    m_plot->graph(0)->setData(x, force);
    m_plot->graph(1)->setData(usedX, usedForce);
    m_plot->graph(2)->setData(lineX, line);
    m_plot->xAxis->setLabel(size.specimen == Specimen::Rod ? tr("Deflection (mm)")
                                                           : tr("Strain (%)"));
    m_plot->yAxis->setLabel(tr("Force (N)"));
    m_plot->rescaleAxes();
    for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis}) {
        axis->scaleRange(1.06);
        axis->setVisible(!m_points.empty()); // without points there is nothing to read off
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void MaterialTestDialog::save()
{
    if (!m_fit)
        return;
    const std::string label = textOf(m_label);
    Preset preset = presetOf(*m_fit, m_points, m_size, materialNameOf(label),
                             "Test " + QFileInfo(m_file).fileName().toStdString());
    preset.label = label;
    const auto failure = saveOwnMaterial(ownMaterialsFile(), preset, SameName::Refused);
    if (failure)
        return m_result->setText(translated(failure->message));
    emit saved();
    accept();
}

} // namespace ripstop
