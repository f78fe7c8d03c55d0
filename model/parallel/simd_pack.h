// SIMD packs: four numbers in one vector register, for the loops where the time goes.
//
// There is one source for every machine, compiled once for any of them and once for AVX2 with FMA.
// Kernels stand in files of their own, *_kernel.inl, which `parallel/for_each_machine.inl` includes
// once for each way; `wideMachine` says which one to take. Products and sums are fused where the
// source says `fused`, and nowhere else, so that every machine rounds alike. Only the
// rooms that hold such loops include this.
#pragma once

#include "base/vec3.h"

#include <cstdint>
#include <cstdlib>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define RIPSTOP_HAS_WIDE 1
#else
#define RIPSTOP_HAS_WIDE 0
#endif

// For functions outside of kernels that do not use `fused`: GCC compiles them for both kinds of
// machine, and picks one when the program starts.
#if RIPSTOP_HAS_WIDE && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define RIPSTOP_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define RIPSTOP_CLONES
#endif

#define RIPSTOP_INLINE inline __attribute__((always_inline))

namespace ripstop {

// Where machines of any kind hand them to the kernels for wide ones, they lie as these want them.
using Pack = double __attribute__((vector_size(32), aligned(32)));
using Mask =
    std::int64_t __attribute__((vector_size(32), aligned(32))); // all bits of a lane, or none

struct alignas(32) Coordinates // of four vectors
{
    Pack x;
    Pack y;
    Pack z;

    Vec3 of(int lane) const { return {x[lane], y[lane], z[lane]}; }
    void set(int lane, const Vec3& value)
    {
        x[lane] = value[0];
        y[lane] = value[1];
        z[lane] = value[2];
    }
};

// Aligned rows of x, y, z and a zero.
struct alignas(32) Row
{
    double v[4];
};

// Packs go by reference, as functions with and without AVX pass vectors by value in different ways.
RIPSTOP_INLINE Pack& pack(double* p) { return *reinterpret_cast<Pack*>(p); }
RIPSTOP_INLINE const Pack& pack(const double* p) { return *reinterpret_cast<const Pack*>(p); }
RIPSTOP_INLINE Pack& pack(PaddedVec3& v) { return pack(v.data()); }
RIPSTOP_INLINE const Pack& pack(const PaddedVec3& v) { return pack(v.data()); }

// RIPSTOP_PLAIN=1 takes the kernels for any machine, so that both can be compared on one.
#if RIPSTOP_HAS_WIDE
inline const bool wideMachine = [] {
    const char* const plain = std::getenv("RIPSTOP_PLAIN");
    __builtin_cpu_init();
    return !(plain && *plain == '1') && __builtin_cpu_supports("avx2")
           && __builtin_cpu_supports("fma");
}();
#else
inline constexpr bool wideMachine = false;
#endif

} // namespace ripstop
