// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <type_traits>

namespace psicarve::gcode {

/// What held from which record on; in order. Bounded: the oldest is forgotten. Of those between the oldest
/// and the newest only what is different from the one before is kept, for little is:
///
///     oldest | records between, which words, their bits that differ | ... | newest
template <typename What>
class ChangeHistory {
    using Words = std::array<std::uint64_t, sizeof(What) / sizeof(std::uint64_t)>;
    static_assert(std::is_trivially_copyable_v<What> && sizeof(Words) == sizeof(What));

public:
    explicit ChangeHistory(std::size_t most) noexcept : most_(most) {}

    void add(std::uint64_t first, const What& what) {
        if (count_ > 1) write(newest_);
        written_ = newest_;
        newest_ = {first, std::bit_cast<Words>(what)};
        if (count_++ == 0) oldest_ = newest_;
        if (count_ > most_) drop_oldest();
    }
    /// Where it is another than the newest.
    void add_change(std::uint64_t first, const What& what) {
        if (count_ == 0 || std::bit_cast<Words>(what) != newest_.words) add(first, what);
    }
    /// Requires one.
    void replace_newest(const What& what) {
        newest_.words = std::bit_cast<Words>(what);
        if (count_ == 1) oldest_ = newest_;
    }
    /// Drops what is not in force any more where this record is: the first that stays is the last one that
    /// begins there or before.
    void drop_before(std::uint64_t sequence) {
        while (count_ > 1 && second_first(0) <= sequence) drop_oldest();
    }
    bool knows(std::uint64_t sequence) const noexcept { return count_ > 0 && oldest_.first <= sequence; }
    std::size_t count() const noexcept { return count_; }
    /// What it takes beside the object itself.
    std::size_t kept_bytes() const noexcept { return bytes_.size(); }

    // Requires one:
    What front() const { return std::bit_cast<What>(oldest_.words); }
    std::uint64_t front_first() const noexcept { return oldest_.first; }
    std::uint64_t newest_first() const noexcept { return newest_.first; }
    /// Where the oldest ends; `none` where it holds to the end.
    std::uint64_t second_first(std::uint64_t none) const {
        if (count_ < 3) return count_ == 2 ? newest_.first : none;
        auto byte = bytes_.cbegin();
        return oldest_.first + number_at(byte);
    }

private:
    struct Change {
        std::uint64_t first = 0;
        Words words{};
    };
    static constexpr unsigned kBitsAByte = 7;  ///< the eighth: another byte follows

    void drop_oldest() {
        if (count_-- == 2) {
            oldest_ = newest_;
            return;
        }
        auto byte = bytes_.cbegin();
        oldest_.first += number_at(byte);
        const std::uint64_t different = number_at(byte);
        for (std::size_t n = 0; n < oldest_.words.size(); ++n)
            if ((different >> n & 1U) != 0) oldest_.words[n] ^= number_at(byte);
        bytes_.erase(bytes_.begin(), byte);
    }
    /// Behind written_.
    void write(const Change& change) {
        std::uint64_t different = 0;
        for (std::size_t n = 0; n < change.words.size(); ++n)
            if (change.words[n] != written_.words[n]) different |= std::uint64_t{1} << n;
        put(change.first - written_.first);
        put(different);
        for (std::size_t n = 0; n < change.words.size(); ++n)
            if ((different >> n & 1U) != 0) put(change.words[n] ^ written_.words[n]);
    }
    void put(std::uint64_t number) {
        for (; number >> kBitsAByte != 0; number >>= kBitsAByte)
            bytes_.push_back(static_cast<std::uint8_t>(number | std::uint64_t{1} << kBitsAByte));
        bytes_.push_back(static_cast<std::uint8_t>(number));
    }
    static std::uint64_t number_at(std::deque<std::uint8_t>::const_iterator& byte) {
        std::uint64_t number = 0;
        for (unsigned shift = 0;; shift += kBitsAByte) {
            const std::uint64_t bits = *byte++;
            number |= (bits & ((1U << kBitsAByte) - 1)) << shift;
            if (bits >> kBitsAByte == 0) return number;
        }
    }

    std::size_t most_;
    std::size_t count_ = 0;
    Change oldest_;
    Change newest_;   ///< the oldest, where there is one
    Change written_;  ///< the one before the newest: how the next that is written differs from it
    std::deque<std::uint8_t> bytes_;
};

}  // namespace psicarve::gcode
