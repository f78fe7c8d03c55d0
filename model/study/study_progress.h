// How far the flights of a study are, in flights, while they are flown. The threads that fly tell
// it and any thread may ask.
#pragma once

#include <atomic>
#include <cstddef>

namespace ripstop {

class StudyProgress
{
public:
    std::size_t planned() const { return m_planned; } // flights, as far as it is known; 0 before
    void plan(std::size_t flights) { m_planned = flights; }

    // What is flown of the flights that are under way: half a flight of 60 s is 30 s of it.
    double underWay() const;

    // A flight that is under way for as long as this lives.
    class Flight
    {
    public:
        Flight(StudyProgress* progress, double seconds); // null where nobody asks
        ~Flight();
        Flight(const Flight&) = delete;
        Flight& operator=(const Flight&) = delete;

        void reached(double time); // s

    private:
        StudyProgress* m_progress;
        double m_seconds; // s, from its start to its end
        double m_share = 0.0;
    };

private:
    std::atomic<std::size_t> m_planned = 0;
    std::atomic<double> m_underWay = 0.0; // flights
};

} // namespace ripstop
