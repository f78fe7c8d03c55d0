// take() is the one way in, for frames and for the samples between them: it starts over for another
// run or a time that goes back, matches the columns to the probes of the layout, replaces the
// newest sample when the same instant comes again after an edit, and else keeps every stride-th
// sample. When the bound is reached, thin() drops every second sample and doubles the stride.
// Columns are matched by id and unit, so that a probe that was renamed keeps its past.
#include "plots/history.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ripstop {
namespace {

constexpr std::size_t mostValues = 2'400'000; // of all probes: 60 of them over 10 min at 60 Hz
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

void dropEverySecond(std::vector<double>& values)
{
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values.size(); i += 2)
        values[kept++] = values[i];
    values.resize(kept);
}

} // namespace

void History::add(const Frame& frame)
{
    take(frame.run, frame.layout, frame.time, frame.highest.empty() ? frame.probe : frame.highest);
    m_tears.clear();
    for (const Tear& tear : frame.tears)
        if (tear.time >= m_since)
            m_tears.push_back(tear.time);
}

void History::add(const ProbeSample& sample)
{
    take(sample.run, sample.layout, sample.time, sample.most());
}

void History::take(std::uint64_t run, const std::shared_ptr<const Layout>& layout, double time,
                   const std::vector<double>& probe)
{
    if (run != m_run || (!m_time.empty() && time < m_time.back()))
        startOver(run);
    if (layout != m_layout)
        matchColumns(*layout, time);
    m_layout = layout;

    // the same instant comes again after an edit: what the probes read now replaces the sample
    const bool again = !m_time.empty() && time == m_time.back();
    if (!again && m_passed++ % m_stride != 0)
        return;
    if (again)
        ++m_revision;
    else
        m_time.push_back(time);
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        m_columns[i].values.resize(m_time.size(), missing);
        m_columns[i].values.back() = probe[i];
    }
    if (m_time.size() >= m_most || m_time.size() * m_columns.size() >= mostValues)
        thin();
}

void History::setTears(std::vector<double> times) { m_tears = std::move(times); }

void History::fillPast(const Layout::Probe& probe, std::span<const double> time,
                       std::span<const double> value)
{
    auto column = std::ranges::find(m_columns, probe.id, &Column::probe);
    if (column == m_columns.end()) { // of a run that was over before there was the probe
        m_columns.push_back({probe.id, probe.unit, {}});
        column = m_columns.end() - 1;
    }
    std::vector<double>& values = column->values;
    values.resize(m_time.size(), missing);
    const auto isKnown = [](double one) { return std::isfinite(one); };
    const auto own = std::size_t(std::ranges::find_if(values, isKnown) - values.begin());
    // up to what it reads itself, which may be later than the last frame
    const double end = own < values.size() ? m_time[own] : missing;
    const auto frames = std::size_t(std::ranges::lower_bound(time, end) - time.begin());
    const std::size_t count = std::isnan(end) ? time.size() : frames;
    for (std::size_t i = 0; i < own; ++i) {
        const auto after =
            std::size_t(std::ranges::lower_bound(time.first(count), m_time[i]) - time.begin());
        if (after < count && time[after] == m_time[i]) {
            values[i] = value[after];
            continue;
        }
        const bool isLast = after == count;
        if (after == 0 || (isLast && own == values.size()))
            continue;
        const double to = isLast ? end : time[after];
        const double there = isLast ? values[own] : value[after];
        const double share = (m_time[i] - time[after - 1]) / (to - time[after - 1]);
        values[i] = value[after - 1] + share * (there - value[after - 1]);
    }
    if (std::ranges::any_of(value, isKnown))
        column->joined.reset();
    ++m_revision;
}

std::optional<double> History::joined(std::uint32_t probe) const
{
    const auto column = std::ranges::find(m_columns, probe, &Column::probe);
    return column == m_columns.end() ? std::nullopt : column->joined;
}

bool History::lacksPast(std::uint32_t probe) const
{
    const bool isThere = std::ranges::find(m_columns, probe, &Column::probe) != m_columns.end();
    return m_time.size() > 1 && (!isThere || joined(probe));
}

void History::clear()
{
    m_since = m_time.empty() ? 0.0 : m_time.back();
    m_time.clear();
    m_tears.clear();
    for (Column& column : m_columns) {
        column.values.clear();
        column.joined.reset();
    }
    m_stride = 1;
    m_passed = 0;
    ++m_revision;
}

std::span<const double> History::valuesOf(std::uint32_t probe) const
{
    for (const Column& column : m_columns)
        if (column.probe == probe)
            return column.values;
    return {};
}

std::size_t History::nearest(double time) const
{
    const auto after = std::lower_bound(m_time.begin(), m_time.end(), time);
    if (after == m_time.begin())
        return 0;
    if (after == m_time.end())
        return m_time.size() - 1;
    const auto index = std::size_t(after - m_time.begin());
    return *after - time < time - m_time[index - 1] ? index : index - 1;
}

void History::startOver(std::uint64_t run)
{
    m_run = run;
    m_layout.reset();
    m_columns.clear();
    clear();
    m_since = 0.0;
}

// Columns are matched by id, so that a probe that was renamed keeps its past, and by unit, so that
// a probe that now measures something else does not.
void History::matchColumns(const Layout& layout, double time)
{
    const bool same =
        std::equal(m_columns.begin(), m_columns.end(), layout.probes.begin(), layout.probes.end(),
                   [](const Column& c, const Layout::Probe& probe) {
                       return c.probe == probe.id && c.unit == probe.unit;
                   });
    if (same)
        return;
    std::vector<Column> columns;
    for (const Layout::Probe& probe : layout.probes) {
        const auto old = std::find_if(m_columns.begin(), m_columns.end(), [&](const Column& c) {
            return c.probe == probe.id && c.unit == probe.unit;
        });
        if (old != m_columns.end())
            columns.push_back(std::move(*old));
        else
            columns.push_back({probe.id, probe.unit, std::vector<double>(m_time.size(), missing),
                               m_time.empty() ? std::nullopt : std::optional(time)});
    }
    m_columns = std::move(columns);
    ++m_revision;
}

void History::thin()
{
    dropEverySecond(m_time);
    for (Column& column : m_columns)
        dropEverySecond(column.values);
    m_stride *= 2;
    m_passed = 1; // the last sample may have been dropped; the next is one stride away at most
    ++m_revision;
}

} // namespace ripstop
