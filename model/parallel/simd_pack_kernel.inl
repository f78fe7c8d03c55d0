// What kernels are made of; see simd_pack.h. for_each_machine.inl includes it once for each way,
// inside the namespace of that way.

RIPSTOP_INLINE Pack all(double x) { return Pack{x, x, x, x}; }

template <int lane>
RIPSTOP_INLINE Pack spread(Pack x)
{
    return __builtin_shufflevector(x, x, lane, lane, lane, lane);
}

RIPSTOP_INLINE Pack fused(Pack a, Pack b, Pack c) // a b + c, rounded once
{
#if RIPSTOP_WIDE
    return __builtin_ia32_vfmaddpd256(a, b, c);
#else
    Pack r;
    for (int i = 0; i < 4; ++i)
        r[i] = __builtin_fma(a[i], b[i], c[i]);
    return r;
#endif
}

RIPSTOP_INLINE Pack root(Pack x)
{
    Pack r;
    for (int i = 0; i < 4; ++i)
        r[i] = __builtin_sqrt(x[i]);
    return r;
}

RIPSTOP_INLINE bool any(Mask m)
{
#if RIPSTOP_WIDE
    return __builtin_ia32_movmskpd256((Pack)m) != 0;
#else
    return (m[0] | m[1] | m[2] | m[3]) != 0;
#endif
}

RIPSTOP_INLINE Pack magnitude(Pack x) { return (Pack)((Mask)x & INT64_MAX); }

RIPSTOP_INLINE Pack lesser(Pack a, Pack b) { return a < b ? a : b; }
RIPSTOP_INLINE Pack greater(Pack a, Pack b) { return a > b ? a : b; }

RIPSTOP_INLINE Coordinates coordinates(Pack v0, Pack v1, Pack v2, Pack v3)
{
    const Pack xz01 = __builtin_shufflevector(v0, v1, 0, 4, 2, 6);
    const Pack xz23 = __builtin_shufflevector(v2, v3, 0, 4, 2, 6);
    const Pack yw01 = __builtin_shufflevector(v0, v1, 1, 5, 3, 7);
    const Pack yw23 = __builtin_shufflevector(v2, v3, 1, 5, 3, 7);
    return {__builtin_shufflevector(xz01, xz23, 0, 1, 4, 5),
            __builtin_shufflevector(yw01, yw23, 0, 1, 4, 5),
            __builtin_shufflevector(xz01, xz23, 2, 3, 6, 7)};
}

RIPSTOP_INLINE Pack dot(const Coordinates& a, const Coordinates& b)
{
    return fused(a.x, b.x, fused(a.y, b.y, a.z * b.z));
}

RIPSTOP_INLINE Coordinates operator*(Pack s, const Coordinates& a)
{
    return {s * a.x, s * a.y, s * a.z};
}

RIPSTOP_INLINE Coordinates operator+(const Coordinates& a, const Coordinates& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

RIPSTOP_INLINE Coordinates operator-(const Coordinates& a, const Coordinates& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

// Nothing is fused here, so that the product of parallel vectors is zero to the last bit.
RIPSTOP_INLINE Coordinates cross(const Coordinates& a, const Coordinates& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

RIPSTOP_INLINE Coordinates select(Mask m, const Coordinates& a, const Coordinates& b)
{
    return {m ? a.x : b.x, m ? a.y : b.y, m ? a.z : b.z};
}

// Stores rows of x, y, z and a zero; the way back from coordinates().
RIPSTOP_INLINE void store(const Coordinates& a, PaddedVec3& v0, PaddedVec3& v1, PaddedVec3& v2,
                          PaddedVec3& v3)
{
    const Pack xy02 = __builtin_shufflevector(a.x, a.y, 0, 4, 2, 6);
    const Pack xy13 = __builtin_shufflevector(a.x, a.y, 1, 5, 3, 7);
    const Pack z02 = __builtin_shufflevector(a.z, Pack{}, 0, 4, 2, 6);
    const Pack z13 = __builtin_shufflevector(a.z, Pack{}, 1, 5, 3, 7);
    pack(v0) = __builtin_shufflevector(xy02, z02, 0, 1, 4, 5);
    pack(v1) = __builtin_shufflevector(xy13, z13, 0, 1, 4, 5);
    pack(v2) = __builtin_shufflevector(xy02, z02, 2, 3, 6, 7);
    pack(v3) = __builtin_shufflevector(xy13, z13, 2, 3, 6, 7);
}
