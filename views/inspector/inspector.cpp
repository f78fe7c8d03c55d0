// The constructor lays out the head (icon, title, totals, targets), the banner of picking, the tabs
// of kinds, the search and the pages.
//
// showSelection() follows the selection: it makes tabs of the kinds there are and shows one of
// them, by showKind(), which sets the subject and makes the form when it is first needed. What was
// being typed is committed before that, as it belongs to the things that were selected until then.
//
// refresh() shows values again after each edit. While a field waits for something to be picked,
// takePick() takes the next selection as its value and brings back the one of before.
#include "inspector/inspector.h"

#include "document/document.h"
#include "document/selection.h"
#include "document/words.h"
#include "icons/icon.h"
#include "inspector/preset_chooser.h"
#include "inspector/property_form.h"
#include "inspector/target_rows.h"
#include "inspector/totals.h"

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

#include <utility>

namespace ripstop {
namespace {

constexpr int iconSide = 20; // px

std::vector<Id> idsOf(const std::vector<Census::Found>& found)
{
    std::vector<Id> ids;
    ids.reserve(found.size());
    for (const Census::Found& one : found)
        ids.push_back(one.id);
    return ids;
}

} // namespace

Inspector::Inspector(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_selection(selection)
    , m_sliders(document)
    , m_subject(document, m_sliders.directions())
    , m_usage(document)
    , m_icon(new QLabel)
    , m_title(new QLabel)
    , m_totals(new QLabel)
    , m_targets(new TargetRows(document))
    , m_banner(new QLabel)
    , m_kinds(new QTabBar)
    , m_search(new QLineEdit)
    , m_noMatch(new QLabel)
    , m_pages(new QStackedWidget)
{
    for (QLabel* label : {m_title, m_totals, m_noMatch}) // they say names, or what is searched for
        label->setTextFormat(Qt::PlainText);
    QFont bold = m_title->font();
    bold.setWeight(QFont::DemiBold);
    m_title->setFont(bold);
    m_title->setWordWrap(true);
    m_totals->setForegroundRole(QPalette::PlaceholderText);
    m_totals->setWordWrap(true);
    m_banner->setWordWrap(true);
    m_banner->setAutoFillBackground(true);
    m_banner->setBackgroundRole(QPalette::Highlight);
    m_banner->setForegroundRole(QPalette::HighlightedText);
    m_banner->setMargin(6);
    m_banner->hide();
    m_kinds->setExpanding(false);
    m_kinds->setDrawBase(false);
    m_kinds->hide();

    m_search->setPlaceholderText(tr("Find a property"));
    m_search->setClearButtonEnabled(true);
    m_search->setAccessibleName(tr("Find a property"));
    m_search->setToolTip(tr("Shows the rows whose name or help has these words."));
    connect(m_search, &QLineEdit::textChanged, this, &Inspector::filter);
    m_noMatch->setForegroundRole(QPalette::PlaceholderText);
    m_noMatch->setMargin(8);
    m_noMatch->hide();
    auto* search = new QHBoxLayout;
    search->setContentsMargins(8, 2, 8, 2);
    search->addWidget(m_search);

    auto* title = new QHBoxLayout;
    title->setContentsMargins(8, 8, 8, 0);
    // each new picture would have the window laid out anew otherwise
    m_icon->setFixedSize(iconSide, iconSide);
    title->addWidget(m_icon, 0, Qt::AlignTop);
    title->addWidget(m_title, 1);
    auto* facts = new QHBoxLayout;
    facts->setContentsMargins(8, 0, 8, 2);
    facts->addWidget(m_totals);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3);
    layout->addLayout(title);
    layout->addLayout(facts);
    layout->addWidget(m_targets);
    layout->addWidget(m_banner);
    layout->addWidget(m_kinds);
    layout->addLayout(search);
    layout->addWidget(m_noMatch);
    layout->addWidget(m_pages, 1);

    connect(&selection, &Selection::changed, this, &Inspector::showSelection);
    connect(&document, &Document::changed, this, &Inspector::refresh);
    connect(&document, &Document::replaced, this, &Inspector::showSelection);
    connect(&m_subject, &Subject::pickingChanged, this, &Inspector::showPicking);
    connect(&m_sliders, &SliderShelf::changed, this, &Inspector::refresh);
    connect(m_kinds, &QTabBar::currentChanged, this, [this](int index) {
        if (index >= 0)
            showKind(Kind(m_kinds->tabData(index).toInt()));
    });
    showSelection();
}

// Closing takes the keyboard from a field, which then asks about what was typed: that is answered
// while there is still something to ask.
Inspector::~Inspector()
{
    if (QWidget* const field = focusWidget())
        field->clearFocus();
}

QWidget* Inspector::field(std::string_view key, int axis) const
{
    const PropertyForm* form = m_forms[std::size_t(m_subject.kind())];
    return form ? form->field(key, axis) : nullptr;
}

void Inspector::showSelection()
{
    if (m_subject.picking() && takePick())
        return;
    leaveForm();

    const Census all = census(m_document.scene(), m_selection.ids());
    const QSignalBlocker quiet(m_kinds);
    while (m_kinds->count() > 0)
        m_kinds->removeTab(0);
    int current = -1;
    for (int k = 0; k < kindCount; ++k)
        if (!all[Kind(k)].empty()) {
            const int tab = m_kinds->addTab(counted(Kind(k), qsizetype(all[Kind(k)].size())));
            m_kinds->setTabData(tab, k);
            if (Kind(k) == m_subject.kind())
                current = tab;
        }
    m_kinds->setVisible(m_kinds->count() > 1);
    m_kinds->setCurrentIndex(std::max(current, 0));
    showKind(m_kinds->count() > 0 ? Kind(m_kinds->tabData(std::max(current, 0)).toInt())
                                  : Kind::Settings);
}

// Commits or reverts what was typed, as it belongs to the things that were selected until now.
void Inspector::leaveForm()
{
    PropertyForm* form = m_forms[std::size_t(m_subject.kind())];
    const auto exists = [this](Id id) { return ripstop::find(m_document.scene(), id).has_value(); };
    if (form && std::all_of(m_subject.ids().begin(), m_subject.ids().end(), exists))
        form->leave();
}

void Inspector::showKind(Kind kind)
{
    leaveForm();
    std::vector<Id> ids = idsOf(census(m_document.scene(), m_selection.ids())[kind]);
    if (ids.empty())
        ids = {settingsId};
    m_subject.set(kind, std::move(ids));

    PropertyForm*& form = m_forms[std::size_t(kind)];
    if (!form) {
        form = new PropertyForm(m_subject, m_usage, m_sliders, kind);
        auto* area = new QScrollArea;
        area->setWidgetResizable(true);
        area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        area->setFrameShape(QFrame::NoFrame);
        area->setWidget(kind == Kind::Material ? underPresets(form) : form);
        m_pages->addWidget(area);
        m_areas[std::size_t(kind)] = area;
    }
    m_pages->setCurrentWidget(m_areas[std::size_t(kind)]);
    refresh();
    filter();
}

void Inspector::startSearch()
{
    m_search->setFocus();
    m_search->selectAll();
}

void Inspector::filter()
{
    const int shown = m_forms[std::size_t(m_subject.kind())]->filter(m_search->text());
    m_noMatch->setVisible(shown == 0);
    m_noMatch->setText(tr("No property is about \"%1\".").arg(m_search->text()));
    if (m_presets)
        m_presets->setVisible(m_search->text().isEmpty());
}

QWidget* Inspector::underPresets(PropertyForm* form)
{
    auto* both = new QWidget;
    auto* layout = new QVBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    m_presets = new PresetChooser(m_subject, m_usage);
    layout->addWidget(m_presets);
    layout->addWidget(form, 1);
    return both;
}

QMenu* Inspector::presetMenu()
{
    return m_presets && m_subject.kind() == Kind::Material ? &m_presets->menu() : nullptr;
}

void Inspector::refresh()
{
    const auto exists = [this](Id id) { return ripstop::find(m_document.scene(), id).has_value(); };
    if (!std::all_of(m_subject.ids().begin(), m_subject.ids().end(), exists))
        return; // an edit removed it, and the selection will say so
    if (!m_forms[std::size_t(m_subject.kind())])
        return; // the form has not been shown yet
    refreshHeader();
    m_forms[std::size_t(m_subject.kind())]->refresh();
    if (m_subject.kind() == Kind::Material)
        m_presets->refresh();
}

void Inspector::refreshHeader()
{
    const Scene& scene = m_document.scene();
    const Kind kind = m_subject.kind();
    if (std::exchange(m_iconKind, kind) != kind) // or it would be painted at each edit
        m_icon->setPixmap(icon(QString::fromUtf8(kindName(kind).data()))
                              .pixmap(QSize(iconSide, iconSide), devicePixelRatioF()));
    QString title = describe(scene, m_subject.ids());
    title[0] = title.at(0).toUpper();
    m_title->setText(title);
    const QString facts = kind == Kind::Settings
                              ? tr("How the scene is run. Select something to edit it.")
                              : totals(scene, kind, m_subject.ids());
    m_totals->setText(facts);
    m_totals->setVisible(!facts.isEmpty());
    m_targets->show(m_subject.ids().size() == 1 ? m_subject.ids().front() : noId);
}

void Inspector::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) { // icons have the colours of the palette
        m_iconKind.reset();
        refresh();
    }
}

void Inspector::showPicking()
{
    const Property* property = m_subject.picking();
    m_banner->setVisible(property);
    if (!property)
        return;
    //: while a field waits for the user to select something in the view
    m_banner->setText(tr("%1: select it in the view or in the outline. Escape stops this.")
                          .arg(labelOf(*property)));
    setFocus();
}

// The selection answers a field that asked for one; what was selected before comes back.
bool Inspector::takePick()
{
    const Property& property = *m_subject.picking();
    const Census all = census(m_document.scene(), m_selection.ids());
    std::vector<Id> picked;
    for (int k = 0; k < kindCount; ++k)
        if (property.pointsAt.contains(Kind(k)))
            for (const Census::Found& found : all[Kind(k)])
                picked.push_back(found.id);
    if (picked.empty())
        return true; // nothing fits, so the field goes on asking
    std::sort(picked.begin(), picked.end());

    const bool isList = std::holds_alternative<std::vector<Id>>(property.initial);
    const std::vector<Id> before = m_subject.ids();
    m_subject.cancelPick();
    m_subject.edit(property, setTo(isList ? Value(picked) : Value(picked.front())));
    m_selection.set(before);
    return true;
}

void Inspector::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape && !m_search->text().isEmpty())
        return m_search->clear();
    if (event->key() == Qt::Key_Escape && m_subject.picking()) {
        const std::vector<Id> before = m_subject.ids();
        m_subject.cancelPick();
        m_selection.set(before);
        return;
    }
    QWidget::keyPressEvent(event);
}

} // namespace ripstop
