// A text that sets a parameter of a builder is taken apart by setParameterOf(), one that sets a
// component of a vector by propertyAssignment(); all others are assignments of properties.
#include "study/point_scene.h"

#include "author/rebuild.h"
#include "builders/typed_parameters.h"
#include "derived/thread_fabric.h"
#include "scene/path.h"
#include "scene/typed_number.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <utility>

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
    const std::string_view near = nearest(key, keys);
    if (near.empty())
        return Failure("the builder %1 has no parameter \"%2\"; ripstop-cli builders %3 lists them",
                       builder->name, key, builder->name);
    return Failure("the builder %1 has no parameter \"%2\"; did you mean \"%3\"?", builder->name,
                   key, near);
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

// "wind.velocity.x": one number of a property that has three.
struct Component
{
    Place place;
    int axis;
};

std::optional<Component> componentOf(const Scene& scene, std::string_view path)
{
    constexpr std::string_view axes = "xyz";
    if (path.size() < 3 || path[path.size() - 2] != '.')
        return std::nullopt;
    const std::size_t axis = axes.find(path.back());
    const auto place = findPlace(scene, path.substr(0, path.size() - 2));
    if (axis == std::string_view::npos || !place || place->targets.empty())
        return std::nullopt;
    const auto ref = find(scene, place->targets.front());
    if (!ref || !std::holds_alternative<Vec3>(place->property->get(*ref)))
        return std::nullopt;
    return Component{*place, int(axis)};
}

} // namespace

bool setsControls(const std::string& assignment)
{
    return std::string_view(assignment).substr(0, assignment.find('=')) == controlsPath;
}

Result<Edit> propertyAssignment(const Scene& scene, const std::string& text)
{
    const std::size_t equals = text.find('=');
    const auto component = componentOf(scene, std::string_view(text).substr(0, equals));
    if (!component || equals == std::string::npos)
        return assignment(scene, text);
    const auto& [property, targets] = component->place;
    const Typed typed = typedValue(std::string_view(text).substr(equals + 1), property->unit,
                                   ThreeDigits::AreRefused);
    if (!typed.number)
        return Failure("a component of %1 %2", Message::word(property->label), typed.complaint);
    SetValues set{property, targets, {}};
    for (const Id id : targets)
        set.values.push_back(
            changed(property->get(*find(scene, id)), *typed.number, component->axis));
    return Edit{Message("Set %1", Message::word(property->label)), {std::move(set)}};
}

std::string unitOf(const Scene& scene, const std::string& path)
{
    if (const auto component = componentOf(scene, path))
        return std::string(component->place.property->unit);
    if (setsParameter(path)) {
        const auto found = parameterOf(scene, path);
        return found ? std::string(found->parameter->unit) : std::string();
    }
    const auto place = findPlace(scene, path);
    if (!place || place->targets.empty())
        return {};
    return std::string(unitOf(scene, *place->property, *find(scene, place->targets.front())));
}

std::vector<std::string> idleAmong(const Scene& scene, const std::vector<std::string>& paths)
{
    std::vector<std::string> idle;
    for (const std::string& path : paths) {
        if (!setsParameter(path))
            continue;
        const auto found = parameterOf(scene, path);
        if (!found)
            continue;
        const std::string part = path.substr(0, path.find(mark) + mark.size());
        const std::span<const Parameter> all = found->builder->parameters;
        const auto needsOthers = [&](std::string_view key) { // whether it needs one of the paths
            for (auto one = std::ranges::find(all, key, &Parameter::key);
                 one != all.end() && !one->needs.key.empty();
                 one = std::ranges::find(all, one->needs.key, &Parameter::key))
                if (std::ranges::count(paths, part + std::string(one->needs.key)) > 0)
                    return true;
            return false;
        };
        const auto ref = find(scene, found->part);
        if (!needsOthers(found->parameter->key)
            && !counts(*found->parameter, all, std::get<const Part*>(*ref)->parameters))
            idle.push_back(path);
    }
    return idle;
}

std::optional<Failure> checkAssignment(const Scene& scene, const std::string& text)
{
    if (setsControls(text))
        return std::nullopt;
    if (setsParameter(text)) {
        const auto parameter = setParameterOf(scene, text);
        return parameter ? std::nullopt : std::optional(parameter.failure());
    }
    const auto edit = propertyAssignment(scene, text);
    return edit ? std::nullopt : std::optional(edit.failure());
}

// Makes them in the scene, and tells of each edit.
static std::optional<Failure> assign(Scene& made, const std::vector<std::string>& assignments,
                                     const std::function<void(Edit&)>& told)
{
    std::map<Id, Parameters> wanted;
    for (const std::string& text : assignments) {
        if (!setsParameter(text))
            continue;
        const auto parameter = setParameterOf(made, text);
        if (!parameter)
            return Failure("%1: %2", text, parameter.message());
        const auto ref = find(std::as_const(made), parameter->part);
        const Parameters& kept = std::get<const Part*>(*ref)->parameters;
        wanted.try_emplace(parameter->part, kept).first->second[parameter->key] = parameter->value;
    }
    const auto take = [&](Edit& edit) {
        (void)apply(made, edit);
        told(edit);
    };
    for (const auto& [part, parameters] : wanted) {
        auto again = rebuilt(made, part, parameters);
        if (!again)
            return again.failure();
        take(again->edit);
    }
    for (const std::string& text : assignments) {
        if (setsParameter(text) || setsControls(text))
            continue;
        auto edit = propertyAssignment(made, text);
        if (!edit)
            return Failure("%1: %2", text, edit.message());
        Edit whole = threaded(made, std::move(*edit));
        take(whole);
    }
    return std::nullopt;
}

Result<Scene> sceneWith(const Scene& scene, const std::vector<std::string>& assignments)
{
    Scene made = scene;
    if (const auto failure = assign(made, assignments, [](Edit&) {}))
        return *failure;
    return made;
}

Result<Edit> editWith(const Scene& scene, const std::vector<std::string>& assignments,
                      Message label)
{
    Edit all{std::move(label), {}};
    Scene made = scene; // each edit is of what those before it have made
    const auto failure = assign(made, assignments, [&](Edit& edit) {
        std::ranges::move(edit.changes, std::back_inserter(all.changes));
    });
    if (failure)
        return *failure;
    return all;
}

} // namespace ripstop
