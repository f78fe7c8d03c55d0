// Messages: English from a sentence and its parts, and another language from the same parts.
#include "base/result.h"
#include "registered_test.h"

#include <QtTest>

namespace ripstop::test_message {

namespace {

// Sentences become capitals, numbers get a comma: what a translation does, without one.
std::string loud(Message::Kind kind, const std::string& english)
{
    QString text = QString::fromStdString(english);
    switch (kind) {
    case Message::Kind::Sentence:
        return text.toUpper().toStdString();
    case Message::Kind::Number:
        return text.replace('.', ',').toStdString();
    case Message::Kind::Verbatim:
        break;
    }
    return english;
}

} // namespace

class TestMessage final : public QObject
{
    Q_OBJECT

private slots:
    void partsFillTheGapsInAnyOrder()
    {
        const Message message("%2 of %1, %2", "kite", Message("%1 links", 3));
        QCOMPARE(message.english(), std::string("3 links of kite, 3 links"));
    }

    // What was put in is not looked through again, and a percent sign is one.
    void partsAreTakenAsTheyAre()
    {
        QCOMPARE(Message("%1 and %2", "%2", "b").english(), std::string("%2 and b"));
        QCOMPARE(Message("%1 %, up to %2 %.", 5, Message::number("%.3g", 7.25)).english(),
                 std::string("5 %, up to 7.25 %."));
        QCOMPARE(Message("at 90 %1").english(), std::string("at 90 %1"));
        QCOMPARE(Message::verbatim("100 %1").english(), std::string("100 %1"));
    }

    // Names stay, sentences and words are looked up, numbers follow the language.
    void eachKindOfPartIsSaidInItsWay()
    {
        const Message message("the %1 \"%2\" is %3 m: %4", Message::word("rope"), "Rope 1.5",
                              Message::number("%g", 2.5), Message("too long"));
        QCOMPARE(message.english(), std::string("the rope \"Rope 1.5\" is 2.5 m: too long"));
        QCOMPARE(message.said(loud), std::string("THE ROPE \"Rope 1.5\" IS 2,5 M: TOO LONG"));
    }

    void sentencesOfTablesAreFilledLater()
    {
        const Message many("%1 edges");
        QCOMPARE(many.with(2).english(), std::string("2 edges"));
        QCOMPARE(many, Message("%1 edges"));
        QVERIFY(many.with(2) != many.with(3));
        QVERIFY(Message().empty());
    }

    void failuresAreMessages()
    {
        const Result<int> refused = Failure("%1 is a folder; name a file.", "/tmp");
        QVERIFY(!refused);
        QCOMPARE(refused.message(), Message("%1 is a folder; name a file.", "/tmp"));
    }
};

const RegisteredTest registered("test_message", runPlain<TestMessage>);

} // namespace ripstop::test_message
#include "test_message.moc"
