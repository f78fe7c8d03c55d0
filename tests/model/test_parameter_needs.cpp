// Parameters of builders that count beside others only (ParameterNeed): what the table says is held
// against what building says. A parameter that changes nothing near its value, by a tenth and a
// fifth of its range up and down or by one and two, does nothing.
#include "builders/builder.h"
#include "registered_test.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ripstop::test_parameter_needs {

namespace {

// The design without what its part notes of how it was built.
std::optional<Scene> built(const Builder& builder, const Parameters& parameters)
{
    Result<Scene> scene = build(builder, parameters);
    if (!scene)
        return std::nullopt;
    for (Entry& entry : scene->items)
        if (auto* part = std::get_if<Part>(&entry.item))
            part->parameters.clear();
    return std::move(*scene);
}

std::vector<double> valuesNear(const Parameter& parameter, double value)
{
    std::vector<double> values;
    for (const double share : {-0.1, 0.1, -0.2, 0.2}) {
        const double end = share < 0.0 ? parameter.low : parameter.high;
        values.push_back(parameter.whole ? value + std::round(10.0 * share)
                                         : value + std::abs(share) * (end - value));
    }
    std::erase_if(values, [&](double one) {
        return one == value || one < parameter.low || one > parameter.high;
    });
    return values;
}

// Nothing where no other value can be built.
std::optional<bool> changesSomething(const Builder& builder, const Parameter& parameter,
                                     const Parameters& values, const Scene& scene)
{
    const std::string key(parameter.key);
    std::optional<bool> changes;
    for (const double value : valuesNear(parameter, values.at(key))) {
        Parameters others = values;
        others[key] = value;
        if (const auto other = built(builder, others))
            changes = changes.value_or(false) || !(*other == scene);
    }
    return changes;
}

// A new design, the papers', and each with every switch and choice of the table the other way.
std::vector<Parameters> startsOf(const Builder& builder)
{
    std::vector<Parameters> starts{newDesign(builder, {}), unsaid(builder)};
    for (std::size_t i = 0; i < 2; ++i) {
        for (const auto& [key, value] : unsaid(builder))
            starts[i].try_emplace(key, value);
        for (const Parameter& parameter : builder.parameters) {
            const std::string_view needed = parameter.needs.key;
            if (needed.empty())
                continue;
            const auto row = std::ranges::find(builder.parameters, needed, &Parameter::key);
            Parameters other = starts[i];
            double& value = other[std::string(needed)];
            value = value == 0.0 ? (row->whole ? 1.0 : 0.5 * (row->low + row->high)) : 0.0;
            starts.push_back(std::move(other));
        }
    }
    return starts;
}

} // namespace

class TestParameterNeeds : public QObject
{
    Q_OBJECT

private slots:
    void areWhatBuildingSays_data()
    {
        QTest::addColumn<QString>("name");
        for (const Builder& builder : allBuilders()) {
            const QString name =
                QString::fromUtf8(builder.name.data(), qsizetype(builder.name.size()));
            QTest::newRow(qPrintable(name)) << name;
        }
    }

    // Nothing is called idle that changes the design, in any start; and whatever changes nothing in
    // a new design is called idle.
    void areWhatBuildingSays()
    {
        QFETCH(QString, name);
        const Builder& builder = *findBuilder(name.toStdString());
        bool isNew = true; // the first start is the new design
        for (const Parameters& start : startsOf(builder)) {
            const auto scene = built(builder, start);
            if (!scene)
                continue;
            for (const Parameter& parameter : builder.parameters) {
                const bool says = counts(parameter, builder.parameters, start);
                if (says && !isNew)
                    continue;
                const auto does = changesSomething(builder, parameter, start, *scene);
                QVERIFY2(!does || *does == says,
                         qPrintable(QStringLiteral("%1: the table says %2")
                                        .arg(QString::fromStdString(std::string(parameter.key)))
                                        .arg(says)));
            }
            isNew = false;
        }
    }

    // What is needed is a parameter of the same builder.
    void areOfTheSameBuilder()
    {
        for (const Builder& builder : allBuilders())
            for (const Parameter& parameter : builder.parameters)
                if (const std::string_view key = parameter.needs.key; !key.empty())
                    QVERIFY2(std::ranges::count(builder.parameters, key, &Parameter::key) == 1,
                             std::string(parameter.key).c_str());
    }
};

const RegisteredTest registered("test_parameter_needs", runPlain<TestParameterNeeds>);

} // namespace ripstop::test_parameter_needs
#include "test_parameter_needs.moc"
