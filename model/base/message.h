// What the program says to people: a sentence whose gaps are filled with names, numbers and other
// sentences.
//
// The English sentence with its gaps is what identifies a message, as in Qt and gettext, so that
// the model needs no list of numbers and the source can be read:
//
//     Failure("There is no %1 called \"%2\".", Message("material"), name)
//
// The command line, files and tests say it in English: english(). The window looks up the sentence
// with its gaps in resources/translations and fills in the parts, each in its language:
// translated() in views/document/words.h. scripts/translations finds the sentences by the calls
// Message("...") and Failure("...") with the literal in them; no other text becomes a sentence, so
// that none can be forgotten. What has a singular and a plural is two messages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ripstop {

class Message
{
public:
    enum class Kind {
        Sentence, // English, with or without gaps: looked up in the other language
        Verbatim, // a name, a path, a reason of the operating system: the same in each language
        Number    // with the point of English, which may be the comma of another language
    };

    Message() = default; // empty

    // The parts fill the gaps %1, %2, ...: messages, texts to be taken verbatim, and whole numbers.
    // A number with decimals says how it is printed: Message::number("%.3g", length).
    template <std::size_t size, typename... Parts>
    explicit Message(const char (&english)[size], Parts&&... parts)
        : m_text(english)
        , m_parts{part(std::forward<Parts>(parts))...}
    {}
    template <std::size_t size, typename... Parts>
    explicit Message(char (&composed)[size], Parts&&... parts) = delete; // it is no literal

    // A label or a choice of a table whose texts `ripstop --table-texts` lists.
    static Message word(std::string_view english) { return {Kind::Sentence, std::string(english)}; }
    static Message verbatim(std::string text) { return {Kind::Verbatim, std::move(text)}; }
    static Message number(std::string printed) { return {Kind::Number, std::move(printed)}; }
    static Message number(const char* pattern, double value); // as printf() has them

    // This sentence, of a table for example, with these parts in its gaps.
    template <typename... Parts>
    Message with(Parts&&... parts) const
    {
        Message filled = *this;
        filled.m_parts = {part(std::forward<Parts>(parts))...};
        return filled;
    }

    Kind kind() const { return m_kind; }
    bool empty() const { return m_text.empty(); }
    std::string english() const;

    // The message in the language that `inOther` looks texts up in. It is asked for a sentence with
    // its gaps, for a number, or for what is taken verbatim.
    using Lookup = std::string (*)(Kind kind, const std::string& english);
    std::string said(Lookup inOther) const;

    bool operator==(const Message&) const = default;

private:
    Message(Kind kind, std::string text)
        : m_kind(kind)
        , m_text(std::move(text))
    {}

    static Message part(Message message) { return message; }
    static Message part(std::string text) { return verbatim(std::move(text)); }
    static Message part(std::string_view text) { return verbatim(std::string(text)); }
    static Message part(const char* text) { return verbatim(text); }
    template <typename Whole>
    static std::enable_if_t<std::is_integral_v<Whole>, Message> part(Whole number)
    {
        return Message::number(std::to_string(number));
    }

    Kind m_kind = Kind::Sentence;
    std::string m_text; // a sentence with its gaps
    std::vector<Message> m_parts;
};

} // namespace ripstop
