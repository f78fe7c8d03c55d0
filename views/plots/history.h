// What the probes have read since the run began.
//
// Memory is bounded: when `most` samples are held, seven minutes at 240 steps a second, every
// second one is dropped and from then on only every second one is taken, and so on; sooner where
// there are many probes. A long run is kept whole, in coarser steps; its recording has all of it.
#pragma once

#include "simulation/frame.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ripstop {

class History
{
public:
    explicit History(std::size_t most = 100'000)
        : m_most(most)
    {}

    // What was higher within a time step takes the place of what it ended with, so that a picture
    // shows each blow. Frames of one run come in order of time; one of another run starts over. A
    // probe that was added in the middle of the run has read nothing (NaN) before.
    void add(const Frame& frame);
    void add(const ProbeSample& sample);      // between two frames
    void clear();                             // forgets what was until now; the run goes on
    void setTears(std::vector<double> times); // s, ascending; samples do not bring them

    // What a probe would have read, as its recording has it (recording/probe_past.h): fills its
    // samples before the first that it has, straight between the frames.
    void fillPast(const Layout::Probe& probe, std::span<const double> time,
                  std::span<const double> value);

    // Whether there are samples of the run before the probe was read, or of a run without it.
    bool lacksPast(std::uint32_t probe) const;
    std::optional<double> joined(std::uint32_t probe) const; // s, when it was first read then

    std::span<const double> time() const { return m_time; }      // [samples] s, ascending
    std::span<const double> valuesOf(std::uint32_t probe) const; // [samples]; empty when unknown
    std::span<const double> tears() const { return m_tears; }    // s, ascending

    // The sample nearest to that time, s; only when there are any.
    std::size_t nearest(double time) const;

    std::uint64_t run() const { return m_run; } // that the samples are of
    const std::shared_ptr<const Layout>& layout() const
    {
        return m_layout;
    } // of the newest; null: none

    // Grows whenever samples other than the newest have changed.
    int revision() const { return m_revision; }

private:
    struct Column
    {
        std::uint32_t probe;
        std::string unit;
        std::vector<double> values;        // [samples]
        std::optional<double> joined = {}; // s, where the run had begun without it
    };

    void take(std::uint64_t run, const std::shared_ptr<const Layout>& layout, double time,
              const std::vector<double>& probe);
    void startOver(std::uint64_t run);
    void matchColumns(const Layout& layout, double time);
    void thin();

    std::size_t m_most;
    std::uint64_t m_run = 0;
    std::shared_ptr<const Layout> m_layout;
    std::vector<double> m_time;
    std::vector<Column> m_columns; // in the order of m_layout->probes
    std::vector<double> m_tears;
    double m_since = 0.0;     // s; tears before are forgotten
    std::size_t m_stride = 1; // of what is given, for each sample that is kept
    std::size_t m_passed = 0; // given so far
    int m_revision = 0;
};

// A run that is over, kept for comparison.
struct EarlierRun
{
    QString name;
    std::shared_ptr<const History> history;
};

} // namespace ripstop
