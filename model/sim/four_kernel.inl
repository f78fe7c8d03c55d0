// What kernels are made of; see four.h. Included once for each way, inside its namespace.

RIPSTOP_INLINE Four all(double x) { return Four{x, x, x, x}; }

template <int lane>
RIPSTOP_INLINE Four spread(Four x)
{
    return __builtin_shufflevector(x, x, lane, lane, lane, lane);
}

RIPSTOP_INLINE Four fused(Four a, Four b, Four c) // a b + c, rounded once
{
#if RIPSTOP_WIDE
    return __builtin_ia32_vfmaddpd256(a, b, c);
#else
    Four r;
    for (int i = 0; i < 4; ++i)
        r[i] = __builtin_fma(a[i], b[i], c[i]);
    return r;
#endif
}

RIPSTOP_INLINE Four root(Four x)
{
    Four r;
    for (int i = 0; i < 4; ++i)
        r[i] = __builtin_sqrt(x[i]);
    return r;
}

struct Coordinates // of four vectors
{
    Four x;
    Four y;
    Four z;
};

RIPSTOP_INLINE Coordinates coordinates(Four v0, Four v1, Four v2, Four v3)
{
    const Four xz01 = __builtin_shufflevector(v0, v1, 0, 4, 2, 6);
    const Four xz23 = __builtin_shufflevector(v2, v3, 0, 4, 2, 6);
    const Four yw01 = __builtin_shufflevector(v0, v1, 1, 5, 3, 7);
    const Four yw23 = __builtin_shufflevector(v2, v3, 1, 5, 3, 7);
    return {__builtin_shufflevector(xz01, xz23, 0, 1, 4, 5),
            __builtin_shufflevector(yw01, yw23, 0, 1, 4, 5),
            __builtin_shufflevector(xz01, xz23, 2, 3, 6, 7)};
}

RIPSTOP_INLINE Four dot(const Coordinates& a, const Coordinates& b)
{
    return fused(a.x, b.x, fused(a.y, b.y, a.z * b.z));
}
