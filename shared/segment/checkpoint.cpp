// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/checkpoint.hpp"

#include <xxhash.h>

#include <cstddef>
#include <cstring>
#include <string>

namespace psicarve {
namespace {

std::uint64_t check_of(const Checkpoint& checkpoint) noexcept {
    return XXH3_64bits(&checkpoint, offsetof(Checkpoint, check));
}

Error refused(const std::string& reason) {
    return Error{ErrorCode::machine_refused, "start: " + reason};
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
    if (copied && copied->is_empty()) return refused("nothing was carved yet; there is nothing to resume");
    if (!copied || !is_checkpoint(*copied))
        return refused("the checkpoint is damaged; look at the piece and give the layer yourself");
    if (copied->job_checksum != job_checksum || copied->layer_count != layer_count)
        return refused("the checkpoint is of another job; publish that one, or give the layer yourself");
    if (copied->next_layer == 0) {
        const std::string earlier = std::to_string(copied->earlier_layer);
        return refused(
            "no layer was finished; start from the beginning" +
            (copied->earlier_layer == 0 ? "" : ", or --from-layer " + earlier + " for the piece of before"));
    }
    if (copied->next_layer == layer_count)
        return refused("the job is carved to its end; there is nothing to resume");
    return copied->next_layer;
}

}  // namespace psicarve
