// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/reached_point.hpp"

#include "shared/job/job.hpp"

namespace psicarve {
namespace {

constexpr unsigned kCountBits = 20;
constexpr std::uint64_t kCountMask = (std::uint64_t{1} << kCountBits) - 1;
constexpr unsigned kTagShift = 2 * kCountBits;
static_assert(kMaxJobCount <= kCountMask);

/// The checksum's high bits stay where they are.
std::uint64_t tag_of(std::uint64_t job_checksum) noexcept {
    return job_checksum >> kTagShift << kTagShift;
}

}  // namespace

std::uint64_t reached_word(std::uint64_t job_checksum, std::uint32_t layer, std::uint32_t point) noexcept {
    return tag_of(job_checksum) | std::uint64_t{layer} << kCountBits | (std::uint64_t{point} + 1);
}

std::optional<std::uint32_t> point_to_resume(std::uint64_t word, const Checkpoint& checkpoint) noexcept {
    const std::uint64_t number = word & kCountMask;
    const bool is_of_it = number != 0 && is_checkpoint(checkpoint) && !checkpoint.is_from_disk() &&
                          checkpoint.next_layer < checkpoint.layer_count &&
                          tag_of(word) == tag_of(checkpoint.job_checksum) &&
                          (word >> kCountBits & kCountMask) == checkpoint.next_layer;
    return is_of_it ? std::optional{static_cast<std::uint32_t>(number - 1)} : std::nullopt;
}

}  // namespace psicarve
