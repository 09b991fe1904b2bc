// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shared/base/result.hpp"
#include "shared/file/state_place.hpp"
#include "shared/segment/layout.hpp"

namespace psicarve {

inline constexpr const char* kDefaultSegmentName = "/psicarve";

struct SegmentOptions {
    std::string name = kDefaultSegmentName;
    std::uint32_t capacity_layers = kDefaultCapacityLayers;
    std::uint32_t capacity_points = kDefaultCapacityPoints;
    std::uint32_t capacity_records = kDefaultRingRecords;  ///< of the ring of a program
    std::string group;                                     ///< mode 0660 and this group instead of 0600
    /// The name belongs to this program: it replaces an object whose contents are truncated or overwritten.
    bool replaces_damaged = false;
    /// How long another process may take to make the segment.
    std::chrono::milliseconds patience{5000};
};

/// Whether /dev/shm has room for one job of this capacity now: for capacities that a user asks for. A segment
/// is sparse, and can be made without that room.
Result<void> check_shared_memory_for(std::uint32_t capacity_layers, std::uint32_t capacity_points);

/// How long a core that has just got the lock may take to sign: until then the words may name the core before
/// it.
inline constexpr std::chrono::milliseconds kSigningLimit{50};

/// A process holds the core's lock. The lock shows that there is a core; the words say which.
struct CoreGlance {
    std::uint32_t pid;  ///< as the words say; 0: a core that is starting or ending
    bool is_signed;     ///< the pid is of a living process; false: of the core before, or of one that this
                        ///< process cannot see
};

/// The mapped shared-memory object. Move-only; unmaps when destroyed, never removes.
/// Not for the tick. Exceptions of Boost end here.
class Segment {
public:
    /// The first process creates the segment (O_EXCL), later ones attach. A half-made or stale object of a
    /// dead creator is taken over, whatever its version. Refused: garbage, another version in use, another
    /// owner, a wrong size; the error says what is wrong and the remedy.
    static Result<Segment> create_or_attach(const SegmentOptions& options);
    /// ErrorCode::no_core when there is no such object.
    static Result<Segment> attach(const std::string& name, const std::string& group = {});
    /// Attaches whatever its owner, as long as the kernel lets us write it: only for orders to stop, which
    /// must not fail for want of an option.
    static Result<Segment> attach_to_stop(const std::string& name);
    static Result<void> remove(const std::string& name);

    Segment(Segment&&) noexcept;
    Segment& operator=(Segment&&) noexcept;
    ~Segment();

    SegmentHeader& header() noexcept;
    const SegmentHeader& header() const noexcept;
    const std::string& name() const noexcept;
    /// Capacities as checked when attached, never re-read from shared memory.
    std::uint32_t capacity_layers() const noexcept;
    std::uint32_t capacity_points() const noexcept;
    std::uint64_t slot_bytes() const noexcept;
    /// The ring of a program's records, as far as this process has it mapped; see segment_program.hpp.
    RecordRing record_ring() noexcept;
    /// One line that the user should see about the object that was found; else empty.
    const std::string& warning() const noexcept;

    /// False once the name no longer leads to this object (unlinked, replaced), its size shrank or its first
    /// bytes were overwritten. A process that touches a truncated segment is not killed by SIGBUS: it goes on
    /// with zeros of its own (segment_fault_guard.hpp), and this is false from then on.
    bool is_still_linked() const noexcept;
    /// Removes the name of this very object, whatever it contains; leaves the name where it leads elsewhere.
    Result<void> give_up_name();

    // Slots (0 or 1) are read and written through the file descriptor: a full /dev/shm or an object that
    // shrank is then an error message, where a mapped page would be a SIGBUS.
    /// Makes sure that the slot's first `bytes` exist as memory and frees the memory behind them.
    Result<void> reserve_slot(std::uint32_t index, std::uint64_t bytes);
    Result<void> write_slot(std::uint32_t index, std::span<const std::byte> bytes);
    Result<void> read_slot(std::uint32_t index, std::span<std::byte> bytes) const;

    // --- core side
    // -------------------------------------------------------------------------------------------
    /// Makes this process the segment's core, by a lock that dies with the process. Refused with the pid of
    /// the core that holds it. Clears status, verdict, commands and rings that a dead core left; the
    /// published job stays. A child that is forked afterwards must close its copies of our file descriptors,
    /// or the lock lives as long as the child.
    Result<void> claim_core();
    /// The same in two steps, for a core that may still fail to start: from the first on no other process can
    /// claim it, but only the second lets others see a core.
    Result<void> take_core_lock();
    /// Between the two: sets mode 0600, or 0660 and this group, whatever it was before. Refused when another
    /// user's segment has other rights.
    Result<void> fit_rights(const std::string& group);
    /// Gives a segment that is ours and that no core serves to another user, job included; any other stays as
    /// it is. For a core that goes on as that user.
    static Result<void> hand_over(const std::string& name, uid_t user, gid_t group);
    void sign_core() noexcept;
    void release_core() noexcept;
    /// The pid of the living core that serves the segment, else nothing. Asks the lock, not the words. Waits
    /// up to kSigningLimit for one that has got the lock and has not signed.
    std::optional<std::uint32_t> core_pid() const noexcept;
    /// The same for callers that must not wait; nothing when no process holds the lock.
    std::optional<CoreGlance> glance_at_core() const noexcept;
    /// Where the living core keeps its checkpoint; unknown without a core. Does not wait.
    CoreKeeping core_keeping() const noexcept;

    struct Mapping;  ///< segment_mapping.hpp, for the segment's own sources

private:
    explicit Segment(std::unique_ptr<Mapping> mapping) noexcept;
    template <typename Open>
    static Result<Segment> attach_by(const std::string& name, const Open& open);
    std::unique_ptr<Mapping> mapping_;
};

struct PublishedJob {
    std::uint64_t generation;
    std::vector<std::byte> blob;  ///< our own copy, checksum checked
};

// --- publishing (any process but the core)
// ---------------------------------------------------------------------
/// Fills the slot that is not in use, under the mutex, then publishes. Returns the generation.
Result<std::uint64_t> publish_job(Segment& segment, std::span<const std::byte> job_blob,
                                  std::chrono::milliseconds limit = std::chrono::milliseconds{5000});
/// Waits until the core has judged that generation: success, the core's reason (machine_refused), no_core as
/// soon as none serves, or timed_out. A refused job is published no longer: the job accepted before it is.
Result<void> wait_for_acceptance(Segment& segment, std::uint64_t generation, std::chrono::milliseconds limit);
/// Copies the current job, under the mutex: the one that the core accepted, also when another was published
/// and refused since; else the published one, unless it was refused. Generation 0 and no bytes: there is
/// none.
Result<PublishedJob> copy_current_job(Segment& segment, std::chrono::milliseconds limit);

// --- commands (any process but the core)
// -----------------------------------------------------------------------
/// Sends one command and waits for its answer: done, or the core's reason (machine_refused); no_core when
/// none serves. `remark`: what the core adds to "done", mostly nothing.
Result<void> send_command(Segment& segment, const Command& command, std::chrono::milliseconds limit,
                          Message* remark = nullptr);
void request_stop(Segment& segment) noexcept;
void request_emergency_stop(Segment& segment) noexcept;

// --- core side of both
// -------------------------------------------------------------------------------------------
/// A job newer than `known_generation`, copied and checked. Nothing: there is none, or publishers were faster
/// than the copy (ask again). An error: what was published is wrong, or no publisher wrote the generation
/// that the word says (the caller refuses it by acknowledge_job). Takes no lock. A new segment begins again
/// at generation 1.
Result<std::optional<PublishedJob>> take_published_job(Segment& segment, std::uint64_t known_generation);
/// The word alone, which may be damaged.
std::uint64_t published_generation(const Segment& segment) noexcept;
/// Whether a slot holds a publisher's job of this generation; its blob is not looked at.
bool is_published(const Segment& segment, std::uint64_t generation) noexcept;
/// Checksum of the published job's blob, as its publisher said; nothing: there is none.
std::optional<std::uint64_t> published_checksum(const Segment& segment) noexcept;
/// What the core wants to be known of the published job that it has accepted; mostly nothing.
std::vector<Message> job_remarks(const Segment& segment);
/// `said`: why it is refused, or what of an accepted one is to be known; at most kVerdictMessages.
void acknowledge_job(Segment& segment, std::uint64_t generation, bool accepted,
                     const std::vector<Message>& said = {});

/// The segment's words of stop and emergency stop, as read at one time.
struct StopsSeen {
    std::uint32_t stops = 0;
    std::uint32_t emergency_stops = 0;
};
StopsSeen stops_seen(const Segment& segment) noexcept;

struct ReceivedCommand {
    std::uint32_t slot;
    std::uint64_t sequence;
    std::uint32_t sender_pid;
    StopsSeen stops_seen;  ///< by the sender, before the command was pending
    Command command;
};
/// Whether to ask the kernel if the sender of a command still lives, which takes as long as a wake-up, or to
/// trust an answer of a moment ago.
enum class SenderLook : std::uint8_t { asks, trusts };
/// The pending command with the lowest sequence number, marked taken; `asks` also frees slots whose senders
/// died. Nothing in it is checked: kind, axis and values may be anything.
std::optional<ReceivedCommand> take_command(Segment& segment, SenderLook look = SenderLook::asks);
void answer_command(Segment& segment, const ReceivedCommand& command, AnswerKind kind,
                    const Message& message = {});

}  // namespace psicarve
