// Stages: two functions make the tables of the pages from the cases and the references, each with
// a function that computes one row on another thread from a shared constant copy. The constructor
// puts them on two pages. Closing cancels both; goWhenIdle() deletes the dialog when neither runs
// any more, because a case cannot be interrupted and the window must not wait for it.
#include "dialogs/verification_dialog.h"

#include "dialogs/result_page.h"
#include "document/words.h"
#include "verify/case.h"
#include "verify/reference.h"
#include "verify/text.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QScreen>
#include <QTabWidget>
#include <QVBoxLayout>

#include <memory>

namespace ripstop {
namespace {

ResultTable tableOfCases()
{
    const auto tr = [](const char* text) { return VerificationDialog::tr(text); };
    ResultTable table;
    table.columns = {{tr("Result"), 120},         {tr("Id"), 60},         {tr("Case"), 430},
                     {tr("Expected"), 110, true}, {tr("Got"), 120, true}, {tr("Unit"), 60},
                     {tr("Tolerance"), 150},      {tr("Source"), 200}};
    const auto cases = std::make_shared<const std::vector<Case>>(allCases());
    for (const Case& one : *cases)
        table.rows.push_back(
            {translated(one.section),
             {QString(), text(one.id), text(one.title), text(digits(one.expected)), QString(),
              text(one.unit), text(textOf(one.tolerance, one.unit)), text(one.source)}});
    table.compute = [cases](int row) -> ResultTable::Outcome {
        const CaseResult result = run((*cases)[std::size_t(row)]);
        return {{{}, {}, {}, {}, text(digits(result.got))}, result.holds};
    };
    return table;
}

ResultTable tableOfReferences()
{
    const auto tr = [](const char* text) { return VerificationDialog::tr(text); };
    ResultTable table;
    table.isJudged = false;
    table.columns = {
        {tr("Comparison"), 430},  {tr("Published"), 130, true},       {tr("Got"), 90, true},
        {tr("Unit"), 50},         {tr("Got / published"), 120, true}, {tr("Published by"), 230},
        {tr("Simulated as"), 230}};
    const auto references = std::make_shared<const std::vector<Reference>>(allReferences());
    for (const Reference& one : *references) {
        table.rows.push_back({translated(one.section),
                              {text(one.title), text(publishedText(one.low, one.high)), QString(),
                               text(one.unit), QString(), text(one.source), text(one.note)}});
    }
    table.compute = [references](int row) -> ResultTable::Outcome {
        const ReferenceResult result = run((*references)[std::size_t(row)]);
        return {{{}, {}, text(gotText(result)), {}, text(ratioText(result))}, {}};
    };
    return table;
}

QWidget* page(const QString& intro, ResultPage* results)
{
    auto* label = new QLabel(intro);
    label->setWordWrap(true);
    auto* widget = new QWidget;
    auto* layout = new QVBoxLayout(widget);
    layout->addWidget(label);
    layout->addWidget(results);
    return widget;
}

} // namespace

VerificationDialog::VerificationDialog(QWidget* parent)
    : QDialog(parent)
    , m_cases(new ResultPage(tableOfCases))
    , m_references(new ResultPage(tableOfReferences))
{
    setWindowTitle(tr("Verification"));
    auto* pages = new QTabWidget;
    pages->addTab(
        page(tr("Cases whose answer is known from theory or a publication. The same engine that "
                "flies your scene must find it, within the tolerance that stands beside it."),
             m_cases),
        tr("Known &answers"));
    pages->addTab(
        page(tr("What designs of the builders do beside what was measured of real ones. Nothing is "
                "tuned: a ratio far from one says what the present laws cannot do."),
             m_references),
        tr("&Measured data"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(pages);
    layout->addWidget(buttons);
    connect(this, &QDialog::finished, this, [this] {
        m_isClosed = true;
        m_cases->cancel();
        m_references->cancel();
        goWhenIdle();
    });
    for (ResultPage* results : {m_cases, m_references})
        connect(results, &ResultPage::finished, this, &VerificationDialog::goWhenIdle);
    resize(QSize(1320, 760).boundedTo(screen()->availableSize() * 0.94));
}

void VerificationDialog::showEvent(QShowEvent* event)
{
    m_isClosed = false;
    QDialog::showEvent(event);
}

// A case that is under way cannot be interrupted, and the window must not wait for it.
void VerificationDialog::goWhenIdle()
{
    if (m_isClosed && !m_cases->isRunning() && !m_references->isRunning())
        deleteLater();
}

} // namespace ripstop
