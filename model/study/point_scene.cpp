// A text that sets a parameter of a builder is taken apart by setParameterOf(); all others are
// assignments of properties.
#include "study/point_scene.h"

#include "author/rebuild.h"
#include "builders/typed_parameters.h"
#include "scene/path.h"
#include "scene/typed_number.h"

#include <map>
#include <optional>

namespace ripstop {
namespace {

constexpr std::string_view mark = ".built.";

struct BuilderParameter
{
    Id part;
    const Builder* builder;
    const Parameter* parameter;
};

bool setsParameter(const std::string& text) { return text.find(mark) < text.find('='); }

// "kite.built.span"
Result<BuilderParameter> parameterOf(const Scene& scene, const std::string& path)
{
    const std::size_t at = path.find(mark);
    const std::string name = path.substr(0, at);
    const std::string key = path.substr(at + mark.size());
    const auto id = findNamed(scene, Kind::Part, name);
    if (!id)
        return id.failure();
    const auto ref = find(scene, *id);
    const Builder* builder = builderOf(*std::get<const Part*>(*ref));
    if (!builder)
        return Failure("the part \"%1\" was not made by a builder", name);
    const auto parameter = std::ranges::find(builder->parameters, key, &Parameter::key);
    if (parameter != builder->parameters.end())
        return BuilderParameter{*id, builder, &*parameter};
    std::vector<std::string_view> keys;
    for (const Parameter& one : builder->parameters)
        keys.push_back(one.key);
    return Failure("the builder %1 has no parameter \"%2\"; did you mean \"%3\"?", builder->name,
                   key, nearest(key, keys));
}

struct SetParameter
{
    Id part;
    std::string key;
    double value;
};

// "kite.built.span=2.8"
Result<SetParameter> setParameterOf(const Scene& scene, const std::string& text)
{
    const std::size_t equals = text.find('=');
    const auto found = parameterOf(scene, text.substr(0, equals));
    if (!found)
        return found.failure();
    const std::string_view key = found->parameter->key;
    const auto value =
        parameterValue(*found->builder, key, std::string_view(text).substr(equals + 1));
    if (!value)
        return value.failure();
    return SetParameter{found->part, std::string(key), *value};
}

} // namespace

std::string unitOf(const Scene& scene, const std::string& path)
{
    if (setsParameter(path)) {
        const auto found = parameterOf(scene, path);
        return found ? std::string(found->parameter->unit) : std::string();
    }
    const auto place = findPlace(scene, path);
    if (!place || place->targets.empty())
        return {};
    return std::string(unitOf(scene, *place->property, *find(scene, place->targets.front())));
}

std::optional<Failure> checkAssignment(const Scene& scene, const std::string& text)
{
    if (setsParameter(text)) {
        const auto parameter = setParameterOf(scene, text);
        return parameter ? std::nullopt : std::optional(parameter.failure());
    }
    const auto edit = assignment(scene, text);
    return edit ? std::nullopt : std::optional(edit.failure());
}

Result<Scene> sceneWith(const Scene& scene, const std::vector<std::string>& assignments)
{
    Scene made = scene;
    std::map<Id, Parameters> wanted;
    for (const std::string& text : assignments) {
        if (!setsParameter(text))
            continue;
        const auto parameter = setParameterOf(scene, text);
        if (!parameter)
            return Failure("%1: %2", text, parameter.message());
        const auto ref = find(scene, parameter->part);
        const Parameters& kept = std::get<const Part*>(*ref)->parameters;
        wanted.try_emplace(parameter->part, kept).first->second[parameter->key] = parameter->value;
    }
    for (const auto& [part, parameters] : wanted) {
        const auto again = rebuilt(made, part, parameters);
        if (!again)
            return again.failure();
        (void)apply(made, again->edit);
    }
    for (const std::string& text : assignments) {
        if (setsParameter(text))
            continue;
        const auto edit = assignment(made, text);
        if (!edit)
            return Failure("%1: %2", text, edit.message());
        (void)apply(made, *edit);
    }
    return made;
}

} // namespace ripstop
