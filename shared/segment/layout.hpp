// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pthread.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "shared/computer/event.hpp"
#include "shared/job/job.hpp"
#include "shared/machine/command.hpp"
#include "shared/machine/program_modes.hpp"
#include "shared/machine/program_status.hpp"
#include "shared/machine/status.hpp"
#include "shared/program/program_source.hpp"
#include "shared/program/record_ring.hpp"
#include "shared/segment/checkpoint.hpp"

namespace psicarve {

// What stands in the shared-memory segment, byte for byte. No pointers, no bool, long or size_t; every word
// that two processes touch is a std::atomic of a lock-free width. A change of any struct here, in status.hpp,
// command.hpp or job.hpp bumps kLayoutVersion; the ABI hash catches whoever forgets.

inline constexpr std::uint64_t kSegmentMagic = 0x3147455341435350ULL;  // "PSCASEG1"
inline constexpr std::uint32_t kLayoutVersion = 18;
/// The first whose CoreStatus and FlightRecord are today's: snapshots of it and all since can be read. Before
/// 10 is_dry had 16 bits: its high byte, always 0, is now is_left_forecast.
inline constexpr std::uint32_t kOldestStatusVersion = 4;
inline constexpr std::uint32_t kSegmentReady = 0x52454459;  // written last by the creator

inline constexpr std::uint32_t kDefaultCapacityLayers = 4000;
inline constexpr std::uint32_t kDefaultCapacityPoints = 3600;
inline constexpr std::uint64_t kJobTextBytes = 64 * 1024;  ///< room for profile and report text in a slot
static_assert(kProfileTextBytes + kReportTextBytes <= kJobTextBytes);
static_assert(kProfileTextBytes == kSourceProfileBytes);
inline constexpr std::size_t kCommandSlots = 64;
inline constexpr std::size_t kIncrementRingEntries = 65536;
inline constexpr std::size_t kFlightRecords = 8192;
inline constexpr std::size_t kRecordingPieces = 8192;
inline constexpr std::size_t kVerdictMessages = 3;

using AtomicWord32 = std::atomic<std::uint32_t>;
using AtomicWord64 = std::atomic<std::uint64_t>;
static_assert(AtomicWord32::is_always_lock_free && AtomicWord64::is_always_lock_free &&
              sizeof(AtomicWord64) == 8);

/// The mutex among publishers and snapshot takers; see robust_mutex.hpp. Never taken by the core.
struct alignas(64) MutexStorage {
    pthread_mutex_t native;
    AtomicWord32 holder_pid;  ///< for messages only
    std::uint32_t reserved;
};

/// What stands in one job slot. Written by a publisher under the mutex, only while the slot is not published.
struct SlotContent {
    AtomicWord64 bytes;       ///< 0 while the slot is written, and once its job was refused
    AtomicWord64 generation;  ///< which it is written for
    AtomicWord64 checksum;    ///< XXH3 over the blob's bytes
    AtomicWord64 seal;        ///< XXH3 over generation, bytes and checksum, as words in this order
};

/// Which job is published. Generation g stands in slot g % 2, so the one store of `generation` publishes
/// slot, size and checksum at once: a publisher that dies before it has changed nothing, after it everything.
/// A word that its slot does not bear out, by generation and seal, was stored by no publisher: it publishes
/// nothing.
struct Publication {
    AtomicWord64 generation;  ///< 0: nothing published; written last, under the mutex
    SlotContent of_slot[2];
};

/// What the core made of a published job. Written by the core alone.
struct JobVerdict {
    std::uint64_t generation;  ///< newest generation it has judged; 0: none
    std::uint32_t accepted;    ///< 1 accepted, 2 refused
    std::uint32_t said_count;
    Message said[kVerdictMessages];  ///< why it is refused, or what of an accepted one is to be known
};
static_assert(sizeof(JobVerdict) == 1192 && std::is_trivially_copyable_v<JobVerdict>, "bump kLayoutVersion");

/// Life of a command slot: free -> writing (a sender claimed it) -> pending -> taken (core) -> answered ->
/// free (sender). A sender that gives up frees a pending slot and leaves a taken one `abandoned`: the core
/// frees that when it answers. A slot whose sender died is freed by the core.
enum class SlotState : std::uint32_t {
    free = 0,
    writing = 1,
    pending = 2,
    taken = 3,
    answered = 4,
    abandoned = 5,
};
struct CommandSlot {
    /// SlotState in the low half, the sender's pid in the high half: claiming a slot and signing it is one
    /// step, so a sender that dies at any instant leaves a slot that can be told to be dead.
    AtomicWord64 state_and_sender;
    AtomicWord64 sender_start_time;  ///< as in ProcessIdentity; 0: not known (yet)
    AtomicWord64 sequence;
    AtomicWord64 stops_seen;  ///< by the sender, before it was pending: StopsSeen, packed
    AtomicWord64 command[sizeof(Command) / 8];
    AtomicWord64 answer[sizeof(Answer) / 8];
};
static_assert(sizeof(Command) % 8 == 0 && sizeof(Answer) % 8 == 0);

/// A value that one process writes and everybody reads whole: odd sequence while being written.
template <typename T>
struct SharedRecord {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % 8 == 0);
    AtomicWord64 sequence;
    AtomicWord64 words[sizeof(T) / 8];
};

/// A ring that one process writes and any number read without a trace; slow readers lose the oldest and know
/// how many.
template <typename T, std::size_t kEntries>
struct SharedRing {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % 8 == 0 && (kEntries & (kEntries - 1)) == 0);
    AtomicWord64 claimed;    ///< entries whose writing has begun, since the segment was made
    AtomicWord64 published;  ///< entries that may be read
    AtomicWord64 first;      ///< entries before this one belong to a core that is no more
    AtomicWord64 words[kEntries][sizeof(T) / 8];
};
/// A piece of a pin trace on its way to the process that asked for it (recording.hpp).
struct RecordingPiece {
    std::uint32_t token;  ///< of the recording it belongs to
    std::uint32_t bytes;  ///< in use; 0: the recording has ended
    std::uint8_t data[248];
};
static_assert(sizeof(RecordingPiece) == 256 && std::is_trivially_copyable_v<RecordingPiece>,
              "bump kLayoutVersion");
using RecordingRing = SharedRing<RecordingPiece, kRecordingPieces>;
using IncrementRing = SharedRing<IncrementEntry, kIncrementRingEntries>;
using FlightRecorder = SharedRing<FlightRecord, kFlightRecords>;

/// Who made the segment and who serves it; process start times (clock ticks since boot, /proc/PID/stat field
/// 22) tell a living process from another that was given its pid.
struct ProcessIdentity {
    AtomicWord64 start_time;
    AtomicWord32 pid;
    AtomicWord32 keeping;  ///< of a core: CoreKeeping, packed (state_place.hpp); 0: not known
};

/// What the core drives, as its --port says it: "sim", "ppdev:/dev/parport0", "io:0x378".
struct PortName {
    char text[64];  ///< zero-terminated; a longer one is cut
};
static_assert(sizeof(PortName) == 64 && std::is_trivially_copyable_v<PortName>, "bump kLayoutVersion");

/// Which program a writer's records are of. Written by the core alone, when it opens one.
struct ProgramGrant {
    std::uint64_t claim;    ///< of the writer that asked for it
    std::uint64_t program;  ///< its number; 0: none was opened yet
    std::uint64_t first;    ///< the ring's index with which both sides begin
};
static_assert(sizeof(ProgramGrant) == 24 && std::is_trivially_copyable_v<ProgramGrant>,
              "bump kLayoutVersion");

/// How far the core has taken a program out of the ring. Written by the core alone.
struct ProgramProgress {
    std::uint64_t program;
    std::uint64_t taken;  ///< sequence of the last record that it took as good
    std::uint64_t line;   ///< of that record
    std::uint32_t end;    ///< ProgramEnd
    std::uint32_t reserved;
    std::uint64_t record_sum;  ///< with_record() over those taken
};
static_assert(sizeof(ProgramProgress) == 40 && std::is_trivially_copyable_v<ProgramProgress>,
              "bump kLayoutVersion");

/// Why no more records are taken. The numbers are part of the segment's layout.
enum class ProgramEnd : std::uint32_t {
    none = 0,     ///< they are
    ended = 1,    ///< the program's end was given
    lost = 2,     ///< who wrote it is gone, or has closed it, without an end
    refused = 3,  ///< a record was wrong: ProgramRefusal says which
};

/// The first record of a program that the core did not take. Written by the core alone.
struct ProgramRefusal {
    std::uint64_t program;  ///< 0: none was refused
    std::uint64_t line;     ///< of that record; of the one before where it cannot be believed
    Message said;
};
static_assert(sizeof(ProgramRefusal) == 408 && std::is_trivially_copyable_v<ProgramRefusal>,
              "bump kLayoutVersion");

/// The program that is being written into the ring, by one process at a time; docs/contract.md tells of each
/// word. The records stand behind the header.
struct ProgramControl {
    RingEnds ends;
    AtomicWord64 claim;  ///< writer's pid in the high half, a number in the low one; 0: none writes
    AtomicWord64 claim_start_time;  ///< as in ProcessIdentity; 0: not known (yet)
    AtomicWord64 next_claim;        ///< by whoever claims, by adding 1
    AtomicWord64 asked;             ///< the claim that waits for a program's number; the core makes it 0
    AtomicWord64 closed;            ///< by the writer: the program of which all is put
    AtomicWord64 running;           ///< by the core: the program whose records it takes; 0: of none
    SharedRecord<ProgramGrant> grant;
    SharedRecord<ProgramProgress> progress;
    SharedRecord<ProgramRefusal> refusal;
    SharedRecord<ProgramStatus> status;  ///< of the program that runs, or ran last: how far the machine is
    SharedRecord<ProgramModes> modes;    ///< by the writer, as it follows the machine
    SharedRecord<ProgramSource> source;  ///< by the writer, before it asks for the start
};

struct SegmentHeader {
    std::uint64_t magic;
    std::uint32_t layout_version;
    AtomicWord32 ready;
    std::uint64_t abi_hash;
    std::uint64_t total_bytes;
    std::uint32_t capacity_layers;
    std::uint32_t capacity_points;
    std::uint32_t capacity_records;  ///< of the ring
    std::uint32_t reserved;
    std::uint64_t ring_offset;  ///< of the ring's records
    std::uint64_t slot_offset[2];
    std::uint64_t slot_bytes;
    char boot_id[40];
    ProcessIdentity creator;
    ProcessIdentity core;            ///< pid 0: no core serves this segment
    AtomicWord64 core_profile_hash;  ///< XXH3 of the core's profile as TOML
    AtomicWord32 stop_requests;      ///< grows by one for each stop; the core acts on any change
    AtomicWord32 estop_requests;
    AtomicWord64 jog_lease;        ///< who keeps a jog going, and a beat (jog_lease.hpp)
    AtomicWord64 recording_lease;  ///< whose recording goes on, and a beat (recording.hpp)
    AtomicWord64 recording_taken;  ///< entries of `recording` that its reader has
    AtomicWord64 next_sequence;
    EventWord job_published;
    EventWord command_raised;  ///< also raised by stop and emergency stop
    EventWord status_changed;
    Publication publication;
    MutexStorage mutex;
    CommandSlot commands[kCommandSlots];
    SharedRecord<PortName> port;  ///< of the core; empty until it has set it
    SharedRecord<JobVerdict> verdict;
    SharedRecord<Checkpoint> checkpoint;  ///< of the core; a new core leaves it as it is
    AtomicWord64 reached_point;           ///< within its next layer (reached_point.hpp); likewise
    ProgramControl program;
    SharedRecord<CoreStatus> status;
    IncrementRing increments;
    FlightRecorder recorder;
    RecordingRing recording;
};
static_assert(std::is_standard_layout_v<SegmentHeader>);

/// A hash over the sizes and offsets of everything above.
std::uint64_t segment_abi_hash() noexcept;
/// The same over what stands in files: the job's header and, when a status or records are in it, theirs. A
/// job file thus outlives changes of the segment.
std::uint64_t snapshot_abi_hash(bool with_status) noexcept;

/// Where everything stands in a segment of this capacity [bytes]. Ring and slots begin at whole pages.
struct SegmentGeometry {
    std::uint64_t ring_offset;
    std::uint64_t mapped_bytes;  ///< header and ring: what a process maps
    std::uint64_t slot_offset[2];
    std::uint64_t slot_bytes;
    std::uint64_t total_bytes;
};
inline constexpr std::uint32_t kMaxCapacityLayers = kMaxJobCount;
inline constexpr std::uint32_t kMaxCapacityPoints = kMaxJobCount;
/// Requires capacities of at least 1 and within kMaxCapacity..., and is_ring_capacity; then nothing
/// overflows.
SegmentGeometry segment_geometry(std::uint32_t capacity_layers, std::uint32_t capacity_points,
                                 std::uint32_t capacity_records = kDefaultRingRecords) noexcept;

}  // namespace psicarve
