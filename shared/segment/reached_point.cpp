// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/reached_point.hpp"

#include <xxhash.h>

#include <array>

#include "shared/job/job.hpp"

namespace psicarve {
namespace {

constexpr unsigned kCountBits = 20;
constexpr std::uint64_t kCountMask = (std::uint64_t{1} << kCountBits) - 1;
constexpr unsigned kTagShift = 2 * kCountBits;
static_assert(kMaxJobCount <= kCountMask);

/// Over job, layer and point: a word of which any bit has changed is none. The hash's high bits stay where
/// they are.
std::uint64_t tag_of(std::uint64_t job_checksum, std::uint64_t place) noexcept {
    const std::array<std::uint64_t, 2> words{job_checksum, place};
    return XXH3_64bits(words.data(), sizeof words) >> kTagShift << kTagShift;
}

}  // namespace

std::uint64_t reached_word(std::uint64_t job_checksum, std::uint32_t layer, std::uint32_t point) noexcept {
    const std::uint64_t place = std::uint64_t{layer} << kCountBits | (std::uint64_t{point} + 1);
    return tag_of(job_checksum, place) | place;
}

std::optional<std::uint32_t> point_to_resume(std::uint64_t word, const Checkpoint& checkpoint) noexcept {
    const std::uint64_t number = word & kCountMask;
    const std::uint64_t place = word & ((std::uint64_t{1} << kTagShift) - 1);
    const bool is_of_it = number != 0 && is_checkpoint(checkpoint) && !checkpoint.is_from_disk() &&
                          checkpoint.next_layer < checkpoint.layer_count &&
                          place >> kCountBits == checkpoint.next_layer &&
                          word == (tag_of(checkpoint.job_checksum, place) | place);
    return is_of_it ? std::optional{static_cast<std::uint32_t>(number - 1)} : std::nullopt;
}

}  // namespace psicarve
