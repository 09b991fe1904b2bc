// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/checkpoint.hpp"

#include <xxhash.h>

#include <cstddef>
#include <cstring>

#include "shared/wording/wording.hpp"

namespace psicarve {
namespace {

std::uint64_t check_of(const Checkpoint& checkpoint) noexcept {
    return XXH3_64bits(&checkpoint, offsetof(Checkpoint, check));
}

Error refused(const Message& why) {
    return error_from(ErrorCode::machine_refused, why);
}

}  // namespace

bool Checkpoint::is_empty() const noexcept {
    const Checkpoint none{};
    return std::memcmp(this, &none, sizeof none) == 0;
}

Checkpoint checkpoint_at(std::uint64_t job_checksum, std::uint32_t next_layer, std::uint32_t layer_count,
                         std::uint32_t earlier_layer, std::uint32_t origin) noexcept {
    Checkpoint checkpoint{.job_checksum = job_checksum,
                          .next_layer = next_layer,
                          .layer_count = layer_count,
                          .earlier_layer = earlier_layer,
                          .origin = origin,
                          .check = 0};
    checkpoint.check = check_of(checkpoint);
    return checkpoint;
}

bool is_checkpoint(const Checkpoint& checkpoint) noexcept {
    constexpr std::uint32_t kKnownBits = kCheckpointSimulated | kCheckpointFromDisk;
    return !checkpoint.is_empty() && (checkpoint.origin & ~kKnownBits) == 0 &&
           checkpoint.check == check_of(checkpoint) && checkpoint.layer_count > 0 &&
           checkpoint.next_layer <= checkpoint.layer_count &&
           checkpoint.earlier_layer < checkpoint.layer_count;
}

bool is_unfinished(const Checkpoint& checkpoint) noexcept {
    const bool is_whole = checkpoint.next_layer == checkpoint.layer_count;
    return !is_whole && (checkpoint.next_layer != 0 || checkpoint.earlier_layer != 0);
}

bool is_same_place(const Checkpoint& one, const Checkpoint& other) noexcept {
    return one.job_checksum == other.job_checksum && one.layer_count == other.layer_count &&
           one.next_layer == other.next_layer && one.earlier_layer == other.earlier_layer;
}

Result<std::uint32_t> layer_to_resume(const std::optional<Checkpoint>& copied, std::uint64_t job_checksum,
                                      std::uint32_t layer_count) {
    if (copied && copied->is_empty()) return refused(message_of(MessageId::nothing_carved));
    if (!copied || !is_checkpoint(*copied)) return refused(message_of(MessageId::checkpoint_damaged));
    if (copied->job_checksum != job_checksum || copied->layer_count != layer_count)
        return refused(message_of(MessageId::checkpoint_of_other_job));
    if (copied->next_layer == 0 && copied->earlier_layer == 0)
        return refused(message_of(MessageId::no_layer_finished));
    if (copied->next_layer == 0) {
        return refused(
            message_of(MessageId::no_layer_finished_but_earlier, layer_argument(copied->earlier_layer)));
    }
    if (copied->next_layer == layer_count) return refused(message_of(MessageId::carved_to_its_end));
    return copied->next_layer;
}

}  // namespace psicarve
