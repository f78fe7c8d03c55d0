// makeField() comes first, with all the choices that there are. Then follows one function for each
// type: it makes the widget, connects what a person does to an edit of the subject, and returns how
// the widget shows a value that is common to all things, or that they differ.
//
// Fields of colours and files are a text field with a button beside it. Numbers, vectors and ids
// have files of their own (number_field.cpp, id_field.cpp).
#include "inspector/field.h"

#include "document/document.h"
#include "document/shape_file.h"
#include "document/spoken.h"
#include "document/wind_file.h"
#include "document/words.h"
#include "icons/icon.h"
#include "icons/swatch.h"
#include "inspector/value_edit.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeySequence>
#include <QLocale>
#include <QPlainTextEdit>
#include <QToolButton>

namespace ripstop {
namespace {

constexpr int leastChoice = 80; // px, that narrow docks have room for

QString textOf(const Value& value)
{
    const std::string* text = std::get_if<std::string>(&value);
    return text ? QString::fromStdString(*text) : QString();
}

// An editor of several lines. It commits when the focus leaves, or by Ctrl+Enter.
class NotesEdit final : public QPlainTextEdit
{
public:
    explicit NotesEdit(std::function<void(const QString&)> commit)
        : m_commit(std::move(commit))
    {}

private:
    void focusOutEvent(QFocusEvent* event) override
    {
        QPlainTextEdit::focusOutEvent(event);
        m_commit(toPlainText());
    }
    void keyPressEvent(QKeyEvent* event) override
    {
        if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
            && event->modifiers() & Qt::ControlModifier)
            m_commit(toPlainText());
        else
            QPlainTextEdit::keyPressEvent(event);
    }

    std::function<void(const QString&)> m_commit;
};

QWidget* sideBySide(QWidget* left, QWidget* right)
{
    auto* both = new QWidget;
    auto* layout = new QHBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(left);
    layout->addWidget(right);
    return both;
}

} // namespace

Field makeField(const FieldPlace& place)
{
    const Value& shape = place.property.initial;
    if (place.property.optional || std::holds_alternative<double>(shape)
        || std::holds_alternative<int>(shape))
        return numberField(place);
    if (std::holds_alternative<bool>(shape))
        return flagField(place);
    if (std::holds_alternative<Vec3>(shape))
        return vectorField(place);
    if (std::holds_alternative<NumberRows>(shape))
        return rowsField(place);
    if (!place.property.pointsAt.empty())
        return idField(place);
    if (!place.property.choices.empty())
        return choiceField(place);
    switch (place.property.meaning) {
    case Meaning::Color:
        return colorField(place);
    case Meaning::File:
        return fileField(place);
    case Meaning::Notes:
        return notesField(place);
    case Meaning::Plain:
    case Meaning::Name:
    case Meaning::Shown:
    case Meaning::Path:
    case Meaning::Keys:
    case Meaning::Polar:
    case Meaning::Times:
        break;
    }
    return textField(place);
}

Field flagField(const FieldPlace& place)
{
    auto* box = new QCheckBox;
    QObject::connect(box, &QCheckBox::clicked, box, [place, box] {
        place.subject.edit(place.property, setTo(box->checkState() != Qt::Unchecked));
    });
    return {box, {box}, [box](const Common& common) {
                const bool* on = std::get_if<bool>(&common.value);
                box->setTristate(common.mixed[0]);
                box->setCheckState(common.mixed[0] ? Qt::PartiallyChecked
                                   : on && *on     ? Qt::Checked
                                                   : Qt::Unchecked);
            }};
}

Field choiceField(const FieldPlace& place)
{
    auto* box = new QComboBox;
    box->setFocusPolicy(Qt::StrongFocus);
    box->setPlaceholderText(mixedText());
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents); // which says where it fits
    box->setMinimumWidth(leastChoice);
    const auto choices = place.property.choices;
    for (const std::string_view choice : choices)
        box->addItem(choiceLabel(choice));
    QObject::connect(box, &QComboBox::activated, box, [place, choices](int index) {
        place.subject.edit(place.property, setTo(std::string(choices[std::size_t(index)])));
    });
    return {box, {box}, [box, choices](const Common& common) {
                const std::string* name = std::get_if<std::string>(&common.value);
                const auto found =
                    name ? std::find(choices.begin(), choices.end(), *name) : choices.end();
                const bool shows = !common.mixed[0] && found != choices.end();
                box->setCurrentIndex(shows ? int(found - choices.begin()) : -1);
            }};
}

Field textField(const FieldPlace& place)
{
    const auto judge = [place](const QString& text) -> QString {
        const Meaning meaning = place.property.meaning;
        if (meaning == Meaning::Keys && !text.trimmed().isEmpty()
            && QKeySequence::fromString(text.trimmed()).toString().isEmpty())
            return words("No key is called so; try Left, A or Ctrl+Up.");
        if (meaning == Meaning::Name && text.trimmed().isEmpty())
            return words("A name is needed.");
        const auto reason = refusal(place.property, text.trimmed().toStdString());
        return reason
                   ? words("The %1 %2.").arg(labelOf(place.property).toLower(), translated(*reason))
                   : QString();
    };
    auto* edit = new ValueEdit(judge);
    QObject::connect(edit, &ValueEdit::complained, edit, place.complain);
    QObject::connect(edit, &ValueEdit::committed, edit, [place](const QString& text) {
        place.subject.edit(place.property, setTo(text.trimmed().toStdString()));
    });
    return {edit, {edit}, [edit](const Common& common) {
                edit->show(common.mixed[0] ? QString() : textOf(common.value),
                           common.mixed[0] ? mixedText() : QString());
            }};
}

// What stands in place of more rows of times than one reads in a line; empty for few.
QString summaryOf(const NumberRows& rows)
{
    constexpr std::size_t few = 3;
    if (rows.size() <= few)
        return {};
    return words("%1 rows, %2 to %3 s")
        .arg(QLocale().toString(qulonglong(rows.size())), spokenText(rows.front()[0], {}, 4),
             spokenText(rows.back()[0], {}, 4));
}

// Beside rows of times a button that reads a measured wind.
Field withRecordButton(const FieldPlace& place, Field field)
{
    auto* button = new QToolButton;
    button->setAutoRaise(true);
    button->setIcon(icon(QStringLiteral("open")));
    button->setToolTip(words("Read a measured wind from a table: time and speed, with a direction, "
                             "or with three components."));
    button->setAccessibleName(words("Read a measured wind"));
    QObject::connect(button, &QToolButton::clicked, button, [place, button] {
        const auto rows = askWindRecord(button->window(), place.subject.document());
        if (!rows)
            return;
        place.complain(*rows ? QString() : translated(rows->message()));
        if (*rows)
            place.subject.edit(place.property, setTo(**rows));
    });
    field.widget = sideBySide(field.widget, button);
    return field;
}

Field rowsField(const FieldPlace& place)
{
    auto* edit = new ValueEdit([place](const QString& text) -> QString {
        const auto value = valueFromText(place.property, text.toStdString());
        return value ? QString()
                     : words("Rows are numbers with commas between them and a semicolon after "
                             "each row; %1.")
                           .arg(translated(value.message()));
    });
    QObject::connect(edit, &ValueEdit::complained, edit, place.complain);
    QObject::connect(edit, &ValueEdit::committed, edit, [place](const QString& text) {
        if (const auto value = valueFromText(place.property, text.toStdString()))
            place.subject.edit(place.property, setTo(*value));
    });
    const bool isOfTimes = place.property.meaning == Meaning::Times;
    Field field{edit, {edit}, [edit, isOfTimes](const Common& common) {
                    const auto* rows = std::get_if<NumberRows>(&common.value);
                    const QString summary = common.mixed[0]     ? mixedText()
                                            : isOfTimes && rows ? summaryOf(*rows)
                                                                : QString();
                    edit->show(summary.isEmpty()
                                   ? QString::fromStdString(textFromValue(common.value))
                                   : QString(),
                               summary);
                }};
    return isOfTimes ? withRecordButton(place, std::move(field)) : field;
}

Field notesField(const FieldPlace& place)
{
    auto* edit = new NotesEdit([place](const QString& text) {
        if (Subject::common(place.property, place.subject.refs()).value
            != Value(text.toStdString()))
            place.subject.edit(place.property, setTo(text.toStdString()));
    });
    edit->setTabChangesFocus(true);
    edit->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    edit->setFixedHeight(4 * edit->fontMetrics().lineSpacing() + 10);
    // its row would take all room otherwise
    edit->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return {edit, {edit}, [edit](const Common& common) {
                if (const QString text = textOf(common.value); text != edit->toPlainText())
                    edit->setPlainText(text);
            }};
}

Field colorField(const FieldPlace& place)
{
    Field field = textField(place);
    auto* edit = static_cast<ValueEdit*>(field.widget);

    auto* button = new QToolButton;
    button->setAutoRaise(true);
    button->setToolTip(words("Choose a colour."));
    button->setAccessibleName(words("Choose a colour"));
    QObject::connect(button, &QToolButton::clicked, button, [place, button] {
        const Value now = Subject::common(place.property, place.subject.refs()).value;
        const QColor color = QColorDialog::getColor(QColor(textOf(now)), button->window());
        if (color.isValid())
            place.subject.edit(place.property, setTo(color.name().toStdString()));
    });

    return {sideBySide(button, edit), field.focus,
            [button, showText = field.refresh](const Common& common) {
                showText(common);
                button->setIcon(swatch(common.mixed[0] ? QColor(Qt::transparent)
                                                       : QColor(textOf(common.value))));
            }};
}

Field fileField(const FieldPlace& place)
{
    Field field = textField(place);
    auto* button = new QToolButton;
    button->setAutoRaise(true);
    button->setIcon(icon(QStringLiteral("open")));
    button->setToolTip(words("Choose a file."));
    button->setAccessibleName(words("Choose a file"));
    QObject::connect(button, &QToolButton::clicked, button, [place, button] {
        const std::vector<ConstRef> refs = place.subject.refs();
        const Document& document = place.subject.document();
        const auto* collider = std::get_if<const Collider*>(&refs.front());
        const QString file = collider ? askShapeFile(button->window(), document, (*collider)->shape)
                                      : askPictureFile(button->window(), document);
        if (!file.isEmpty())
            place.subject.edit(place.property, setTo(file.toStdString()));
    });
    return {sideBySide(field.widget, button), field.focus, field.refresh};
}

} // namespace ripstop
