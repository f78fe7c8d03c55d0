// Stages: the constructor lays the dialog out and sets two timers: one looks shortly after the
// last key or edit, the other looks while a run goes on, and only when the frame is another one.
// look() takes the frame of now and writes how many elements match, or what is wrong with the
// condition; select() looks once more and replaces, adds to, takes from or narrows the selection.
#include "dialogs/condition_dialog.h"

#include "document/document.h"
#include "document/measurement.h"
#include "document/selection.h"
#include "document/words.h"
#include "icons/icon.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>

namespace ripstop {
namespace {

constexpr int typingPause = 120;   // ms
constexpr int countingPause = 300; // ms, between two counts while a simulation runs
constexpr int signSide = 16;       // pixels

enum class How { Replace, Add, Remove, Among };

} // namespace

ConditionDialog::ConditionDialog(Document& document, Selection& selection,
                                 std::function<std::shared_ptr<const Frame>()> frame,
                                 QWidget* parent)
    : QDialog(parent)
    , m_document(document)
    , m_selection(selection)
    , m_frame(std::move(frame))
    , m_condition(new QLineEdit)
    , m_sign(new QLabel)
    , m_verdict(new QLabel)
    , m_how(new QComboBox)
    , m_keys(new QTreeWidget)
{
    setWindowTitle(tr("Select by property"));
    m_condition->setPlaceholderText(
        tr("strain > 5 %    mass < 1 g and not pinned    material = ripstop"));
    m_condition->setClearButtonEnabled(true);
    m_condition->setAccessibleName(tr("Condition"));
    m_verdict->setTextFormat(Qt::PlainText); // it repeats what was typed
    m_verdict->setWordWrap(true);
    m_verdict->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_verdict->setMinimumHeight(2 * fontMetrics().lineSpacing()); // a message may need two lines
    m_verdict->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_sign->setFixedWidth(signSide);
    m_sign->setAlignment(Qt::AlignTop);
    m_how->addItems({tr("Replace the selection"), tr("Add to the selection"),
                     tr("Take away from the selection"), tr("Keep only those selected already")});
    m_how->setAccessibleName(tr("What becomes of the selection"));
    fillKeys();

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    m_select = buttons->addButton(tr("&Select"), QDialogButtonBox::ActionRole);
    m_select->setDefault(true);
    connect(m_select, &QPushButton::clicked, this, &ConditionDialog::select);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);

    auto* answer = new QHBoxLayout;
    answer->addWidget(m_sign, 0, Qt::AlignTop);
    answer->addWidget(m_verdict, 1);
    auto* label = new QLabel(tr("Particles, links and panels with"));
    label->setBuddy(m_condition);
    auto* below = new QHBoxLayout;
    below->addWidget(m_how);
    below->addStretch();
    below->addWidget(buttons);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(label);
    layout->addWidget(m_condition);
    layout->addLayout(answer);
    layout->addWidget(m_keys, 1);
    layout->addLayout(below);
    resize(620, 460);

    m_soon.setSingleShot(true);
    m_soon.setInterval(typingPause);
    connect(&m_soon, &QTimer::timeout, this, &ConditionDialog::look);
    m_often.setInterval(countingPause);
    connect(&m_often, &QTimer::timeout, this, &ConditionDialog::lookAgain);
    const auto soon = [this] { m_soon.start(); };
    connect(m_condition, &QLineEdit::textChanged, this, soon);
    connect(m_condition, &QLineEdit::returnPressed, this, &ConditionDialog::select);
    connect(&document, &Document::changed, this, soon);
    connect(&document, &Document::replaced, this, soon);
    look();
}

void ConditionDialog::fillKeys()
{
    m_keys->setHeaderLabels({tr("Property"), tr("Unit"), tr("Of"), tr("Meaning")});
    m_keys->setRootIsDecorated(false);
    m_keys->setAlternatingRowColors(true);
    m_keys->setUniformRowHeights(true);
    for (const ConditionKey& key : conditionKeys(measurementOf({}))) {
        QStringList kinds;
        for (const Kind kind : {Kind::Particle, Kind::Link, Kind::Panel})
            if (key.kinds.contains(kind))
                kinds << kindPluralLabel(kind).toLower();
        auto* row = new QTreeWidgetItem(m_keys, {QString::fromStdString(key.key),
                                                 QString::fromStdString(key.unit), kinds.join(", "),
                                                 translated(key.help)});
        row->setToolTip(3, row->text(3));
    }
    for (const int column : {0, 1, 2})
        m_keys->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    m_keys->setToolTip(tr("Double click to put it into the condition."));
    connect(m_keys, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* row) {
        m_condition->insert(row->text(0) + ' ');
        m_condition->setFocus();
    });
}

void ConditionDialog::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    m_condition->setFocus();
    m_often.start();
    look();
}

void ConditionDialog::setCondition(const QString& condition)
{
    m_condition->setText(condition);
    look();
}

QString ConditionDialog::verdict() const { return m_verdict->text(); }

Result<std::vector<Id>> ConditionDialog::found() const
{
    return matching(m_document.scene(), measurementOf(m_seen), m_condition->text().toStdString());
}

void ConditionDialog::look()
{
    m_soon.stop();
    m_seen = m_frame();
    m_sign->clear();
    m_select->setEnabled(false);
    if (m_condition->text().trimmed().isEmpty())
        return m_verdict->setText(
            tr("Write a property, a comparison and a value; \"and\" joins several."));
    const auto ids = found();
    if (!ids) {
        m_sign->setPixmap(icon("warning").pixmap(signSide));
        return m_verdict->setText(translated(ids.message()));
    }
    m_select->setEnabled(true);
    m_sign->setPixmap(icon("ok").pixmap(signSide));
    m_verdict->setText(ids->empty() ? tr("Nothing matches now.")
                                    : tr("%1 match now.").arg(describe(m_document.scene(), *ids)));
}

void ConditionDialog::lookAgain()
{
    if (!isVisible())
        m_often.stop();
    else if (m_seen != m_frame() && !m_soon.isActive())
        look();
}

void ConditionDialog::select()
{
    look();
    const auto ids = found();
    if (!ids)
        return;
    switch (How(m_how->currentIndex())) {
    case How::Replace:
        return m_selection.set(*ids);
    case How::Add:
        return m_selection.add(*ids);
    case How::Remove:
        return m_selection.remove(*ids);
    case How::Among: {
        std::vector<Id> both;
        std::ranges::set_intersection(m_selection.ids(), *ids, std::back_inserter(both));
        return m_selection.set(std::move(both));
    }
    }
}

} // namespace ripstop
