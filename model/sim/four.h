// Four doubles that are worked on together.
//
// One source for every machine: the compiler lowers these vectors to whatever there is, and GCC
// picks the widest when the program starts, in functions marked RIPSTOP_CLONES and in what is
// inlined into them. No operation is fused, so that all of them round alike.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)                                \
    && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define RIPSTOP_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define RIPSTOP_CLONES
#endif

#define RIPSTOP_INLINE inline __attribute__((always_inline))

namespace ripstop {

using Four = double __attribute__((vector_size(32)));

// Aligned rows of x, y, z and a zero.
struct alignas(32) Row
{
    double v[4];
};

// By reference: passed by value, vectors would differ between functions with and without AVX.
RIPSTOP_INLINE Four& four(double* p) { return *reinterpret_cast<Four*>(p); }
RIPSTOP_INLINE const Four& four(const double* p) { return *reinterpret_cast<const Four*>(p); }

} // namespace ripstop
