#include "dialogs/rescue_dialog.h"

#include "document/plain_text.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace ripstop {

RescueDialog::RescueDialog(const QList<Rescue>& found, QWidget* parent)
    : QDialog(parent)
    , m_found(found)
    , m_table(new QTreeWidget)
{
    setWindowTitle(tr("Unsaved work"));
    auto* what = new QLabel(tr("Ripstop ended before this was saved. Open it to go on where it "
                               "was; the file that it belongs to stays as it is until you save."));
    what->setWordWrap(true);
    m_table->setHeaderLabels({tr("Design"), tr("Kept"), tr("Later state of")});
    m_table->setRootIsDecorated(false);
    m_table->setAlternatingRowColors(true);

    auto* buttons = new QDialogButtonBox;
    m_open = buttons->addButton(tr("&Open"), QDialogButtonBox::AcceptRole);
    m_delete = buttons->addButton(tr("&Delete…"), QDialogButtonBox::DestructiveRole);
    buttons->addButton(tr("&Later"), QDialogButtonBox::RejectRole)
        ->setToolTip(tr("Ask again at the next start."));
    m_open->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_delete, &QPushButton::clicked, this, &RescueDialog::removeChosen);
    connect(m_table, &QTreeWidget::itemDoubleClicked, this, &QDialog::accept);
    connect(m_table, &QTreeWidget::itemSelectionChanged, this, &RescueDialog::keepCurrent);

    auto* layout = new QVBoxLayout(this);
    layout->addWidget(what);
    layout->addWidget(m_table);
    layout->addWidget(buttons);
    resize(680, 300);
    fill();
}

std::optional<Rescue> RescueDialog::chosen() const
{
    const int row = m_table->indexOfTopLevelItem(m_table->currentItem());
    return row < 0 ? std::nullopt : std::optional(m_found[row]);
}

void RescueDialog::fill()
{
    m_table->clear();
    for (const Rescue& rescue : m_found) {
        QString file =
            rescue.file.isEmpty() ? tr("(never saved)") : QDir::toNativeSeparators(rescue.file);
        if (rescue.isOlderThanFile())
            file = tr("%1, which is newer").arg(file);
        auto* row = new QTreeWidgetItem(
            m_table,
            {rescue.title, QLocale().toString(rescue.written, QLocale::ShortFormat), file});
        row->setToolTip(2, shownAsIs(file));
    }
    m_table->header()->resizeSections(QHeaderView::ResizeToContents);
    m_table->setCurrentItem(m_table->topLevelItem(0));
    keepCurrent();
}

void RescueDialog::keepCurrent()
{
    m_open->setEnabled(chosen().has_value());
    m_delete->setEnabled(chosen().has_value());
}

void RescueDialog::removeChosen()
{
    const auto rescue = chosen();
    if (!rescue
        || QMessageBox::question(
               this, tr("Delete unsaved work"),
               shownAsIs(tr("%1 of %2 is then gone for good.")
                             .arg(rescue->title,
                                  QLocale().toString(rescue->written, QLocale::ShortFormat))),
               QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Cancel)
               != QMessageBox::Discard)
        return;
    rescue->place.remove();
    m_found.removeAt(m_table->indexOfTopLevelItem(m_table->currentItem()));
    if (m_found.isEmpty())
        return reject();
    fill();
}

} // namespace ripstop
