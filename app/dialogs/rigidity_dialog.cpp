// Stages: look() takes the selection, or all parts when there is none, and lookAgain() computes
// modes and braces, for the design and not for a run. say(), fillModes() and fillBraces() put them
// into words and lists. showMode() starts a clock whose swing() shifts a copy of the frame of the
// design along the chosen mode, 0.12 of the size of what moves at most; still() shows the design
// again. An edit waits for a pause before it is looked at.
#include "dialogs/rigidity_dialog.h"

#include "dialogs/beside.h"
#include "document/document.h"
#include "document/selection.h"
#include "document/words.h"
#include "look/scene_frame.h"
#include "tools/transform_tool.h"
#include "viewport/viewport.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

constexpr int frameTime = 33;      // ms
constexpr int lookDelay = 200;     // ms after the last change of the design
constexpr double swingTime = 1.6;  // s, there and back
constexpr double swingSize = 0.12; // of the size of what moves
constexpr double moving = 0.05;    // of the largest displacement: what moves less stands still

QString number(Id id) { return QStringLiteral("#%1").arg(std::uint32_t(id)); }

std::vector<Id> movingIn(const Rigidity& rigidity, std::size_t mode)
{
    std::vector<Id> ids;
    for (std::size_t p = 0; p < rigidity.particles.size(); ++p)
        if (rigidity.modes[mode][p].norm() > moving)
            ids.push_back(rigidity.particles[p]);
    return ids;
}

double sizeOf(const Rigidity& rigidity)
{
    Eigen::AlignedBox3d box;
    for (const Vec3& place : rigidity.position)
        box.extend(place);
    return box.diagonal().norm();
}

} // namespace

RigidityDialog::RigidityDialog(Document& document, Selection& selection, Viewport& viewport,
                               QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_selection(selection)
    , m_viewport(viewport)
    , m_verdict(new QLabel)
    , m_sums(new QLabel)
    , m_modes(new QListWidget)
    , m_rods(new QTreeWidget)
    , m_advice(new QLabel)
    , m_animate(new QCheckBox(tr("&Move it in the view")))
    , m_select(new QPushButton(tr("&Select what moves")))
    , m_add(new QPushButton(tr("&Add these rods")))
{
    setWindowTitle(tr("Rigidity"));
    layOut();
    m_clock.setInterval(frameTime);
    connect(&m_clock, &QTimer::timeout, this, &RigidityDialog::swing);
    m_soon.setSingleShot(true);
    m_soon.setInterval(lookDelay);
    connect(&m_soon, &QTimer::timeout, this, &RigidityDialog::lookAgain);
    const auto soon = [this] {
        if (isVisible())
            m_soon.start();
    };
    connect(&m_document, &Document::changed, this, soon);
    connect(&m_document, &Document::replaced, this, &QWidget::hide);
    connect(m_modes, &QListWidget::currentRowChanged, this, &RigidityDialog::showMode);
    connect(m_animate, &QCheckBox::toggled, this, &RigidityDialog::showMode);
    connect(m_select, &QPushButton::clicked, this, &RigidityDialog::selectMoving);
    connect(m_add, &QPushButton::clicked, this, &RigidityDialog::addBraces);
}

void RigidityDialog::layOut()
{
    QFont large = font();
    large.setPointSizeF(1.15 * large.pointSizeF());
    large.setWeight(QFont::DemiBold);
    m_verdict->setTextFormat(Qt::PlainText);
    m_verdict->setFont(large);
    m_verdict->setWordWrap(true);
    for (QLabel* label : {m_sums, m_advice}) {
        label->setWordWrap(true);
        label->setForegroundRole(QPalette::PlaceholderText);
    }
    m_animate->setChecked(true);
    m_rods->setHeaderLabels({tr("From"), tr("To"), tr("Length (m)")});
    m_rods->setRootIsDecorated(false);
    m_rods->setAlternatingRowColors(true);
    m_add->setToolTip(tr("Each takes one way away; there is no smaller set. One step of undo."));

    auto* again = new QPushButton(tr("&Look at the selection"));
    again->setToolTip(tr("What is selected now, in place of what was."));
    connect(again, &QPushButton::clicked, this, &RigidityDialog::look);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(again, QDialogButtonBox::ActionRole);
    connect(buttons, &QDialogButtonBox::rejected, this, &QWidget::hide);
    for (QPushButton* button : {m_select, m_add, again})
        button->setAutoDefault(false);

    auto* onMode = new QHBoxLayout;
    onMode->addWidget(m_animate);
    onMode->addStretch(1);
    onMode->addWidget(m_select);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_verdict);
    layout->addWidget(m_sums);
    layout->addWidget(m_modes, 2);
    layout->addLayout(onMode);
    layout->addWidget(m_advice);
    layout->addWidget(m_rods, 2);
    layout->addWidget(m_add, 0, Qt::AlignRight);
    layout->addWidget(buttons);
    resize(400, 560);
    moveBesideDesign(*this, parentWidget());
}

void RigidityDialog::look()
{
    m_ids = m_selection.ids();
    if (m_ids.empty())
        forEachPart(m_document.scene(), [&](Id id, const Part&) { m_ids.push_back(id); });
    lookAgain();
}

void RigidityDialog::lookAgain()
{
    still();
    m_viewport.transformTool().goToDesign();
    m_rigidity.reset();
    m_braces.clear();
    Result<Rigidity> found = rigidityOf(m_document.scene(), m_ids);
    if (found) {
        m_rigidity = std::move(*found);
        m_braces = bracesFor(*m_rigidity);
        say();
    } else {
        m_verdict->setText(translated(found.message()));
        m_sums->clear();
    }
    fillModes();
    fillBraces();
    showMode();
}

void RigidityDialog::say()
{
    const int modes = this->modes();
    m_verdict->setText(modes == 0   ? tr("It is rigid.")
                       : modes == 1 ? tr("It gives way in 1 way.")
                                    : tr("It gives way in %1 ways.").arg(modes));
    const auto& r = *m_rigidity;
    QStringList sums{counted(Kind::Particle, qsizetype(r.particles.size())),
                     counted(Kind::Link, qsizetype(r.links.size()))};
    sums << tr("%1 of the links redundant").arg(r.redundant);
    sums << (r.rigidMotions == 0 ? tr("held by pins")
                                 : tr("%1 motions of the whole are free").arg(r.rigidMotions));
    m_sums->setText(sums.join(QStringLiteral(" · "))
                    + tr(".\nLinks count as if they resisted both ways, and small motions only."));
}

void RigidityDialog::fillModes()
{
    m_modes->clear();
    for (std::size_t m = 0; m_rigidity && m < m_rigidity->modes.size(); ++m) {
        const auto& mode = m_rigidity->modes[m];
        const auto most = std::ranges::max_element(
            mode, [](const Vec3& a, const Vec3& b) { return a.norm() < b.norm(); });
        const Id id = m_rigidity->particles[std::size_t(most - mode.begin())];
        m_modes->addItem(
            tr("%1. %2 moves most, %3 in all")
                .arg(m + 1)
                .arg(number(id))
                .arg(counted(Kind::Particle, qsizetype(movingIn(*m_rigidity, m).size()))));
    }
    m_modes->setCurrentRow(0);
}

void RigidityDialog::fillBraces()
{
    m_rods->clear();
    for (const Brace& brace : m_braces) {
        const auto from = std::size_t(brace.from);
        const auto to = std::size_t(brace.to);
        const double length = (m_rigidity->position[to] - m_rigidity->position[from]).norm();
        new QTreeWidgetItem(m_rods, {number(m_rigidity->particles[from]),
                                     number(m_rigidity->particles[to]), compactNumber(length)});
    }
    m_rods->header()->resizeSections(QHeaderView::ResizeToContents);
    const int left = modes() - int(m_braces.size());
    QString advice;
    if (modes() == 0)
        advice = m_rigidity ? tr("No rod is missing.") : QString();
    else if (left == 0)
        advice = tr("The fewest rods that stop them all:");
    else if (m_braces.empty())
        advice =
            tr("No rod between these particles can stop them: what is flat gives way across its "
               "plane. Draw, Rigidity particles puts something beside the plane.");
    else
        advice = tr("These rods stop %1 of them. The others are across the plane: Draw, Rigidity "
                    "particles puts something beside it.")
                     .arg(m_braces.size());
    m_advice->setText(advice);
    m_rods->setVisible(!m_braces.empty());
    m_add->setVisible(!m_braces.empty());
    m_modes->setVisible(modes() > 0);
    m_animate->setVisible(modes() > 0);
    m_select->setVisible(modes() > 0);
}

void RigidityDialog::showMode()
{
    still();
    if (!isVisible() || !m_rigidity || m_modes->currentRow() < 0 || !m_animate->isChecked())
        return;
    m_design = sceneFrame(m_document.scene());
    m_phase = 0.0;
    m_clock.start();
}

void RigidityDialog::swing()
{
    m_phase += 2.0 * std::numbers::pi * frameTime / (1000.0 * swingTime);
    const auto& mode = m_rigidity->modes[std::size_t(m_modes->currentRow())];
    const double reach = swingSize * sizeOf(*m_rigidity) * std::sin(m_phase);
    auto frame = std::make_shared<Frame>(*m_design);
    for (std::size_t i = 0; i < frame->layout->particleId.size(); ++i) {
        const Id id{frame->layout->particleId[i]};
        const auto at = std::ranges::lower_bound(m_rigidity->particles, id);
        if (at != m_rigidity->particles.end() && *at == id)
            frame->position[i] += reach * mode[std::size_t(at - m_rigidity->particles.begin())];
    }
    m_viewport.show(frame);
}

void RigidityDialog::still()
{
    if (!m_clock.isActive())
        return;
    m_clock.stop();
    m_viewport.show(m_design);
}

void RigidityDialog::selectMoving()
{
    if (m_rigidity && m_modes->currentRow() >= 0)
        m_selection.set(movingIn(*m_rigidity, std::size_t(m_modes->currentRow())));
}

void RigidityDialog::addBraces()
{
    Braced braced = withBraces(m_document.scene(), *m_rigidity, m_braces);
    m_document.push(std::move(braced.edit));
    m_selection.set(std::move(braced.rods));
    lookAgain();
}

void RigidityDialog::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    look();
}

void RigidityDialog::hideEvent(QHideEvent* event)
{
    still();
    m_soon.stop();
    QDialog::hideEvent(event);
}

} // namespace ripstop
