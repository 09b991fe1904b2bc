// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/program/motion_record.hpp"

#include <cstddef>
#include <cstring>

namespace psicarve {

// Each step is a bijection of the 64-bit words for a fixed word, and of the words for a fixed sum so far: two
// records that differ in one word never agree.
std::uint64_t record_check(const MotionRecord& record) noexcept {
    constexpr std::uint64_t kOddFactor = 0x9E3779B97F4A7C15U;
    constexpr unsigned kHalfWord = 32;
    std::uint64_t sum = kOddFactor;
    std::array<std::uint64_t, offsetof(MotionRecord, check) / sizeof(std::uint64_t)> words{};
    std::memcpy(words.data(), &record, sizeof(words));
    for (const std::uint64_t word : words) {
        sum = (sum ^ word) * kOddFactor;
        sum ^= sum >> kHalfWord;
    }
    return sum;
}

}  // namespace psicarve
