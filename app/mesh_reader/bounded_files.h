// The files that assimp may open: regular ones, to be read. What it has opened says how much memory
// and time it may take.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <cstdint>
#include <set>
#include <string>

namespace ripstop {

class BoundedFiles final : public Assimp::DefaultIOSystem
{
public:
    Assimp::IOStream* Open(const char* file, const char* mode) override; // null when it may not

    bool areTooLarge() const { return m_areTooLarge; } // together

private:
    std::set<std::string> m_opened;
    std::uint64_t m_bytes = 0; // of those
    bool m_areTooLarge = false;
};

} // namespace ripstop
