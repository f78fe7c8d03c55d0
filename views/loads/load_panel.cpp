// A frame starts a timer unless it runs; refresh() shows the newest when it runs out, or says why
// there is nothing to show.
#include "loads/load_panel.h"

#include "document/document.h"
#include "document/player.h"
#include "document/selection.h"
#include "loads/load_list.h"
#include "run/has_margins.h"

#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QStackedLayout>
#include <QVBoxLayout>

#include <algorithm>

namespace ripstop {
namespace {

constexpr int pause = 200; // ms, between two looks; more cannot be read

} // namespace

LoadPanel::LoadPanel(Document& document, Selection& selection, Player& player, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_selection(selection)
    , m_player(player)
    , m_pages(new QStackedLayout(this))
    , m_empty(new QLabel)
    , m_materials(new QPushButton(tr("Select the materials")))
    , m_now(new LoadList(tr("Worst places now")))
    , m_ofRun(new LoadList(tr("Worst places of the run")))
{
    m_pages->addWidget(emptyPage());
    m_pages->addWidget(listPage());
    m_delay.setSingleShot(true);
    m_delay.setInterval(pause);
    connect(&m_delay, &QTimer::timeout, this, &LoadPanel::refresh);
    const auto soon = [this] {
        if (!m_delay.isActive())
            m_delay.start();
    };
    connect(&player, &Player::frameReady, this, soon);
    connect(&player, &Player::stateChanged, this, soon);
    connect(&document, &Document::replaced, this, soon);
    connect(m_materials, &QPushButton::clicked, this, &LoadPanel::selectMaterials);
    for (LoadList* list : {m_now, m_ofRun})
        connect(list, &LoadList::chosen, this, &LoadPanel::choose);
    refresh();
}

QWidget* LoadPanel::emptyPage()
{
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_empty->setWordWrap(true);
    m_materials->setToolTip(tr("So that the inspector shows their strengths."));
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->addStretch();
    layout->addWidget(m_empty);
    layout->addWidget(m_materials, 0, Qt::AlignHCenter);
    layout->addStretch();
    return page;
}

QWidget* LoadPanel::listPage()
{
    const QString help = tr("Click a place to select it and bring it to the middle of the view.");
    auto* page = new QSplitter;
    for (LoadList* list : {m_now, m_ofRun}) {
        list->setToolTip(help);
        page->addWidget(list);
    }
    m_now->hideColumn(LoadList::Time);
    page->setChildrenCollapsible(false);
    return page;
}

QString LoadPanel::said() const
{
    return m_pages->currentIndex() == 0 ? m_empty->text() : QString();
}

void LoadPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    refresh();
}

void LoadPanel::choose(quint32 element)
{
    m_selection.set({Id{element}});
    emit chosen(element);
}

void LoadPanel::refresh()
{
    const Frame* frame = m_player.frame().get();
    const bool isListed =
        frame && !(frame->worstNow.all().empty() && frame->worstOfRun.all().empty());
    m_pages->setCurrentIndex(isListed ? 1 : 0);
    if (!isListed)
        return tellWhyNone(frame);
    if (!isVisible())
        return;
    m_now->showPlaces(m_document.scene(), frame->worstNow.all());
    m_ofRun->showPlaces(m_document.scene(), frame->worstOfRun.all());
}

void LoadPanel::tellWhyNone(const Frame* frame)
{
    const bool hasMaterial = std::ranges::any_of(m_document.scene().items, [](const Entry& entry) {
        return std::holds_alternative<Material>(entry.item);
    });
    const bool isBare = frame && !hasMargins(*frame);
    m_materials->setVisible(isBare && hasMaterial);
    m_empty->setText(
        !isBare ? tr("Nothing bears a load yet: run the scene.")
        : hasMaterial
            ? tr("No material here has a strength, so that nothing can be said to be near to "
                 "breaking. Take a material of the library, or type a line strength, a warp and "
                 "weft strength, or a breaking moment in the inspector.")
            : tr("There is no material here whose strength could be compared with a load. Insert a "
                 "material of the library and give it to lines, cloth or spars."));
}

void LoadPanel::selectMaterials()
{
    std::vector<Id> materials;
    for (const Entry& entry : m_document.scene().items)
        if (std::holds_alternative<Material>(entry.item))
            materials.push_back(entry.id);
    m_selection.set(materials);
}

} // namespace ripstop
