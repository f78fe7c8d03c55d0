// Includes the kernel RIPSTOP_KERNEL twice: in namespace `anywhere` for every machine, and in
// `wide` for those with AVX2 and FMA. It has no include guard: each kernel's source uses it once.
#include "parallel/simd_pack.h"

#define RIPSTOP_WIDE 0

namespace ripstop::anywhere {
namespace {
#include "parallel/simd_pack_kernel.inl"
#include RIPSTOP_KERNEL
} // namespace
} // namespace ripstop::anywhere

#undef RIPSTOP_WIDE
#define RIPSTOP_WIDE 1
#if RIPSTOP_HAS_WIDE
#pragma GCC push_options
#pragma GCC target("avx2,fma")
namespace ripstop::wide {
namespace {
#include "parallel/simd_pack_kernel.inl"
#include RIPSTOP_KERNEL
} // namespace
} // namespace ripstop::wide
#pragma GCC pop_options
#else
namespace ripstop {
namespace wide = anywhere;
}
#endif
#undef RIPSTOP_WIDE
