// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "shared/segment/checkpoint.hpp"

namespace psicarve {

/// How far the layer behind the checkpoint's last finished one is carved, in one word of the segment: what is
/// written with each point must not be found half written after a death. Layer and point of its table, both
/// from 0, and a part of the hash of these and the job's checksum. `layer`, `point`: less than kMaxJobCount.
/// Never 0, which says that nothing is known.
std::uint64_t reached_word(std::uint64_t job_checksum, std::uint32_t layer, std::uint32_t point) noexcept;

/// The point of layer `checkpoint.next_layer` up to which, and with which, both heads have carved: a start
/// from there overlaps by that point. Nothing: none is known, or the word is not of this checkpoint.
std::optional<std::uint32_t> point_to_resume(std::uint64_t word, const Checkpoint& checkpoint) noexcept;

}  // namespace psicarve
