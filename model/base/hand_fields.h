// The fields of what hands do (hands.h), said once; see fields.h.
//
// The bytes of a State need them, since hands are part of it (system/fields.h), and so does the
// recording of what hands were told (io/hand_rows.cpp). A field that is added to one of these
// structs needs its place in the list; without it nothing compiles.
#pragma once

#include "base/fields.h"
#include "base/hands.h"

namespace ripstop {

template <>
inline constexpr auto fieldsOf<Grip> = fields<Grip, &Grip::particle, &Grip::share>;

template <>
inline constexpr auto fieldsOf<HandPull> =
    fields<HandPull, &HandPull::grip, &HandPull::to, &HandPull::stiffness, &HandPull::damping,
           &HandPull::most>;

template <>
inline constexpr auto fieldsOf<Airflow> =
    fields<Airflow, &Airflow::kind, &Airflow::velocity, &Airflow::referenceHeight,
           &Airflow::exponent, &Airflow::roughness, &Airflow::origin, &Airflow::radius,
           &Airflow::widening>;

template <>
inline constexpr auto fieldsOf<Carry> = fields<Carry, &Carry::collider, &Carry::way>;

template <>
inline constexpr auto fieldsOf<Hands> =
    fields<Hands, &Hands::pull, &Hands::fan, &Hands::pins, &Hands::carries>;

template <>
inline constexpr auto fieldsOf<Cut::Edge> = fields<Cut::Edge, &Cut::Edge::near, &Cut::Edge::far>;

template <>
inline constexpr auto fieldsOf<Cut> = fields<Cut, &Cut::edges>;

} // namespace ripstop
