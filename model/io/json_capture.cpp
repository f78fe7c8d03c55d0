#include "io/json_capture.h"

#include "io/json_text.h"

namespace ripstop {

bool JsonCapture::start(std::string& into, std::string_view key)
{
    if (!into.empty())
        into += ", ";
    appendQuoted(into, key);
    into += ": ";
    start(into);
    return true;
}

void JsonCapture::start(std::string& into)
{
    m_into = &into;
    m_depth = 0;
    m_comma = false;
}

bool JsonCapture::add(const JsonEvent& event, std::string_view text)
{
    using Type = JsonEvent::Type;
    std::string& into = *m_into;
    if (m_comma && !event.ends())
        into += ", ";
    m_comma = event.type != Type::Key && !event.begins();
    switch (event.type) {
    case Type::Null:
        into += "null";
        break;
    case Type::Boolean:
        into += event.boolean ? "true" : "false";
        break;
    case Type::Number:
        into += numberText(text, event.end);
        break;
    case Type::Text:
        appendQuoted(into, event.text);
        break;
    case Type::Key:
        appendQuoted(into, event.text);
        into += ": ";
        break;
    case Type::BeginObject:
    case Type::EndObject:
    case Type::BeginArray:
    case Type::EndArray:
        into += text[event.end - 1]; // the bracket itself
        break;
    case Type::Error:
        break;
    }
    if (event.begins())
        ++m_depth;
    if (event.ends())
        --m_depth;
    if (m_depth == 0 && event.type != Type::Key)
        m_into = nullptr;
    return true;
}

} // namespace ripstop
