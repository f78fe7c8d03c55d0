// The list is made anew by look(): after a choice, and some moments after the last edit. The ghost
// is the frame of the other scene as it was designed; it goes with the dialog.
#include "dialogs/design_difference_dialog.h"

#include "dialogs/beside.h"
#include "document/document.h"
#include "document/recordings.h"
#include "document/selection.h"
#include "document/words.h"
#include "io/design_file.h"
#include "look/scene_frame.h"
#include "viewport/viewport.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int compareDelay = 300; // ms after the last change of the design

} // namespace

DesignDifferenceDialog::DesignDifferenceDialog(Document& document, Selection& selection,
                                               Viewport& viewport, QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_selection(selection)
    , m_viewport(viewport)
    , m_with(new QLabel)
    , m_verdict(new QLabel)
    , m_list(new QListWidget)
    , m_ghost(new QCheckBox(tr("Show the other one as a &ghost")))
    , m_saved(new QPushButton(tr("As sa&ved")))
    , m_select(new QPushButton(tr("&Select all that differs")))
{
    setWindowTitle(tr("Compare designs"));
    layOut();
    m_soon.setSingleShot(true);
    m_soon.setInterval(compareDelay);
    connect(&m_soon, &QTimer::timeout, this, &DesignDifferenceDialog::look);
    connect(&m_document, &Document::changed, this, [this] {
        if (isVisible())
            m_soon.start();
    });
    connect(&m_document, &Document::replaced, this, &QWidget::hide);
    connect(m_list, &QListWidget::currentRowChanged, this, &DesignDifferenceDialog::select);
    connect(m_ghost, &QCheckBox::toggled, this, &DesignDifferenceDialog::showGhost);
    connect(m_saved, &QPushButton::clicked, this, &DesignDifferenceDialog::compareWithSaved);
    connect(m_select, &QPushButton::clicked, this, &DesignDifferenceDialog::selectAll);
}

void DesignDifferenceDialog::layOut()
{
    QFont large = font();
    large.setPointSizeF(1.15 * large.pointSizeF());
    large.setWeight(QFont::DemiBold);
    m_verdict->setTextFormat(Qt::PlainText);
    m_verdict->setFont(large);
    m_verdict->setWordWrap(true);
    m_with->setTextFormat(Qt::PlainText);
    m_with->setWordWrap(true);
    m_with->setForegroundRole(QPalette::PlaceholderText);
    m_list->setWordWrap(true);
    m_list->setAlternatingRowColors(true);
    m_list->setToolTip(tr("A row selects in the view what it tells of."));
    m_ghost->setChecked(true);
    m_saved->setToolTip(tr("The design as its file has it: what you have changed since."));

    auto* choose = new QPushButton(tr("&Other design…"));
    choose->setToolTip(tr("A scene, or a recording with the design that it began with."));
    connect(choose, &QPushButton::clicked, this, &DesignDifferenceDialog::choose);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(choose, QDialogButtonBox::ActionRole);
    buttons->addButton(m_saved, QDialogButtonBox::ActionRole);
    connect(buttons, &QDialogButtonBox::rejected, this, &QWidget::hide);
    for (QPushButton* button : {m_select, m_saved, choose})
        button->setAutoDefault(false);

    auto* inView = new QHBoxLayout;
    inView->addWidget(m_ghost);
    inView->addStretch(1);
    inView->addWidget(m_select);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_verdict);
    layout->addWidget(m_with);
    layout->addWidget(m_list, 1);
    layout->addLayout(inView);
    layout->addWidget(buttons);
    resize(460, 480);
    moveBesideDesign(*this, parentWidget());
}

QString DesignDifferenceDialog::verdict() const { return m_verdict->text(); }

bool DesignDifferenceDialog::compareWith(const QString& file)
{
    Result<Scene> scene = readDesign(file.toStdString());
    if (!scene) {
        m_file.clear();
        m_differences.clear();
        m_list->clear();
        m_verdict->setText(tr("There is nothing to compare with."));
        m_with->setText(translated(scene.message()));
        m_viewport.showGhosts({});
        return false;
    }
    m_file = file;
    m_other = std::move(*scene);
    look();
    return true;
}

void DesignDifferenceDialog::compareWithSaved()
{
    if (!m_document.file().isEmpty())
        (void)compareWith(m_document.file());
}

void DesignDifferenceDialog::choose()
{
    const QString folder = QFileInfo(m_file.isEmpty() ? m_document.file() : m_file).path();
    const QString file = QFileDialog::getOpenFileName(
        this, tr("Compare with"), folder,
        tr("Scenes and recordings (*.ripstop.json *.ripstop-run);;All files (*)"));
    if (!file.isEmpty())
        (void)compareWith(file);
}

void DesignDifferenceDialog::look()
{
    m_differences.clear();
    if (!m_file.isEmpty())
        m_differences = differencesOf(m_other, m_document.scene());
    say();
    showGhost();
}

void DesignDifferenceDialog::say()
{
    const QSignalBlocker blocker(m_list); // filling it selects nothing
    m_list->clear();
    for (const SceneDifference& difference : m_differences)
        m_list->addItem(translated(difference.text));
    const int count = m_list->count();
    if (m_file.isEmpty())
        m_verdict->setText(tr("Choose a design to compare with."));
    else
        m_verdict->setText(count == 0   ? tr("The two say the same.")
                           : count == 1 ? tr("They differ in 1 thing.")
                                        : tr("They differ in %1 things.").arg(count));
    const bool saved = m_file == m_document.file();
    const QString size = translated(sizeOf(m_other));
    const QString from = saved ? tr("From the design as saved: %1").arg(size)
                               : tr("From %1: %2").arg(QFileInfo(m_file).fileName(), size);
    const QString to = tr("To the open design: %1").arg(translated(sizeOf(m_document.scene())));
    m_with->setText(m_file.isEmpty() ? tr("The open design has no file yet.")
                                     : from + QStringLiteral("\n") + to);
    m_saved->setEnabled(!m_document.file().isEmpty() && !saved);
    m_ghost->setEnabled(count > 0);
    m_select->setEnabled(count > 0);
}

void DesignDifferenceDialog::showGhost()
{
    // two that are the same would only flicker in each other
    const bool shown = isVisible() && m_ghost->isChecked() && !m_differences.empty();
    m_viewport.showGhosts(shown ? std::vector{GhostFrame{sceneFrame(m_other), {}}}
                                : std::vector<GhostFrame>());
}

void DesignDifferenceDialog::select(int row)
{
    if (row >= 0 && row < int(m_differences.size()))
        m_selection.set(m_differences[std::size_t(row)].inSecond);
}

void DesignDifferenceDialog::selectAll()
{
    std::vector<Id> ids;
    for (const SceneDifference& difference : m_differences)
        ids.insert(ids.end(), difference.inSecond.begin(), difference.inSecond.end());
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    m_selection.set(std::move(ids));
}

void DesignDifferenceDialog::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    if (m_file.isEmpty())
        compareWithSaved();
    look();
}

void DesignDifferenceDialog::hideEvent(QHideEvent* event)
{
    m_soon.stop();
    m_viewport.showGhosts({});
    QDialog::hideEvent(event);
}

} // namespace ripstop
