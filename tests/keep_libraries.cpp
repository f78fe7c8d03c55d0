// Linked into programs under the address sanitizer only. The graphics driver is unloaded before
// leaks are counted, and what it keeps would then look like ours; nothing is unloaded here, so that
// lsan.supp can tell by name.
extern "C" int dlclose(void*) noexcept { return 0; }
