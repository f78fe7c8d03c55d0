#include "mesh_reader/process_limits.h"

#include "shapes/mesh_process.h"

#include <algorithm>
#include <csignal>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#ifdef __has_feature // Clang
#define RIPSTOP_HAS_ASAN __has_feature(address_sanitizer)
#else
#define RIPSTOP_HAS_ASAN 0
#endif
#if RIPSTOP_HAS_ASAN || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
// Sanitizers map terabytes of addresses; they bound the memory in use by themselves.
#define RIPSTOP_IS_WATCHED 1
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options()
{
    return "detect_leaks=0:hard_rss_limit_mb=1024:max_allocation_size_mb=1024";
}
extern "C" const char* __tsan_default_options();
extern "C" const char* __tsan_default_options()
{
    return "hard_rss_limit_mb=1024:max_allocation_size_mb=1024";
}
#else
#define RIPSTOP_IS_WATCHED 0
#endif

namespace ripstop {
namespace {

constexpr rlim_t mostHandles = 64;
constexpr rlim_t timeOfDay = 4; // s for each of the processor, which others use as well

// The limit in force; the larger one, up to which it may be raised, stays.
void setLimit(__rlimit_resource which, rlim_t value)
{
    rlimit limit{};
    if (getrlimit(which, &limit) != 0)
        return;
    limit.rlim_cur = std::min(value, limit.rlim_max);
    setrlimit(which, &limit);
}

} // namespace

void limitProcess()
{
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
    setLimit(RLIMIT_FSIZE, 0);
    setLimit(RLIMIT_CORE, 0);
    setLimit(RLIMIT_NOFILE, mostHandles);
    limitProcess(0);
}

void limitProcess(std::uint64_t bytes)
{
    if (!RIPSTOP_IS_WATCHED)
        setLimit(RLIMIT_AS, ReadLimits::memoryAtOnce + bytes * ReadLimits::memoryPerByte);
    const rlim_t seconds = ReadLimits::secondsAtOnce + bytes / ReadLimits::bytesPerSecond;
    setLimit(RLIMIT_CPU, seconds);
    alarm(unsigned(timeOfDay * seconds));
}

} // namespace ripstop
