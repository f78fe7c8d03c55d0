// How far the samples of a history may be off, as certificates have it (recording/certificate.h).
//
// A certificate speaks of the run that it was made of and of no other. Runs of one design are the
// same to the last bit, so a run is the certified one for as long as all its probes read what they
// read then. An edit, a control or a hand changes the bits, and the sample after it has no band any
// more; undone or flown again, it has one again. Of several certificates that agree with a run, the
// one that reaches furthest counts.
//
// match() compares only what is new since the last time. Only the window's thread uses it.
#pragma once

#include "plots/history.h"
#include "recording/certificate.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace ripstop {

class ErrorBands
{
public:
    using Certificates = std::vector<std::shared_ptr<const Certificate>>;

    void setCertificates(const Certificates& certificates);
    bool hasCertificates() const { return !m_tracks.empty(); }

    // Compares the samples that the history holds by now. A single sample, as at the start, where
    // all runs are alike, is not taken for agreement.
    void match(const History& history);

    struct Band // around the first samples of the history
    {
        std::span<const double> low; // [samples] in the unit of the probe; not a number: unknown
        std::span<const double> high;
    };
    Band of(std::uint32_t probe) const;                 // empty when nothing is certified
    std::size_t sampleCount() const { return m_shown; } // that have bands

private:
    struct Track // how far a certificate agrees with the history
    {
        std::shared_ptr<const Certificate> certificate;
        std::vector<const CertifiedProbe*> probes =
            {};                 // [probes of the layout], null: not certified
        std::size_t agreed = 0; // samples
        std::size_t next = 0;   // time of the certificate to look at
        bool isOver = false;
    };
    struct Column
    {
        std::uint32_t probe;
        std::vector<double> low; // [samples that have bands]
        std::vector<double> high;
    };

    void startOver(const History& history);
    static void follow(Track& track, const History& history);
    void extend(const Track& track, const History& history);

    std::vector<Track> m_tracks;
    std::vector<Column> m_columns;
    const Track* m_best = nullptr; // of m_tracks
    std::size_t m_shown = 0;
    const History* m_seen = nullptr; // that was compared last, as it was then:
    std::shared_ptr<const Layout> m_layout;
    std::uint64_t m_run = 0;
    int m_revision = 0;
};

} // namespace ripstop
