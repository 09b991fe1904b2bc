// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/layout.hpp"

#include <initializer_list>

namespace psicarve {
namespace {

constexpr std::uint64_t kPageBytes = 4096;

constexpr std::uint64_t round_up_to_page(std::uint64_t bytes) noexcept {
    return (bytes + kPageBytes - 1) / kPageBytes * kPageBytes;
}

/// FNV-1a over whole numbers.
constexpr std::uint64_t hash_numbers(std::uint64_t hash,
                                     std::initializer_list<std::size_t> numbers) noexcept {
    for (const std::size_t number : numbers) hash = (hash ^ number) * 0x100000001b3ULL;
    return hash;
}
constexpr std::uint64_t kHashStart = 0xcbf29ce484222325ULL;

constexpr std::uint64_t job_hash(std::uint64_t hash) noexcept {
    return hash_numbers(hash, {sizeof(JobHeader), offsetof(JobHeader, total_bytes),
                               offsetof(JobHeader, layer_count), offsetof(JobHeader, psi_sweep_pulses),
                               offsetof(JobHeader, joining), offsetof(JobHeader, direction_sign),
                               offsetof(JobHeader, feed_mm_s), offsetof(JobHeader, source_hash),
                               offsetof(JobHeader, source_name), offsetof(JobHeader, profile_offset),
                               offsetof(JobHeader, report_offset), offsetof(JobHeader, heights_offset),
                               offsetof(JobHeader, r_left_offset), offsetof(JobHeader, r_right_offset)});
}

constexpr std::uint64_t status_hash(std::uint64_t hash) noexcept {
    hash = hash_numbers(hash, {sizeof(CoreStatus),
                               sizeof(AlarmRecord),
                               kAxisCount,
                               kAlarmHistory,
                               kLatenessBins,
                               offsetof(AlarmRecord, cause),
                               offsetof(AlarmRecord, expected),
                               offsetof(CoreStatus, heartbeat),
                               offsetof(CoreStatus, state),
                               offsetof(CoreStatus, alarm_cause),
                               offsetof(CoreStatus, homed_mask),
                               offsetof(CoreStatus, position_pulses),
                               offsetof(CoreStatus, emitted_pulses),
                               offsetof(CoreStatus, layer),
                               offsetof(CoreStatus, points_done),
                               offsetof(CoreStatus, job_generation),
                               offsetof(CoreStatus, signals),
                               offsetof(CoreStatus, seconds_left),
                               offsetof(CoreStatus, job_start_tick),
                               offsetof(CoreStatus, missed_ticks),
                               offsetof(CoreStatus, lateness_histogram),
                               offsetof(CoreStatus, alarm_count),
                               offsetof(CoreStatus, alarms),
                               offsetof(CoreStatus, waited_ticks),
                               offsetof(CoreStatus, override_percent),
                               offsetof(CoreStatus, trace_lost),
                               offsetof(CoreStatus, realtime_asked),
                               offsetof(CoreStatus, tick_minor_faults),
                               offsetof(CoreStatus, sim_true_position_pulses),
                               offsetof(CoreStatus, sim_ignored_pulses),
                               offsetof(CoreStatus, sim_timing_lost),
                               offsetof(CoreStatus, sim_stalls)});
    return hash_numbers(
        hash, {sizeof(FlightRecord), offsetof(FlightRecord, kind), offsetof(FlightRecord, code),
               offsetof(FlightRecord, axis), offsetof(FlightRecord, signals), offsetof(FlightRecord, answer),
               offsetof(FlightRecord, value), offsetof(FlightRecord, position_pulses)});
}

constexpr std::uint64_t program_hash(std::uint64_t hash) noexcept {
    return hash_numbers(hash, {sizeof(MotionRecord),
                               offsetof(MotionRecord, program),
                               offsetof(MotionRecord, sequence),
                               offsetof(MotionRecord, line),
                               offsetof(MotionRecord, kind),
                               offsetof(MotionRecord, axes),
                               offsetof(MotionRecord, flags),
                               offsetof(MotionRecord, code),
                               offsetof(MotionRecord, target),
                               offsetof(MotionRecord, seconds),
                               offsetof(MotionRecord, tolerance_mm),
                               offsetof(MotionRecord, centre_mm),
                               offsetof(MotionRecord, check),
                               sizeof(RingRecord),
                               sizeof(RingEnds),
                               offsetof(RingEnds, was_put),
                               offsetof(RingEnds, taken),
                               offsetof(RingEnds, was_taken),
                               sizeof(ProgramControl),
                               offsetof(ProgramControl, claim),
                               offsetof(ProgramControl, claim_start_time),
                               offsetof(ProgramControl, next_claim),
                               offsetof(ProgramControl, asked),
                               offsetof(ProgramControl, closed),
                               offsetof(ProgramControl, running),
                               offsetof(ProgramControl, grant),
                               offsetof(ProgramControl, progress),
                               offsetof(ProgramControl, refusal),
                               offsetof(ProgramControl, status),
                               offsetof(ProgramControl, modes),
                               offsetof(CoreStatus, rapid_override_percent),  // not of the snapshots' hash
                               offsetof(ProgramControl, source),
                               sizeof(ProgramStatus),
                               offsetof(ProgramStatus, sequence),
                               sizeof(ProgramModes),
                               offsetof(ProgramModes, g_codes),
                               offsetof(ProgramModes, zero),
                               offsetof(ProgramModes, end),
                               offsetof(ProgramGrant, program),
                               offsetof(ProgramGrant, first),
                               offsetof(ProgramProgress, taken),
                               offsetof(ProgramProgress, line),
                               offsetof(ProgramProgress, end),
                               offsetof(ProgramProgress, record_sum),
                               sizeof(ProgramSource),
                               offsetof(ProgramSource, text_sum),
                               offsetof(ProgramSource, from_line),
                               offsetof(ProgramSource, flags),
                               offsetof(ProgramSource, start_pulses),
                               offsetof(ProgramSource, kept),
                               offsetof(ProgramSource, name),
                               offsetof(ProgramSource, profile),
                               offsetof(ProgramRefusal, line),
                               offsetof(ProgramRefusal, said)});
}

constexpr std::uint64_t segment_hash(std::uint64_t hash) noexcept {
    hash = hash_numbers(hash, {sizeof(pthread_mutex_t),
                               sizeof(MutexStorage),
                               sizeof(EventWord),
                               sizeof(Publication),
                               offsetof(SlotContent, generation),
                               offsetof(SlotContent, checksum),
                               offsetof(SlotContent, seal),
                               sizeof(JobVerdict),
                               sizeof(CommandSlot),
                               sizeof(Command),
                               sizeof(Answer),
                               sizeof(IncrementEntry),
                               sizeof(IncrementRing),
                               sizeof(FlightRecorder),
                               sizeof(RecordingPiece),
                               sizeof(RecordingRing),
                               offsetof(RecordingPiece, bytes),
                               offsetof(RecordingPiece, data),
                               offsetof(Command, axis),
                               offsetof(Command, value),
                               offsetof(Command, value2),
                               offsetof(Command, speed),
                               offsetof(Command, lease_token),
                               offsetof(Command, target),
                               offsetof(Command, centre),
                               offsetof(Command, shape),
                               offsetof(Answer, message),
                               offsetof(Message, arguments),
                               offsetof(Message, text),
                               offsetof(JobVerdict, accepted),
                               offsetof(JobVerdict, said),
                               offsetof(CommandSlot, sender_start_time),
                               offsetof(CommandSlot, sequence),
                               offsetof(CommandSlot, stops_seen),
                               offsetof(CommandSlot, command),
                               offsetof(CommandSlot, answer),
                               offsetof(IncrementEntry, r1_pulses),
                               offsetof(IncrementEntry, psi_pulses),
                               kCommandKindCount,
                               kMachineStateCount});
    // A byte that was unused before: older snapshots stay readable.
    hash = hash_numbers(hash, {offsetof(CoreStatus, is_left_forecast)});
    return hash_numbers(hash, {sizeof(SegmentHeader),
                               offsetof(SegmentHeader, ready),
                               offsetof(SegmentHeader, total_bytes),
                               offsetof(SegmentHeader, capacity_layers),
                               offsetof(SegmentHeader, capacity_records),
                               offsetof(SegmentHeader, ring_offset),
                               offsetof(SegmentHeader, slot_offset),
                               offsetof(SegmentHeader, slot_bytes),
                               offsetof(SegmentHeader, boot_id),
                               offsetof(SegmentHeader, creator),
                               offsetof(SegmentHeader, core),
                               offsetof(SegmentHeader, core_profile_hash),
                               offsetof(SegmentHeader, stop_requests),
                               offsetof(SegmentHeader, estop_requests),
                               offsetof(SegmentHeader, jog_lease),
                               offsetof(SegmentHeader, recording_lease),
                               offsetof(SegmentHeader, recording_taken),
                               offsetof(SegmentHeader, next_sequence),
                               offsetof(SegmentHeader, job_published),
                               offsetof(SegmentHeader, command_raised),
                               offsetof(SegmentHeader, status_changed),
                               offsetof(SegmentHeader, publication),
                               offsetof(SegmentHeader, mutex),
                               offsetof(SegmentHeader, commands),
                               sizeof(PortName),
                               offsetof(SegmentHeader, port),
                               offsetof(SegmentHeader, verdict),
                               offsetof(SegmentHeader, checkpoint),
                               offsetof(Checkpoint, next_layer),
                               offsetof(Checkpoint, earlier_layer),
                               offsetof(Checkpoint, check),
                               offsetof(SegmentHeader, program),
                               offsetof(SegmentHeader, status),
                               offsetof(SegmentHeader, increments),
                               offsetof(SegmentHeader, recorder),
                               offsetof(SegmentHeader, recording)});
}

}  // namespace

std::uint64_t segment_abi_hash() noexcept {
    return program_hash(segment_hash(status_hash(job_hash(kHashStart))));
}

std::uint64_t snapshot_abi_hash(bool with_status) noexcept {
    return with_status ? status_hash(job_hash(kHashStart)) : job_hash(kHashStart);
}

SegmentGeometry segment_geometry(std::uint32_t capacity_layers, std::uint32_t capacity_points,
                                 std::uint32_t capacity_records) noexcept {
    const std::uint64_t layers = capacity_layers;
    const std::uint64_t table_bytes = layers * capacity_points * sizeof(std::int32_t);
    // Each of the six parts after the header may need up to 7 bytes to reach its multiple of 8.
    const std::uint64_t job_bytes = sizeof(JobHeader) + kJobTextBytes + layers * sizeof(std::int64_t) +
                                    2 * table_bytes + kMaxJobPasses * sizeof(JobPass) +
                                    6 * sizeof(std::uint64_t);
    SegmentGeometry geometry{};
    geometry.slot_bytes = round_up_to_page(job_bytes);
    geometry.ring_offset = round_up_to_page(sizeof(SegmentHeader));
    geometry.mapped_bytes = geometry.ring_offset + round_up_to_page(capacity_records * sizeof(RingRecord));
    geometry.slot_offset[0] = geometry.mapped_bytes;
    geometry.slot_offset[1] = geometry.slot_offset[0] + geometry.slot_bytes;
    geometry.total_bytes = geometry.slot_offset[1] + geometry.slot_bytes;
    return geometry;
}

}  // namespace psicarve
