// Reading the JSON of a study, field by field.
//
// StudyFields knows where it is ("variables[2].from"), keeps the first thing that is wrong, and
// refuses what nobody reads, so that a misspelt field is no silent default. nlohmann's exceptions
// never begin: everything is asked for before it is taken. Only sources include this.
#pragma once

#include "base/choice_names.h"
#include "base/result.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>
#include <set>
#include <string>

namespace ripstop {

using StudyJson = nlohmann::ordered_json;

inline constexpr const char* studyFormat = "ripstop-study";
inline constexpr int studyVersion = 1;

// What is wrong with a study.
struct StudyFault
{
    std::string place; // "variables[2].from"; of what holds it when it is missing
    Message message;   // half a sentence
};

// The fields of an object, and the first thing that is wrong with them.
class StudyFields
{
public:
    StudyFields(const StudyJson& object, std::string place, std::optional<StudyFault>& fault)
        : m_object(object)
        , m_place(std::move(place))
        , m_fault(fault)
    {
        if (!object.is_object())
            say("", Message("has %1, which is no object in braces", where({})));
    }

    bool has(const char* key) const { return m_object.is_object() && m_object.contains(key); }

    std::string text(const char* key, bool isNeeded = false)
    {
        const StudyJson* field = find(key, isNeeded);
        if (field && !field->is_string())
            say(key, Message("has %1, which is no text in quotation marks", where(key)));
        return field && field->is_string() ? field->get<std::string>() : std::string();
    }

    double number(const char* key, double usual, double least, double most)
    {
        const StudyJson* field = find(key, std::isnan(usual));
        if (!field)
            return usual;
        const double value = field->is_number() ? field->get<double>() : std::nan("");
        if (!(value >= least && value <= most)) {
            say(key, Message("has %1, which is no number from %2 to %3", where(key),
                             Message::number("%.6g", least), Message::number("%.6g", most)));
            return usual;
        }
        return value;
    }

    bool flag(const char* key)
    {
        const StudyJson* field = find(key, false);
        if (field && !field->is_boolean())
            say(key, Message("has %1, which is neither true nor false", where(key)));
        return field && field->is_boolean() && field->get<bool>();
    }

    template <typename Choice>
    Choice choice(const char* key, Choice usual)
    {
        const std::string name = text(key);
        if (name.empty())
            return usual;
        std::string all;
        for (std::size_t i = 0; i < choiceNames<Choice>.size(); ++i) {
            if (name == choiceNames<Choice>[i])
                return Choice(i);
            all += (i ? ", " : "") + std::string(choiceNames<Choice>[i]);
        }
        say(key, Message("has %1 = \"%2\"; it is one of %3", where(key), name, all));
        return usual;
    }

    // Calls visit(element, place) for each of an array; nothing where there is none.
    template <typename Visit>
    void each(const char* key, bool isNeeded, Visit visit)
    {
        const StudyJson* field = find(key, isNeeded);
        if (field && !field->is_array()) {
            say(key, Message("has %1, which is no list in brackets", where(key)));
            return;
        }
        for (std::size_t i = 0; field && i < field->size(); ++i)
            visit((*field)[i], where(key) + '[' + std::to_string(i) + ']');
    }

    // After all that is read has been read. It is said before that a field is missing, which it may
    // have been meant to be.
    void refuseOthers()
    {
        if (m_object.is_object())
            for (const auto& field : m_object.items())
                if (!m_read.contains(field.key()))
                    m_fault = {
                        where(field.key()),
                        Message("has %1, which means nothing to this version", where(field.key()))};
    }

    std::string where(const std::string& key) const
    {
        return m_place.empty() ? key : key.empty() ? m_place : m_place + '.' + key;
    }

    // Of a field, or of the object as a whole where a field is missing.
    void say(const std::string& key, Message message) { sayAt(where(key), std::move(message)); }

    void sayAt(std::string place, Message message)
    {
        if (!m_fault)
            m_fault = {std::move(place), std::move(message)};
    }

    // The field, or null; says so where it is needed.
    const StudyJson* find(const char* key, bool isNeeded)
    {
        m_read.insert(key);
        if (has(key))
            return &m_object[key];
        if (isNeeded)
            say("", Message("has no %1", where(key)));
        return nullptr;
    }

private:
    const StudyJson& m_object;
    std::string m_place;
    std::optional<StudyFault>& m_fault;
    std::set<std::string> m_read;
};

} // namespace ripstop
