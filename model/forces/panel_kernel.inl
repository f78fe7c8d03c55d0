// Wind on fabric, four panels at a time; see panel_load.h.
//
// With c = (b - a) x (c - a), twice the area long, and r = c.w / c^2, the share of c that is the
// head-on wind, the laws need one division and no unit normal:
//     paper          F = 1/4 rho C |c.w| r c
//     linear normal  F = 1/4 rho C |c| |w| r c
//     blended        |c| |w| becomes (|c| |w|)^2 / (|c| |w| + k |c.w|)
//     skin friction  F = 1/4 rho Cs |c| |t| t,  t = w - r c
// What a panel gets does not depend on the three beside it, so threads may cut the panels anywhere.

struct FourAirs
{
    Mask law;
    Pack coefficient;
    Pack saturation;
    Pack friction;
    Pack porosity;
    bool plain; // as most are: neither blended nor porous nor by table
};

RIPSTOP_INLINE bool isPlain(const MaterialAir& air)
{
    return air.saturation == 0.0 && air.porosity == 0.0 && air.law != AirLaw::LiftDrag;
}

RIPSTOP_INLINE FourAirs fourAirs(const MaterialAir* airs, int i0, int i1, int i2, int i3)
{
    const MaterialAir& a0 = airs[i0];
    if (i0 == i1 && i0 == i2 && i0 == i3) // neighbours mostly share their material
        return {Mask{} + std::int64_t(a0.law), all(a0.normalCoefficient), all(a0.saturation),
                all(a0.skinFriction),          all(a0.porosity),          isPlain(a0)};
    const MaterialAir& a1 = airs[i1];
    const MaterialAir& a2 = airs[i2];
    const MaterialAir& a3 = airs[i3];
    return {Mask{std::int64_t(a0.law), std::int64_t(a1.law), std::int64_t(a2.law),
                 std::int64_t(a3.law)},
            Pack{a0.normalCoefficient, a1.normalCoefficient, a2.normalCoefficient,
                 a3.normalCoefficient},
            Pack{a0.saturation, a1.saturation, a2.saturation, a3.saturation},
            Pack{a0.skinFriction, a1.skinFriction, a2.skinFriction, a3.skinFriction},
            Pack{a0.porosity, a1.porosity, a2.porosity, a3.porosity},
            isPlain(a0) && isPlain(a1) && isPlain(a2) && isPlain(a3)};
}

// What is rare is kept out of line, so that it costs nothing where it is not called.
#define RIPSTOP_RARE __attribute__((noinline))

// Lowers the pace |c| |w| to what is left of it when the law is blended, and of that when the cloth
// is porous.
RIPSTOP_RARE void blendAndLeak(const FourAirs& air, const Pack& through, Pack& pace)
{
    const Pack blend = pace * pace / (pace + air.saturation * magnitude(through));
    pace = ((air.saturation != all(0.0)) & (pace > all(0.0))) ? blend : pace;
    const Pack meets = root(magnitude(through));
    const Pack left = meets / (meets + air.porosity * root(air.coefficient * pace));
    pace = ((air.porosity > all(0.0)) & (through != all(0.0))) ? pace * left * left : pace;
}

// Loads by the formulas above, N; zero where there is no law, no area or no panel any more.
RIPSTOP_INLINE Coordinates panelLoads(const Coordinates& normal, const Coordinates& wind,
                                      const FourAirs& air, Pack quarterDensity)
{
    const Pack square = dot(normal, normal);
    const Pack through = dot(normal, wind);
    const Pack share = through / square;

    const Mask linear = air.law == std::int64_t(AirLaw::LinearNormal);
    Pack pace = magnitude(through);
    if (any(linear))
        pace = linear ? root(square * dot(wind, wind)) : pace;
    if (!air.plain) {
        const FourAirs airs = air;
        const Pack meets = through;
        Pack left = pace;
        blendAndLeak(airs, meets, left);
        pace = left;
    }
    Coordinates load = (quarterDensity * air.coefficient * pace * share) * normal;

    const Mask rough = air.friction > all(0.0);
    if (any(rough)) {
        const Coordinates along = {fused(-share, normal.x, wind.x), fused(-share, normal.y, wind.y),
                                   fused(-share, normal.z, wind.z)};
        const Pack drag = quarterDensity * air.friction * root(square * dot(along, along));
        const Coordinates both = {fused(drag, along.x, load.x), fused(drag, along.y, load.y),
                                  fused(drag, along.z, load.z)};
        load = select(rough, both, load);
    }
    const Mask meetsAir = (air.law != std::int64_t(AirLaw::None)) & (square != all(0.0));
    return select(meetsAir, load, Coordinates{});
}

// Lift and drag by table, one panel at a time, N per 1/4 rho. With s and c the sine and the cosine
// of the angle of attack, force across and along the panel are CD s + CL c and CD c - CL s.
RIPSTOP_INLINE Pack polarLoad(const MaterialAir& air, const Coordinates& normals,
                              const Coordinates& winds, int lane)
{
    const Pack n = {normals.x[lane], normals.y[lane], normals.z[lane], 0.0};
    const Pack w = {winds.x[lane], winds.y[lane], winds.z[lane], 0.0};
    const auto product = [](Pack a, Pack b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    const double square = product(n, n);
    const double speed = __builtin_sqrt(product(w, w));
    if (square == 0.0 || speed == 0.0)
        return Pack{};
    const double size = __builtin_sqrt(square);
    const double through = product(n, w);
    const Pack across = n * all((through < 0.0 ? -1.0 : 1.0) / size);
    const Pack t = w - all(through / square) * n;
    const double slide = __builtin_sqrt(product(t, t));
    const double s = std::min(1.0, std::abs(through) / (size * speed));
    const double c = std::min(1.0, slide / speed);

    const double place = polarCells * s / (1.0 + c); // tan(alpha / 2)
    const int cell = std::min(int(place), polarCells - 1);
    const double share = place - cell;
    const PolarPoint& low = air.polar[std::size_t(cell)];
    const PolarPoint& high = air.polar[std::size_t(cell) + 1];
    const double lift = low.lift + share * (high.lift - low.lift);
    const double drag = low.drag + share * (high.drag - low.drag);

    const double normal = drag * s + lift * c;
    double q = size * speed * speed;
    if (air.porosity > 0.0 && normal > 0.0) {
        const double left = s / (s + air.porosity * __builtin_sqrt(normal));
        q *= left * left;
    }
    Pack load = all(q * normal) * across;
    if (slide > 0.0)
        load += all(q * (drag * c - lift * s) / slide) * t;
    const double power = product(load, w); // what rounding leaves below zero is taken out
    return power < 0.0 ? Pack(load - all(power / (speed * speed)) * w) : load;
}

RIPSTOP_RARE void localWinds(const PanelWork& work, const std::size_t (&panel)[4],
                             Coordinates& wind)
{
    for (int lane = 0; lane < 4; ++lane) {
        const auto [a, b, c] = work.panels[panel[lane]].corner;
        const PaddedVec3* x = work.position;
        const Pack middle = (pack(x[a]) + pack(x[b]) + pack(x[c])) * all(1.0 / 3.0);
        const Vec3 local = localWind(*work.system, *work.state, {middle[0], middle[1], middle[2]});
        wind.x[lane] = local.x();
        wind.y[lane] = local.y();
        wind.z[lane] = local.z();
    }
}

RIPSTOP_RARE void addPolarLoads(const PanelWork& work, const std::size_t (&panel)[4],
                                const Mask& byTable, const Coordinates& normal,
                                const Coordinates& wind)
{
    for (int lane = 0; lane < 4; ++lane) {
        const std::size_t i = panel[lane];
        const bool again = lane > 0 && i == panel[lane - 1]; // it has its load already
        if (byTable[lane] && !again)
            pack(work.load[i]) += all(0.25 * work.airDensity)
                                  * polarLoad(work.airs[work.panels[i].air], normal, wind, lane);
    }
}

RIPSTOP_INLINE void fillFour(const PanelWork& work, std::size_t i0, std::size_t i1, std::size_t i2,
                             std::size_t i3)
{
    const FabricPanel& p0 = work.panels[i0];
    const FabricPanel& p1 = work.panels[i1];
    const FabricPanel& p2 = work.panels[i2];
    const FabricPanel& p3 = work.panels[i3];
    const auto [a0, b0, c0] = p0.corner;
    const auto [a1, b1, c1] = p1.corner;
    const auto [a2, b2, c2] = p2.corner;
    const auto [a3, b3, c3] = p3.corner;

    const PaddedVec3* x = work.position;
    const Pack from0 = pack(x[a0]), from1 = pack(x[a1]);
    const Pack from2 = pack(x[a2]), from3 = pack(x[a3]);
    const Coordinates ab = coordinates(pack(x[b0]) - from0, pack(x[b1]) - from1,
                                       pack(x[b2]) - from2, pack(x[b3]) - from3);
    const Coordinates ac = coordinates(pack(x[c0]) - from0, pack(x[c1]) - from1,
                                       pack(x[c2]) - from2, pack(x[c3]) - from3);

    const PaddedVec3* v = work.velocity;
    const Coordinates sum = coordinates(
        pack(v[a0]) + pack(v[b0]) + pack(v[c0]), pack(v[a1]) + pack(v[b1]) + pack(v[c1]),
        pack(v[a2]) + pack(v[b2]) + pack(v[c2]), pack(v[a3]) + pack(v[b3]) + pack(v[c3]));
    const Pack third = all(-1.0 / 3.0);
    Coordinates wind = {fused(sum.x, third, all(work.wind.x())),
                        fused(sum.y, third, all(work.wind.y())),
                        fused(sum.z, third, all(work.wind.z()))};
    const std::size_t panel[4] = {i0, i1, i2, i3};
    if (work.system) {
        Coordinates local;
        localWinds(work, panel, local);
        wind = {wind.x + local.x, wind.y + local.y, wind.z + local.z};
    }

    const Coordinates normal = cross(ab, ac);
    if (work.nudge != 0.0) {
        const Pack size = root(dot(normal, normal));
        const Pack share = size > all(0.0) ? all(work.nudge) / size : all(0.0);
        wind = {wind.x + share * normal.x, wind.y + share * normal.y, wind.z + share * normal.z};
    }

    FourAirs air = fourAirs(work.airs, p0.air, p1.air, p2.air, p3.air);
    const std::uint8_t g0 = work.gone[i0], g1 = work.gone[i1];
    const std::uint8_t g2 = work.gone[i2], g3 = work.gone[i3];
    if (g0 | g1 | g2 | g3)
        air.law = Mask{g0, g1, g2, g3} == 0 ? air.law : Mask{} + std::int64_t(AirLaw::None);
    const Mask byTable = air.law == std::int64_t(AirLaw::LiftDrag);
    const bool someByTable = !air.plain && any(byTable);
    if (someByTable)
        air.coefficient = byTable ? all(0.0) : air.coefficient;

    const Pack quarterDensity = all(0.25 * work.airDensity);
    store(panelLoads(normal, wind, air, quarterDensity), work.load[i0], work.load[i1],
          work.load[i2], work.load[i3]);
    if (someByTable) {
        const Coordinates normals = normal, winds = wind;
        const Mask lanes = byTable;
        addPolarLoads(work, panel, lanes, normals, winds);
    }
}

void fillPanels(const PanelWork& work, std::size_t first, std::size_t last)
{
    std::size_t i = first;
    for (; i + 4 <= last; i += 4)
        fillFour(work, i, i + 1, i + 2, i + 3);
    if (i < last) // the last panel is repeated, and its load written again
        fillFour(work, i, std::min(i + 1, last - 1), std::min(i + 2, last - 1), last - 1);
}

#undef RIPSTOP_RARE
