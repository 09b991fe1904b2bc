// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/interprocess/sync/scoped_lock.hpp>
#include <chrono>
#include <string>

#include "shared/event.hpp"
#include "shared/job.hpp"
#include "shared/robust_mutex.hpp"
#include "shared/segment.hpp"
#include "shared/shared_record.hpp"
#include "shared/shared_text.hpp"

namespace psicarve {
namespace {

namespace bip = boost::interprocess;
using Clock = std::chrono::steady_clock;
using Lock = bip::scoped_lock<RobustMutex>;

/// How often whoever waits for a verdict looks whether the core still lives.
constexpr std::chrono::milliseconds kCoreCheckInterval{100};
/// A copy begins again at most so often when publishers are faster than it.
constexpr int kCopyAttempts = 8;

std::uint32_t slot_of(std::uint64_t generation) noexcept {
    return static_cast<std::uint32_t>(generation % 2);
}

/// Generation 0 means that nothing is published.
std::uint64_t generation_after(std::uint64_t generation) noexcept {
    return generation >= ~std::uint64_t{1} ? 2 - generation % 2 : generation + 1;
}

Error too_large(const Segment& segment, std::uint64_t bytes) {
    return bad_input("the job needs " + std::to_string(bytes) + " bytes, a slot of segment " +
                     segment.name() + " holds " + std::to_string(segment.slot_bytes()) + " (" +
                     std::to_string(segment.capacity_layers()) + " layers x " +
                     std::to_string(segment.capacity_points()) +
                     " points): use a core started with a larger --capacity on another --segment");
}

/// The job of one generation, copied; the caller knows whether that generation stood still meanwhile.
Result<std::vector<std::byte>> copy_slot(Segment& segment, std::uint64_t generation) {
    const SlotContent& content = segment.header().publication.of_slot[slot_of(generation)];
    const std::uint64_t bytes = content.bytes.load(std::memory_order_acquire);
    const std::uint64_t checksum = content.checksum.load(std::memory_order_acquire);
    if (bytes == 0 || bytes > segment.slot_bytes()) {
        return bad_input("the published job says it has " + std::to_string(bytes) + " bytes, a slot holds " +
                         std::to_string(segment.slot_bytes()));
    }
    std::vector<std::byte> blob(bytes);
    if (auto read = segment.read_slot(slot_of(generation), blob); !read) return read.error();
    if (job_checksum(blob) != checksum) {
        return bad_input("the published job is damaged: its checksum is wrong");
    }
    return blob;
}

Result<void> judge(const JobVerdict& verdict, std::uint64_t generation) {
    if (verdict.generation != generation) {
        return Error{ErrorCode::machine_refused,
                     "another job was published before the core looked at this one"};
    }
    if (verdict.accepted == 1) return {};
    const std::string reason = text_from_field(verdict.reason);
    return Error{ErrorCode::machine_refused,
                 reason.empty() ? "the core refused the job without a reason" : reason};
}

/// The generation that the core has in hand; 0: none.
std::uint64_t accepted_generation(const SegmentHeader& header) noexcept {
    const auto status = read_record(header.status);
    return status ? status->job_generation : 0;
}

bool is_refused(const SegmentHeader& header, std::uint64_t generation) noexcept {
    const auto verdict = read_record(header.verdict);
    return verdict && verdict->generation == generation && verdict->accepted != 1;
}

/// The slot of the job that the core accepted is not written to while a refused one stands in the other: a
/// snapshot still needs it. The refused one has been judged, so nobody reads its slot.
std::uint64_t generation_to_publish(const SegmentHeader& header) noexcept {
    const std::uint64_t published = header.publication.generation.load();
    const std::uint64_t accepted = accepted_generation(header);
    const std::uint64_t next = generation_after(published);
    const bool would_overwrite = accepted != 0 && accepted != published && slot_of(next) == slot_of(accepted);
    return would_overwrite && is_refused(header, published) ? generation_after(next) : next;
}

/// While a job runs another would only be refused, and a core started anew would take it for the one to go on
/// with.
Result<void> check_no_job_runs(const Segment& segment) {
    using S = MachineState;
    if (!segment.core_pid()) return {};
    const auto status = read_record(segment.header().status);
    if (!status) return {};
    switch (status->state) {
        case S::positioning:
        case S::waiting:
        case S::carving:
        case S::holding:
        case S::held:
        case S::finishing:
        case S::stopping:
            return Error{ErrorCode::machine_refused, "a job runs (" + std::string{name_of(status->state)} +
                                                         "); stop it or wait for its end"};
        default:
            return {};
    }
}

}  // namespace

Result<std::uint64_t> publish_job(Segment& segment, std::span<const std::byte> job_blob,
                                  std::chrono::milliseconds limit) {
    if (job_blob.empty()) return bad_input("there is no job to publish");
    if (job_blob.size() > segment.slot_bytes()) return too_large(segment, job_blob.size());
    const std::uint64_t checksum = job_checksum(job_blob);

    SegmentHeader& header = segment.header();
    RobustMutex mutex{header.mutex};
    if (auto locked = mutex.lock_within(limit); !locked) return locked.error();
    const Lock lock{mutex, bip::accept_ownership};
    // A publisher that died before us may have left this slot half written: it was not published, and all of
    // it is written anew.
    if (auto free = check_no_job_runs(segment); !free) return free.error();
    const std::uint64_t generation = generation_to_publish(header);
    SlotContent& content = header.publication.of_slot[slot_of(generation)];
    content.bytes.store(0, std::memory_order_release);
    if (auto written = segment.write_slot(slot_of(generation), job_blob); !written) return written.error();
    content.checksum.store(checksum, std::memory_order_release);
    content.bytes.store(job_blob.size(), std::memory_order_release);
    header.publication.generation.store(generation, std::memory_order_release);
    event_signal(header.job_published);
    // The core sleeps on one event only.
    event_signal(header.command_raised);
    return generation;
}

Result<void> wait_for_acceptance(Segment& segment, std::uint64_t generation,
                                 std::chrono::milliseconds limit) {
    SegmentHeader& header = segment.header();
    const Clock::time_point deadline = Clock::now() + limit;
    for (;;) {
        const std::uint32_t seen = event_count(header.status_changed);
        const auto verdict = read_record(header.verdict);
        if (verdict && verdict->generation >= generation) return judge(*verdict, generation);
        if (!segment.core_pid()) {
            return Error{ErrorCode::no_core, "the job is published, but no core serves segment " +
                                                 segment.name() + ": start psicarve-rtcore"};
        }
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
        if (left.count() <= 0) {
            return Error{ErrorCode::timed_out,
                         "the core did not judge the job within " + std::to_string(limit.count()) + " ms"};
        }
        event_wait_past(header.status_changed, seen, std::min(left, kCoreCheckInterval));
    }
}

Result<PublishedJob> copy_current_job(Segment& segment, std::chrono::milliseconds limit) {
    SegmentHeader& header = segment.header();
    RobustMutex mutex{header.mutex};
    if (auto locked = mutex.lock_within(limit); !locked) return locked.error();
    const Lock lock{mutex, bip::accept_ownership};
    const std::uint64_t published = header.publication.generation.load();
    const std::uint64_t accepted = accepted_generation(header);
    std::uint64_t current = published;
    if (accepted != 0 && accepted < published && slot_of(accepted) != slot_of(published)) current = accepted;
    if (current == 0 || (current == published && is_refused(header, published))) return PublishedJob{};
    auto blob = copy_slot(segment, current);
    if (!blob) return blob.error();
    return PublishedJob{.generation = current, .blob = std::move(blob).value()};
}

std::uint64_t published_generation(const Segment& segment) noexcept {
    return segment.header().publication.generation.load(std::memory_order_acquire);
}

std::optional<std::uint64_t> published_checksum(const Segment& segment) noexcept {
    const std::uint64_t generation = published_generation(segment);
    if (generation == 0) return std::nullopt;
    return segment.header().publication.of_slot[slot_of(generation)].checksum.load(std::memory_order_acquire);
}

Result<std::optional<PublishedJob>> take_published_job(Segment& segment, std::uint64_t known_generation) {
    for (int attempt = 0; attempt < kCopyAttempts; ++attempt) {
        const std::uint64_t generation = published_generation(segment);
        if (generation <= known_generation) break;
        auto blob = copy_slot(segment, generation);
        // Writing into this slot begins only after the next generation was published: if ours still is, the
        // copy is of one piece.
        if (published_generation(segment) != generation) continue;
        if (!blob) return blob.error();
        return std::optional{PublishedJob{.generation = generation, .blob = std::move(blob).value()}};
    }
    return std::optional<PublishedJob>{};
}

void acknowledge_job(Segment& segment, std::uint64_t generation, bool accepted, const std::string& reason) {
    JobVerdict verdict{};
    verdict.generation = generation;
    verdict.accepted = accepted ? 1 : 2;
    text_into_field(verdict.reason, reason);
    write_record(segment.header().verdict, verdict);
    event_signal(segment.header().status_changed);
}

std::string job_remark(const Segment& segment) {
    const auto verdict = read_record(segment.header().verdict);
    const bool is_of_it = verdict && verdict->generation == published_generation(segment);
    return is_of_it && verdict->accepted == 1 ? text_from_field(verdict->reason) : std::string{};
}

}  // namespace psicarve
