// The places of a run that were nearest to breaking so far, those that are now, and those that
// broke first.
//
// Called after each step, on the thread that steps, and where peaks may lie within a step after
// each substep too; it looks and changes nothing. What has no strength costs it nothing.
#pragma once

#include "laws/load_margin.h"
#include "measure/margins.h"
#include "step/stepper.h"

#include <cstdint>

namespace ripstop {

class LoadWatch final : public SubstepWatch
{
public:
    // A new run, or a moment of another one: nothing is known of what was before it.
    void begin()
    {
        m_ofRun.forget();
        m_firstBreaks.forget();
    }

    // The system was changed in place, maybe in what has a strength or belongs to which line.
    void edited() { m_isKnown = false; }

    // Of the substeps from now on, until look() takes them over: those of a step that fails are
    // nobody's.
    void beginStep() { m_ofStep.forget(); }
    void afterSubstep(const System& system, const State& state, double h,
                      Integrator integrator) override;

    // After each step.
    //   tearsBefore  it, of the state
    void look(const System& system, const State& state, std::size_t tearsBefore);

    // Whether a place has been seen to bear more than ever after this time, s, and how much more it
    // may have borne.
    bool hasPeakAfter(double time) const;
    void noteShortfall(double after, double shortfall) { m_ofRun.noteShortfall(after, shortfall); }

    // Of the instant, without noting it.
    WorstPlaces now(const System& system, const State& state);

    // Of every step since begin(); of a place whose strength, joint or safety factor was changed,
    // of every step since.
    const WorstPlaces& ofRun() const { return m_ofRun; }

    const JudgedPlaces& judged() const { return m_judged; } // at the last look

    const FirstBreaks& firstBreaks() const { return m_firstBreaks; } // since begin()

private:
    void prepare(const System& system, const State& state);
    void judge(const System& system, const State& state);
    void dropOthers(const System& system);

    WorstPlaces m_ofStep; // by substeps
    WorstPlaces m_ofRun;
    FirstBreaks m_firstBreaks;
    bool m_isKnown = false; // what is judged of the system with these serials
    std::uint64_t m_serial = 0;
    std::uint64_t m_valuesSerial = 0;
    JudgedPlaces m_judged;
};

} // namespace ripstop
