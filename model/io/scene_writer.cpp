// The text of a scene, written straight into one string: a tree of JSON values for a million
// elements would take gigabytes.
#include "io/scene_file.h"

#include "derived/named_files.h"
#include "io/json_text.h"
#include "io/json_value.h"
#include "scene/property.h"

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace ripstop {
namespace {

constexpr std::string_view itemIndent = "\n      ";

class SceneWriter
{
public:
    explicit SceneWriter(const Scene& scene, std::optional<std::filesystem::path> folder = {})
        : m_scene(scene)
        , m_folder(std::move(folder))
    {
        for (int i = 0; i < kindCount; ++i)
            m_properties[std::size_t(i)] = propertiesOf(Kind(i));
        for (const UnknownItem& item : scene.unknownItems)
            m_unknownItems[item.after].push_back(&item);
    }

    std::string text()
    {
        m_text += "{\n  \"format\": \"ripstop-scene\",\n  \"version\": 1,\n  \"nextId\": ";
        appendValue(m_text, m_scene.nextId);
        m_text += ",\n  \"settings\": {";
        open("\n    ");
        addProperties(&m_scene.settings);
        addUnknown(settingsId);
        m_text += m_first ? "}" : "\n  }";
        m_text += ",\n  \"items\": [";
        m_first = true;
        addUnknownItems(noId);
        for (const Entry& entry : m_scene.items) {
            beginItem();
            addItem(entry);
            m_first = false;
            addUnknownItems(entry.id);
        }
        for (const UnknownItem& item : m_scene.unknownItems) // behind items that are gone
            addUnknownItems(item.after);
        m_text += m_first ? "]" : "\n  ]";
        open(",\n  ");
        addUnknown(noId);
        m_text += "\n}\n";
        return std::move(m_text);
    }

private:
    // The members that follow belong to a new object; `indent` goes before each.
    void open(std::string_view indent)
    {
        m_indent = indent;
        m_first = true;
    }

    void separate()
    {
        m_text += m_first ? "" : ",";
        m_text += m_indent;
        m_first = false;
    }

    void addKey(std::string_view key)
    {
        separate();
        appendQuoted(m_text, key);
        m_text += ": ";
    }

    void addProperties(const ConstRef& ref)
    {
        for (const Property& property : m_properties[std::size_t(kindOf(ref))]) {
            const Value value = property.get(ref);
            if (sameBits(value, property.initial))
                continue;
            addKey(property.key);
            appendValue(m_text, value);
        }
    }

    void addUnknown(Id id)
    {
        const auto found = m_scene.unknown.find(id);
        if (found == m_scene.unknown.end() || found->second.size() <= 2)
            return;
        separate();
        m_text.append(found->second, 1, found->second.size() - 2);
    }

    void beginItem()
    {
        m_text += m_first ? "\n    " : ",\n    ";
        m_first = false;
    }

    // Those behind this item, once.
    void addUnknownItems(Id after)
    {
        const auto found = m_unknownItems.find(after);
        if (found == m_unknownItems.end())
            return;
        for (const UnknownItem* item : found->second) {
            beginItem();
            m_text += item->text;
        }
        m_unknownItems.erase(found);
    }

    void addItem(const Entry& entry)
    {
        m_text += '{';
        const ConstRef ref =
            std::visit([](const auto& item) -> ConstRef { return &item; }, entry.item);
        open(itemIndent);
        addKey("type");
        appendQuoted(m_text, kindName(kindOf(ref)));
        addKey("id");
        appendValue(m_text, entry.id);
        if (const Collider* collider = std::get_if<Collider>(&entry.item); collider && m_folder) {
            Collider moved = *collider;
            moved.file = fileSeenFrom(*m_folder, m_scene, collider->file);
            addProperties(&moved);
        } else if (const Material* material = std::get_if<Material>(&entry.item);
                   material && m_folder) {
            Material moved = *material;
            moved.picture = fileSeenFrom(*m_folder, m_scene, material->picture);
            addProperties(&moved);
        } else {
            addProperties(ref);
        }
        if (const Part* part = std::get_if<Part>(&entry.item)) {
            addParameters(*part);
            addTable(Kind::Particle, part->particles);
            addTable(Kind::Link, part->links);
            addTable(Kind::Panel, part->panels);
        }
        addUnknown(entry.id);
        m_text += "\n    }";
    }

    void addParameters(const Part& part)
    {
        if (part.parameters.empty())
            return;
        addKey("parameters");
        m_text += '{';
        const char* comma = "";
        for (const auto& [key, value] : part.parameters) {
            m_text += comma;
            appendQuoted(m_text, key);
            m_text += ": ";
            appendNumber(m_text, value);
            comma = ", ";
        }
        m_text += '}';
    }

    template <typename Row>
    void addTable(Kind kind, const std::vector<Row>& rows)
    {
        if (rows.empty())
            return;
        addKey(kindPlural(kind));
        m_text += '[';
        for (const Row& row : rows) {
            m_text += &row == rows.data() ? "\n        {\"id\": " : ",\n        {\"id\": ";
            appendValue(m_text, row.id);
            open(" ");
            m_first = false;
            addProperties(&row);
            addUnknown(row.id);
            m_text += '}';
        }
        m_text += "\n      ]";
        open(itemIndent);
        m_first = false;
    }

    const Scene& m_scene;
    std::optional<std::filesystem::path> m_folder; // of the file that this is the text of
    std::array<std::span<const Property>, kindCount> m_properties;
    std::map<Id, std::vector<const UnknownItem*>> m_unknownItems; // not written yet
    std::string m_text;
    std::string_view m_indent; // before the members of the object at hand
    bool m_first = true;
};

} // namespace

std::string sceneText(const Scene& scene) { return SceneWriter(scene).text(); }

std::string sceneText(const Scene& scene, const std::filesystem::path& folder)
{
    return SceneWriter(scene, folder).text();
}

} // namespace ripstop
