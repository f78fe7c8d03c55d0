// The law of cloth, four pieces at a time; see cloth_law.h and cloth_pack.h. Nothing is fused.
//
// A taut cloth is one product. Where a component pushes, Wrinkles looks for the direction that
// pulls: along (1, u) in the plane, u being its slope, the function (t.e.t) / sqrt(D(t)) does not
// depend on the length of t and has its greatest value where a quartic in u is 0. Both ends of the
// quarter turn are looked at alike: from the warp u counts from it, from the weft its inverse does.
// Which way the threads shear only mirrors the direction. What a lane gets does not depend on the
// others: it stands still once it has found its place.

RIPSTOP_INLINE Pack product(const Coordinates& a, const Coordinates& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

RIPSTOP_INLINE Coordinates tautTension(const ClothLawPack& law, const Coordinates& strain)
{
    return {law.warp * strain.x + law.coupling * strain.y,
            law.coupling * strain.x + law.weft * strain.y, law.shear * strain.z};
}

// The strain that threads have where the tension is this one.
RIPSTOP_INLINE Coordinates strainOf(const ClothLawPack& law, const Coordinates& tension)
{
    return {law.alongWarp * tension.x + law.across * tension.y,
            law.across * tension.x + law.alongWeft * tension.y, law.ofShear * tension.z};
}

RIPSTOP_INLINE Mask pushesNowhere(const Coordinates& tension)
{
    return (tension.x >= all(0.0)) & (tension.y >= all(0.0))
           & (tension.x * tension.y >= tension.z * tension.z);
}

// Four times the place of a peak, where there is one.
struct Peak
{
    Mask isThere;
    Pack u;
};

// Tension along t = (1, u) alone, u counted from one of the axes: D(t) is
// first + both u^2 + second u^4.
struct Wrinkles
{
    Pack own;    // 1, the strain along this axis
    Pack other;  // 1, along the other
    Pack shear;  // 1, not negative
    Pack first;  // m/N
    Pack second; // m/N
    Pack both;   // m/N
    Pack slope0, slope1, slope3, slope4; // of 1, u, u^3, u^4

    RIPSTOP_INLINE Wrinkles(Pack e1, Pack e2, Pack g, Pack c1, Pack c2, Pack c12)
        : own(e1)
        , other(e2)
        , shear(g)
        , first(c1)
        , second(c2)
        , both(c12)
        , slope0(g * c1)
        , slope1(all(2.0) * e2 * c1 - e1 * c12)
        , slope3(e2 * c12 - all(2.0) * e1 * c2)
        , slope4(-g * c2)
    {}

    RIPSTOP_INLINE Pack strain(Pack u) const { return own + u * (shear + u * other); }
    RIPSTOP_INLINE Pack compliance(Pack u) const { return first + u * u * (both + u * u * second); }

    // The square of what is to be greatest; 0 where t does not pull.
    RIPSTOP_INLINE Pack pull(const Peak& peak) const
    {
        const Pack along = strain(peak.u);
        return (peak.isThere & (along > all(0.0))) ? along * along / compliance(peak.u) : all(0.0);
    }

    // Positive where the pull grows with u.
    RIPSTOP_INLINE Pack slope(Pack u) const
    {
        return slope0 + u * (slope1 + u * u * (slope3 + u * slope4));
    }
    RIPSTOP_INLINE Pack riseOfSlope(Pack u) const
    {
        return slope1 + u * u * (all(3.0) * slope3 + all(4.0) * u * slope4);
    }

    // Whether there may be three places where the pull neither grows nor falls, a peak near each
    // axis and a valley in between, as the signs of the slope tell (Descartes). There is one
    // otherwise. From both axes the answer is the same.
    RIPSTOP_INLINE Mask mayHaveTwoPeaks() const
    {
        return (slope1 < all(0.0)) & (slope3 > all(0.0));
    }
};

constexpr int mostSteps = 60;
constexpr double nearEnough = 1e-7; // each step squares the error that the last one left

// Of two peaks that of this axis. The slope bends upwards as u leaves the axis, so that Newton's
// method comes to its first root from below and never passes it; where it leads out of that bend,
// there is none in it.
RIPSTOP_INLINE Peak peakAtAxis(const Wrinkles& at, Mask where)
{
    Peak peak{Mask{}, all(0.0)};
    for (int i = 0; i < mostSteps && any(where); ++i) {
        const Pack rise = at.riseOfSlope(peak.u);
        where &= (rise < all(0.0)) & (at.slope3 + all(2.0) * peak.u * at.slope4 >= all(0.0));
        const Pack way = at.slope(peak.u) / rise;
        peak.u = where ? peak.u - way : peak.u;
        const Mask goesOn = magnitude(way) > all(nearEnough) * peak.u;
        peak.isThere |= where & ~goesOn;
        where &= goesOn;
    }
    return peak;
}

// The only one for 0 <= u <= 1: Newton's method between two places; where it leaves them, they are
// halved. It begins where the slope would be 0 if it were straight: of cloth that pushes across its
// pull it is nearly so. The upper place is well above 1, where the peak of cloth in pure shear is,
// so that Newton's steps may come from there.
RIPSTOP_INLINE Pack onlyPeak(const Wrinkles& at, Mask where)
{
    Pack low = all(0.0), high = all(2.0);
    Pack u = at.slope0 < -at.slope1 ? -at.slope0 / at.slope1 : all(0.5);
    for (int i = 0; i < mostSteps && any(where); ++i) {
        const Pack value = at.slope(u);
        const Mask isBelow = value > all(0.0);
        low = isBelow ? u : low;
        high = isBelow ? high : u;
        Pack next = u - value / at.riseOfSlope(u);
        next = ((next >= low) & (next <= high)) ? next : all(0.5) * (low + high);
        const Pack way = magnitude(next - u);
        u = where ? next : u;
        where &= way > all(nearEnough) * u;
    }
    return u;
}

RIPSTOP_INLINE Wrinkles select(Mask m, const Wrinkles& a, const Wrinkles& b)
{
    Wrinkles r = a;
    r.own = m ? a.own : b.own;
    r.other = m ? a.other : b.other;
    r.first = m ? a.first : b.first;
    r.second = m ? a.second : b.second;
    r.slope0 = m ? a.slope0 : b.slope0;
    r.slope1 = m ? a.slope1 : b.slope1;
    r.slope3 = m ? a.slope3 : b.slope3;
    r.slope4 = m ? a.slope4 : b.slope4;
    return r;
}

// Fills in the lanes of cloth that is not taut. Along t it has the tension r (1, u^2, u),
// r = e / D; its derivatives are those where the energy does not change with u.
RIPSTOP_INLINE void addWrinkled(const ClothLawPack& law, const Coordinates& strain, Mask where,
                                ClothTensionPack& now)
{
    const Mask isMirrored = strain.z < all(0.0);
    const Pack sign = isMirrored ? all(-1.0) : all(1.0);
    const Pack g = sign * strain.z;
    const Pack both = all(2.0) * law.across + law.ofShear;
    const Wrinkles fromWarp(strain.x, strain.y, g, law.alongWarp, law.alongWeft, both);
    const Wrinkles fromWeft(strain.y, strain.x, g, law.alongWeft, law.alongWarp, both);
    Peak warpPeak{Mask{}, all(0.0)}, weftPeak{Mask{}, all(0.0)};
    const Mask mayBeTwo = where & fromWarp.mayHaveTwoPeaks();
    if (any(mayBeTwo)) {
        warpPeak = peakAtAxis(fromWarp, mayBeTwo);
        weftPeak = peakAtAxis(fromWeft, mayBeTwo);
    }
    const Mask isOne = where & ~(warpPeak.isThere | weftPeak.isThere);
    if (any(isOne)) {
        const Mask grows = fromWarp.slope(all(1.0)) > all(0.0);
        const Pack u = onlyPeak(select(grows, fromWeft, fromWarp), isOne);
        weftPeak.u = (isOne & grows) ? u : weftPeak.u;
        warpPeak.u = (isOne & ~grows) ? u : warpPeak.u;
        weftPeak.isThere |= isOne & grows;
        warpPeak.isThere |= isOne & ~grows;
    }
    const Pack warpPull = fromWarp.pull(warpPeak), weftPull = fromWeft.pull(weftPeak);
    const Mask isFromWarp = warpPull >= weftPull;
    now.isWrinkled = where & (greater(warpPull, weftPull) > all(0.0));

    const Wrinkles pull = select(isFromWarp, fromWarp, fromWeft);
    const Pack u = isFromWarp ? warpPeak.u : weftPeak.u;
    const Pack compliance = pull.compliance(u);
    const Pack stiffness = all(1.0) / compliance;
    const Pack along = pull.strain(u);
    const Pack r = along / compliance;
    const Pack slope = u * (all(2.0) * both + all(4.0) * u * u * pull.second); // of D
    const Pack bend = all(2.0) * both + all(12.0) * u * u * pull.second;
    const Pack turned = all(-0.5) * r * slope * stiffness; // r' where the energy is stationary
    const Pack curvature = r
                           * (all(2.0) * pull.other - all(0.5) * turned * slope
                              - all(0.5) * r * bend); // of the energy
    // Of t = (1, u^2, u) and of its turn.
    const Pack square = u * u;
    const Pack turn0 = turned, turn1 = turned * square + r * (all(2.0) * u),
               turn2 = turned * u + r;
    const Pack back = curvature < all(0.0) ? all(1.0) / curvature : all(0.0);
    const Pack back0 = back * turn0, back1 = back * turn1;
    const Pack s00 = stiffness - back0 * turn0;
    const Pack s11 = stiffness * square * square - back1 * turn1;
    const Pack s22 = stiffness * u * u - back * turn2 * turn2;
    const Pack s01 = stiffness * square - back0 * turn1;
    const Pack s02 = sign * (stiffness * u - back0 * turn2);
    const Pack s12 = sign * (stiffness * square * u - back1 * turn2);

    const Mask takes = now.isWrinkled;
    const Mask w = takes & isFromWarp;
    const auto put = [&](Pack& into, Pack fromWarps, Pack fromWefts) {
        into = where ? (takes ? (w ? fromWarps : fromWefts) : all(0.0)) : into;
    };
    put(now.tension.x, r, r * square);
    put(now.tension.y, r * square, r);
    put(now.tension.z, sign * (r * u), sign * (r * u));
    put(now.stiffness.warp, s00, s11);
    put(now.stiffness.weft, s11, s00);
    put(now.stiffness.shear, s22, s22);
    put(now.stiffness.warpWeft, s01, s01);
    put(now.stiffness.warpShear, s02, s12);
    put(now.stiffness.weftShear, s12, s02);
    put(now.energy, all(0.5) * along * r, all(0.5) * along * r);
}

// What is below the tension of buckled cloth counts from there.
RIPSTOP_INLINE Coordinates buckled(const ClothLawPack& law, const Coordinates& tension)
{
    return {tension.x + law.bucklingLoad, tension.y + law.bucklingLoad, tension.z};
}

// Fills in the lanes of cloth that is not taut. With n = N (1, 1, 0) and its strain c = C^-1 n,
// what is to be least, Q(e + P) + n . P, is Q(e + c + P) - n . e - n . c / 2.
RIPSTOP_INLINE void addBuckled(const ClothLawPack& law, const Coordinates& strain, Mask where,
                               ClothTensionPack& now)
{
    const Pack load = law.bucklingLoad;
    const Coordinates more = strainOf(law, {load, load, Pack{}});
    addWrinkled(law, strain + more, where, now);
    now.tension.x = where ? now.tension.x - load : now.tension.x;
    now.tension.y = where ? now.tension.y - load : now.tension.y;
    const Pack taken = load * (strain.x + strain.y + all(0.5) * (more.x + more.y));
    now.energy = where ? now.energy - taken : now.energy;
}

RIPSTOP_INLINE ClothTensionPack tensionOf(const ClothLawPack& law, const Coordinates& strain)
{
    ClothTensionPack now;
    now.tension = tautTension(law, strain);
    now.isTaut = (law.pushes != 0) | pushesNowhere(buckled(law, now.tension));
    now.isWrinkled = Mask{};
    now.stiffness = {law.warp, law.weft, law.shear, law.coupling, Pack{}, Pack{}};
    now.energy = all(0.5) * product(now.tension, strain);
    if (any(~now.isTaut))
        addBuckled(law, strain, ~now.isTaut, now);
    return now;
}

// What of a strain the threads have; wrinkles take up the rest.
RIPSTOP_INLINE Coordinates pullingStrain(const ClothLawPack& law, const Coordinates& strain)
{
    const ClothTensionPack now = tensionOf(law, strain);
    return select(now.isTaut, strain, strainOf(law, now.tension));
}

// J per m^2 that the energy at a strain is not below: what it pulls along the warp or the weft
// alone.
RIPSTOP_INLINE Pack leastEnergyOf(const ClothLawPack& law, const Coordinates& strain)
{
    const Pack warp = greater(strain.x, all(0.0)), weft = greater(strain.y, all(0.0));
    const Pack pulling = greater(warp * warp / law.alongWarp, weft * weft / law.alongWeft);
    const Pack pushing = product(tautTension(law, strain), strain);
    return all(0.5) * (law.pushes != 0 ? pushing : pulling);
}
