// Finds the certificate of a scene by flying it three times (recording/certificate.h), two
// runs at a time.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "recording/certificate.h"
#include "scene/scene.h"

#include <functional>
#include <memory>

namespace ripstop {

class Recording;
class Simulation;

// Does to a simulation what a pilot did, called before each step.
using Pilot = std::function<void(Simulation&)>;

struct Certification
{
    Certificate certificate;
    std::shared_ptr<Recording> flown; // the run as it is, with the certificate
    Message stopped; // why one of the runs ended early, so that nothing is certified; or empty
};

// Fails with a sentence where the scene does not compile, has no probes, or when `progress` says
// so. Two runs are flown at a time.
//   threads   of each run, which change nothing of what is found
//   newPilot  called once for each run; empty where nobody flies
Result<Certification> certify(const Scene& scene, double seconds,
                              const std::function<Pilot()>& newPilot, const Progress& progress,
                              int threads = 1);

} // namespace ripstop
