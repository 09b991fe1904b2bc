// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <boost/interprocess/sync/scoped_lock.hpp>
#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shared/base/message_text.hpp"
#include "shared/computer/event.hpp"
#include "shared/job/job.hpp"
#include "shared/machine/message_argument.hpp"
#include "shared/segment/robust_mutex.hpp"
#include "shared/segment/segment.hpp"
#include "shared/segment/shared_record.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve {
namespace {

namespace bip = boost::interprocess;
using Clock = std::chrono::steady_clock;
using Lock = bip::scoped_lock<RobustMutex>;

/// How often a publisher that waits for a verdict checks whether the core still lives.
constexpr std::chrono::milliseconds kCoreCheckInterval{100};
/// How often a copy begins again when publishers are faster than it.
constexpr int kCopyAttempts = 8;

std::uint32_t slot_of(std::uint64_t generation) noexcept {
    return static_cast<std::uint32_t>(generation % 2);
}

/// No publisher reaches it: a greater number is damage, and not to be counted on from.
constexpr std::uint64_t kLastGeneration = std::uint64_t{1} << 62;
/// How long a publisher that was refused waits to take its job back.
constexpr std::chrono::milliseconds kTakeBackLimit{1000};

/// The words of a slot that belong together.
struct SlotLabel {
    std::uint64_t generation;
    std::uint64_t bytes;
    std::uint64_t checksum;
};

std::uint64_t seal_of(const SlotLabel& label) noexcept {
    const std::array words{label.generation, label.bytes, label.checksum};
    return job_checksum(std::as_bytes(std::span{words}));
}

/// The label of this generation's slot, if the slot was written for it.
std::optional<SlotLabel> label_of(const SegmentHeader& header, std::uint64_t generation) noexcept {
    const SlotContent& content = header.publication.of_slot[slot_of(generation)];
    const SlotLabel label{.generation = content.generation.load(std::memory_order_acquire),
                          .bytes = content.bytes.load(std::memory_order_acquire),
                          .checksum = content.checksum.load(std::memory_order_acquire)};
    const bool is_its_own = generation != 0 && label.generation == generation && label.bytes != 0 &&
                            content.seal.load(std::memory_order_acquire) == seal_of(label);
    return is_its_own ? std::optional{label} : std::nullopt;
}

bool is_in_slot(const SegmentHeader& header, std::uint64_t generation) noexcept {
    return label_of(header, generation).has_value();
}

/// The size comes last: until then the slot holds nothing.
void put_label(SlotContent& content, const SlotLabel& label) noexcept {
    content.generation.store(label.generation, std::memory_order_release);
    content.checksum.store(label.checksum, std::memory_order_release);
    content.seal.store(seal_of(label), std::memory_order_release);
    content.bytes.store(label.bytes, std::memory_order_release);
}

Error too_large(const Segment& segment, std::uint64_t bytes) {
    return bad_input("the job needs " + std::to_string(bytes) + " bytes, a slot of segment " +
                     segment.name() + " holds " + std::to_string(segment.slot_bytes()) + " (" +
                     std::to_string(segment.capacity_layers()) + " layers x " +
                     std::to_string(segment.capacity_points()) +
                     " points): use a core started with a larger --capacity on another --segment");
}

/// Copies the job of one generation; the caller knows whether that generation stood still meanwhile.
Result<std::vector<std::byte>> copy_slot(Segment& segment, std::uint64_t generation) {
    const auto label = label_of(segment.header(), generation);
    if (!label) {
        return error_from(ErrorCode::bad_input,
                          message_of(MessageId::published_by_nobody, count_argument(generation)));
    }
    if (label->bytes > segment.slot_bytes()) {
        return error_from(ErrorCode::bad_input,
                          message_of(MessageId::published_too_large, count_argument(label->bytes),
                                     count_argument(segment.slot_bytes())));
    }
    std::vector<std::byte> blob(label->bytes);
    if (auto read = segment.read_slot(slot_of(generation), blob); !read) return read.error();
    if (job_checksum(blob) != label->checksum) {
        return error_from(ErrorCode::bad_input, message_of(MessageId::published_checksum_wrong));
    }
    return blob;
}

/// The generation that the core has accepted; 0: none.
std::uint64_t accepted_generation(const SegmentHeader& header) noexcept {
    const auto status = read_record(header.status);
    return status ? status->job_generation : 0;
}

/// The count may be anything.
std::vector<Message> said_in(const JobVerdict& verdict) {
    const std::size_t count = std::min<std::size_t>(verdict.said_count, kVerdictMessages);
    return {verdict.said, verdict.said + count};
}

/// Nothing: the core has not judged it, and may still.
std::optional<Result<void>> judgement(const SegmentHeader& header, std::uint64_t generation) {
    const auto verdict = read_record(header.verdict);
    if (!verdict) return std::nullopt;
    if (verdict->generation == generation) {
        if (verdict->accepted == 1) return Result<void>{};
        const std::vector<Message> said = said_in(*verdict);
        return error_from(ErrorCode::machine_refused, said.empty() || said.front().is_none()
                                                          ? message_of(MessageId::job_refused_without_reason)
                                                          : said.front());
    }
    if (verdict->generation < generation) return std::nullopt;
    // Read after the verdict: a generation accepted before it is still there unless another was accepted
    // since.
    if (accepted_generation(header) == generation) return Result<void>{};
    // A number this great is that of a damaged word, which the core refused before ours.
    const bool is_damaged = verdict->generation > kLastGeneration;
    if (is_damaged && header.publication.generation.load() == generation) return std::nullopt;
    return error_from(ErrorCode::machine_refused, message_of(MessageId::other_job_published));
}

bool is_refused(const SegmentHeader& header, std::uint64_t generation) noexcept {
    const auto verdict = read_record(header.verdict);
    return verdict && verdict->generation == generation && verdict->accepted != 1;
}

/// The generation whose slot must not be written: the core may be copying the published one, and a snapshot
/// needs the accepted one. 0: none. A refused job has been judged, so no process reads its slot.
std::uint64_t generation_to_keep(const SegmentHeader& header) noexcept {
    const std::uint64_t published = header.publication.generation.load();
    const std::uint64_t accepted = accepted_generation(header);
    const bool is_looked_at =
        published >= accepted && is_in_slot(header, published) && !is_refused(header, published);
    if (is_looked_at) return published;
    return is_in_slot(header, accepted) ? accepted : 0;
}

/// Greater than any that a core may have judged, even where the word that publishes is damaged.
std::uint64_t generation_to_publish(const SegmentHeader& header) noexcept {
    std::uint64_t last = 0;
    const auto count = [&last](std::uint64_t generation) {
        if (generation <= kLastGeneration) last = std::max(last, generation);
    };
    count(header.publication.generation.load());
    count(accepted_generation(header));
    // Count a job that was taken back, too.
    for (const SlotContent& content : header.publication.of_slot) count(content.generation.load());
    if (const auto verdict = read_record(header.verdict)) count(verdict->generation);
    const std::uint64_t kept = generation_to_keep(header);
    const std::uint64_t next = last + 1;
    return kept != 0 && slot_of(next) == slot_of(kept) ? next + 1 : next;
}

/// The job to publish in place of a refused one: the one that the core accepted, also if the core was started
/// anew since and forgot it. 0: there is none.
std::uint64_t generation_before(const SegmentHeader& header, std::uint64_t refused) noexcept {
    const std::uint64_t accepted = accepted_generation(header);
    if (accepted != refused && is_in_slot(header, accepted)) return accepted;
    const std::uint64_t other = header.publication.of_slot[slot_of(refused + 1)].generation.load();
    return other < refused && is_in_slot(header, other) ? other : 0;
}

/// Its publisher was told that it was refused: a core started anew must not find it.
void take_back(Segment& segment, std::uint64_t generation) {
    SegmentHeader& header = segment.header();
    RobustMutex mutex{header.mutex};
    if (!mutex.lock_within(kTakeBackLimit)) return;
    const Lock lock{mutex, bip::accept_ownership};
    // A core that was started anew meanwhile judges it again.
    if (!is_refused(header, generation)) return;
    SlotContent& content = header.publication.of_slot[slot_of(generation)];
    const bool is_published = header.publication.generation.load() == generation;
    if (!is_published && !is_in_slot(header, generation)) return;
    if (is_published)
        header.publication.generation.store(generation_before(header, generation), std::memory_order_release);
    content.bytes.store(0, std::memory_order_release);
}

/// While a job runs another would only be refused, and a core started anew would take it for the one to
/// continue.
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
            return error_from(ErrorCode::machine_refused,
                              message_of(MessageId::job_runs, argument_of(status->state)));
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
    put_label(content, {.generation = generation, .bytes = job_blob.size(), .checksum = checksum});
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
        if (auto judged = judgement(header, generation)) {
            if (!*judged) take_back(segment, generation);
            return *judged;
        }
        if (!segment.core_pid()) {
            return error_from(ErrorCode::no_core,
                              with_text(message_of(MessageId::published_without_core), segment.name()));
        }
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
        if (left.count() <= 0) {
            const auto limit_ms = static_cast<std::uint64_t>(std::max<std::int64_t>(limit.count(), 0));
            return error_from(ErrorCode::timed_out,
                              message_of(MessageId::job_not_judged, ms_argument(limit_ms)));
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
    const std::uint64_t current = is_in_slot(header, accepted) ? accepted : published;
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
    const auto label = label_of(segment.header(), generation);
    return label ? std::optional{label->checksum} : std::nullopt;
}

bool is_published(const Segment& segment, std::uint64_t generation) noexcept {
    return is_in_slot(segment.header(), generation);
}

Result<std::optional<PublishedJob>> take_published_job(Segment& segment, std::uint64_t known_generation) {
    for (int attempt = 0; attempt < kCopyAttempts; ++attempt) {
        const std::uint64_t generation = published_generation(segment);
        if (generation <= known_generation) break;
        auto blob = copy_slot(segment, generation);
        // Writing into this slot begins only after the next generation was published: if ours still is, the
        // copy is consistent.
        if (published_generation(segment) != generation) continue;
        if (!blob) return blob.error();
        return std::optional{PublishedJob{.generation = generation, .blob = std::move(blob).value()}};
    }
    return std::optional<PublishedJob>{};
}

void acknowledge_job(Segment& segment, std::uint64_t generation, bool accepted,
                     const std::vector<Message>& said) {
    JobVerdict verdict{};
    verdict.generation = generation;
    verdict.accepted = accepted ? 1 : 2;
    for (const Message& one : said) {
        if (verdict.said_count == kVerdictMessages) break;
        verdict.said[verdict.said_count++] = one;
    }
    write_record(segment.header().verdict, verdict);
    event_signal(segment.header().status_changed);
}

std::vector<Message> job_remarks(const Segment& segment) {
    const auto verdict = read_record(segment.header().verdict);
    const bool is_of_it = verdict && verdict->generation == published_generation(segment);
    return is_of_it && verdict->accepted == 1 ? said_in(*verdict) : std::vector<Message>{};
}

}  // namespace psicarve
