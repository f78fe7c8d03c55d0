// The fields of what a recording keeps beside states (system/fields.h), said once; see
// base/fields.h. Files are made of these (io/recording_file.h): a field that is new is one since a
// version of the file.
#pragma once

#include "base/fields.h"
#include "recording/certificate.h"
#include "recording/recording.h"
#include "recording/run_chunk.h"
#include "system/fields.h"

namespace ripstop {

template <>
inline constexpr auto fieldsOf<HandNote::LetGo> = fields<HandNote::LetGo>;

template <>
inline constexpr auto fieldsOf<HandNote::Pin> =
    fields<HandNote::Pin, &HandNote::Pin::particle, &HandNote::Pin::holds>;

template <>
inline constexpr auto fieldsOf<HandNote::FanOff> = fields<HandNote::FanOff>;

template <>
inline constexpr auto fieldsOf<HandNote::Halt> = fields<HandNote::Halt>;

template <>
inline constexpr auto fieldsOf<DesignChange> = fields<DesignChange, &DesignChange::number>;

template <>
inline constexpr auto fieldsOf<ControlCommand> =
    fields<ControlCommand, &ControlCommand::time, &ControlCommand::control, &ControlCommand::value>;

template <>
inline constexpr auto fieldsOf<RunInput> = fields<RunInput, &RunInput::step, &RunInput::what>;

template <>
inline constexpr auto fieldsOf<RunEvent> =
    fields<RunEvent, &RunEvent::kind, &RunEvent::step, &RunEvent::time, &RunEvent::what,
           &RunEvent::count, field<&RunEvent::with, Since{2}>>;

template <>
inline constexpr auto fieldsOf<KeptFrame> =
    fields<KeptFrame, &KeptFrame::step, &KeptFrame::substep, &KeptFrame::time, &KeptFrame::substeps,
           &KeptFrame::tears, &KeptFrame::broken, &KeptFrame::inputCommand, &KeptFrame::inputValue,
           &KeptFrame::hands, &KeptFrame::carried, &KeptFrame::gusts, &KeptFrame::canopies,
           field<&KeptFrame::work, Since{3}>, &KeptFrame::way, &KeptFrame::velocity,
           &KeptFrame::tension>;

template <>
inline constexpr auto fieldsOf<Broken> =
    fields<Broken, &Broken::springs, &Broken::rods, &Broken::panels>;

template <>
inline constexpr auto fieldsOf<RunChunk> =
    fields<RunChunk, &RunChunk::start, &RunChunk::frames, &RunChunk::broken, &RunChunk::tears>;

template <>
inline constexpr auto fieldsOf<Convergence> =
    fields<Convergence, &Convergence::value, &Convergence::order, &Convergence::limit,
           &Convergence::error, &Convergence::digits>;

template <>
inline constexpr auto fieldsOf<CertifiedProbe> =
    fields<CertifiedProbe, &CertifiedProbe::name, &CertifiedProbe::unit, &CertifiedProbe::ofMean,
           &CertifiedProbe::result, &CertifiedProbe::value, &CertifiedProbe::error>;

template <>
inline constexpr auto fieldsOf<Certificate> =
    fields<Certificate, &Certificate::seconds, &Certificate::time, &Certificate::probes>;

template <>
inline constexpr auto fieldsOf<Bookmark> =
    fields<Bookmark, &Bookmark::step, &Bookmark::time, &Bookmark::name>;

template <>
inline constexpr auto fieldsOf<StoredChunk> =
    fields<StoredChunk, &StoredChunk::firstStep, &StoredChunk::design, &StoredChunk::frameSteps,
           &StoredChunk::frameTimes, &StoredChunk::hashes, &StoredChunk::inputs,
           &StoredChunk::events>;

} // namespace ripstop
