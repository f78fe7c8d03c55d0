// showFindings() makes a row of each finding: sign, sentence, and a button where there is a repair.
// fitRows() gives rows the height of their sentences, again whenever the width changes. outdate()
// disables the buttons after an edit; repair() pushes a copy of the edit, as the list is made anew
// by that.
#include "problems/stability_list.h"

#include "document/document.h"
#include "document/plain_text.h"
#include "document/selection.h"
#include "document/words.h"
#include "icons/tinted.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>

#include <algorithm>

namespace ripstop {
namespace {

enum Column { Subject, Told, Repair };

constexpr int padding = 6; // px

} // namespace

StabilityList::StabilityList(Document& document, Selection& selection, QWidget* parent)
    : QTreeWidget(parent)
    , m_document(document)
    , m_selection(selection)
{
    setColumnCount(3);
    setHeaderHidden(true);
    setRootIsDecorated(false);
    setFrameShape(NoFrame);
    setWordWrap(true);
    setSelectionMode(SingleSelection);
    setAccessibleName(tr("Stability"));
    setToolTip(tr("How near the design is to what its solver can follow. Click a row to select "
                  "what it is about."));
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(Subject, QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(Told, QHeaderView::Stretch);
    header()->setSectionResizeMode(Repair, QHeaderView::ResizeToContents);
    const auto select = [this](QTreeWidgetItem* item) {
        const Finding& finding = m_findings[std::size_t(indexOfTopLevelItem(item))];
        if (!finding.culprits.empty())
            m_selection.set(finding.culprits);
    };
    connect(this, &QTreeWidget::itemClicked, this, select);
    connect(this, &QTreeWidget::itemActivated, this, select);
    connect(&document, &Document::changed, this, &StabilityList::outdate);
    connect(&document, &Document::replaced, this, &StabilityList::outdate);
}

void StabilityList::showFindings(const std::vector<Finding>& findings)
{
    m_findings = findings;
    clear();
    for (std::size_t row = 0; row < findings.size(); ++row) {
        const Finding& finding = findings[row];
        const bool isPoor = finding.severity == Severity::Warning;
        auto* item =
            new QTreeWidgetItem(this, {translated(finding.subject), translated(finding.message)});
        item->setIcon(Subject, isPoor ? tinted(QStringLiteral("warning"), QColor(0xd9, 0x8e, 0x1f))
                                      : tinted(QStringLiteral("ok"), QColor(0x3c, 0x9a, 0x5f)));
        item->setData(Subject, Qt::AccessibleTextRole,
                      (isPoor ? tr("Poor: %1") : tr("Good: %1")).arg(item->text(Subject)));
        item->setToolTip(Told, shownAsIs(item->text(Told)));
        if (!finding.repair)
            continue;
        auto* button = new QPushButton(inMenu(translated(finding.repair->label)));
        button->setToolTip(tr("Repairs it as one step that can be undone."));
        connect(button, &QPushButton::clicked, this, [this, row] { repair(row); });
        auto* place = new QWidget; // a row may be higher than its button
        auto* inside = new QHBoxLayout(place);
        inside->setContentsMargins(0, 0, 0, 0);
        inside->addWidget(button);
        setItemWidget(item, Repair, place);
    }
    fitRows();
}

int StabilityList::poor() const
{
    return int(std::ranges::count(m_findings, Severity::Warning, &Finding::severity));
}

bool StabilityList::tellsPoor(std::string_view sort) const
{
    return !sort.empty() && std::ranges::any_of(m_findings, [sort](const Finding& finding) {
        return finding.severity == Severity::Warning && finding.sort == sort;
    });
}

void StabilityList::resizeEvent(QResizeEvent* event)
{
    QTreeWidget::resizeEvent(event);
    fitRows();
}

// Rows are as high as their sentences need in the width that there is; a tree does not see to it.
void StabilityList::fitRows()
{
    const int width = columnWidth(Told) - 2 * padding;
    for (int row = 0; row < topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = topLevelItem(row);
        const QRect words = fontMetrics().boundingRect(
            QRect(0, 0, std::max(width, 1), QWIDGETSIZE_MAX), Qt::TextWordWrap, item->text(Told));
        item->setSizeHint(Told, QSize(0, words.height() + padding));
    }
}

void StabilityList::outdate()
{
    for (int row = 0; row < topLevelItemCount(); ++row)
        if (QWidget* place = itemWidget(topLevelItem(row), Repair))
            place->setEnabled(false);
}

void StabilityList::repair(std::size_t row)
{
    const Edit edit = *m_findings[row].repair; // the list is about to be made anew
    m_document.push(edit);
}

} // namespace ripstop
