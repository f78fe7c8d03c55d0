// Stages: layOut() makes the two choices and says what will change, counted from the frame:
// particles that move, those that tears have added, links and panels that are gone, pins and
// colliders that hands have moved. explain() says what a pair of choices means for the next run.
// accept() posts the job to the thread; take() pushes the edit that comes back, unless the dialog
// was dismissed meanwhile.
#include "dialogs/pose_dialog.h"

#include "document/document.h"
#include "document/player.h"
#include "document/words.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace ripstop {

PoseDialog::PoseDialog(Document& document, Player& player, QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_player(player)
    , m_frame(player.frame())
    , m_lengths(new QComboBox)
    , m_motion(new QComboBox)
    , m_choice(new QLabel)
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel))
    , m_worker([](const Job& job) { return posed(job.scene, *job.frame, job.options).edit; },
               [this] { QMetaObject::invokeMethod(this, &PoseDialog::take); })
{
    setWindowTitle(tr("Adopt pose"));
    layOut();
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_lengths, &QComboBox::currentIndexChanged, this, &PoseDialog::explain);
    connect(m_motion, &QComboBox::currentIndexChanged, this, &PoseDialog::explain);
    explain();
}

void PoseDialog::layOut()
{
    auto* help =
        new QLabel(tr("What the run has come to after %1 s becomes the design. Undo brings "
                      "the old one back.")
                       .arg(QLocale().toString(m_frame->time, 'f', 2)));
    help->setWordWrap(true);
    help->setForegroundRole(QPalette::PlaceholderText);
    m_lengths->setObjectName(QStringLiteral("lengths"));
    m_lengths->addItems({tr("Keep them: links stay as stretched as they are"),
                         tr("Rebind them: links have no strain in the new design")});
    m_motion->setObjectName(QStringLiteral("motion"));
    m_motion->addItems({tr("At rest"), tr("As fast as they are now")});
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("Rest &lengths"), m_lengths);
    form->addRow(tr("Particles &start"), m_motion);
    auto* changes = new QLabel(outcome());
    changes->setObjectName(QStringLiteral("outcome"));
    changes->setWordWrap(true);
    m_choice->setWordWrap(true);
    m_choice->setForegroundRole(QPalette::PlaceholderText);
    m_choice->setMinimumHeight(2 * fontMetrics().lineSpacing());
    m_choice->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("&Adopt pose"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(help);
    layout->addLayout(form);
    layout->addWidget(m_choice);
    layout->addWidget(changes);
    layout->addWidget(m_buttons);
    setMinimumWidth(460);
}

QString PoseDialog::outcome() const
{
    const Layout& layout = *m_frame->layout;
    const auto count = [](const std::vector<std::uint8_t>& marks) {
        return qsizetype(std::count(marks.begin(), marks.end(), 1));
    };
    QStringList said{
        tr("Moves %1.").arg(counted(Kind::Particle, qsizetype(layout.particleId.size())))};
    if (const std::size_t parted = partedParticles(layout))
        said << tr("Adds %1 where the mesh has parted.")
                    .arg(counted(Kind::Particle, qsizetype(parted)));
    QStringList gone;
    if (const qsizetype links = count(m_frame->torn))
        gone << counted(Kind::Link, links);
    if (const qsizetype panels = count(m_frame->gone))
        gone << counted(Kind::Panel, panels);
    if (!gone.isEmpty())
        said << tr("Removes %1 that are torn or cut.").arg(gone.join(QStringLiteral(", ")));
    if (!m_frame->handPins.empty())
        said << tr("Pins %1 that a hand has pinned.")
                    .arg(counted(Kind::Particle, qsizetype(m_frame->handPins.size())));
    if (!m_frame->carries.empty())
        said << tr("Leaves %1 where a hand has put them.")
                    .arg(counted(Kind::Collider, qsizetype(m_frame->carries.size())));
    return said.join(QChar(' '));
}

void PoseDialog::explain()
{
    const bool keeps = m_lengths->currentIndex() == 0;
    const bool rests = m_motion->currentIndex() == 0;
    m_choice->setText(
        keeps && rests ? tr("What hangs still now hangs still in the new design: its links carry "
                            "the same loads.")
        : keeps        ? tr("The next run goes on as this one would.")
        : rests ? tr("The shape is the new unloaded shape: under load it gives way a little more.")
                : tr("The next run starts with this motion in links that are free of load."));
}

void PoseDialog::accept()
{
    if (m_works)
        return;
    m_works = true;
    for (QWidget* widget : {static_cast<QWidget*>(m_lengths), static_cast<QWidget*>(m_motion),
                            static_cast<QWidget*>(m_buttons->button(QDialogButtonBox::Ok))})
        widget->setEnabled(false);
    m_choice->setText(tr("Making the design…"));
    m_worker.post({m_document.scene(),
                   m_frame,
                   {m_lengths->currentIndex() == 1, m_motion->currentIndex() == 1}});
}

void PoseDialog::take()
{
    const auto edit = m_worker.take();
    if (!edit || !m_works)
        return;
    m_works = false;
    m_player.reset(); // the run is over, since what it came to is now the design
    m_document.push(*edit);
    QDialog::accept();
}

void PoseDialog::reject()
{
    m_works = false;
    QDialog::reject();
}

} // namespace ripstop
