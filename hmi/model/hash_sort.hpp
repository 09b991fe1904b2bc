// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace psicarve::model {

/// As std::sort, for elements that begin with a hash: `hash_of` an element decides first, and equal hashes
/// are rare or belong to equal elements. Two rounds by the highest bits bring nearly all to their places.
/// Takes as much memory again.
template <typename T, typename HashOf>
void sort_by_hash(std::vector<T>& values, const HashOf& hash_of) {
    constexpr unsigned kBits = 11;
    constexpr std::size_t kLeastWorthIt = 4096;
    constexpr std::size_t kMostWorthIt = std::size_t{1} << 24U;  // the second copy is large by then
    if (values.size() < kLeastWorthIt || values.size() > kMostWorthIt)
        return std::sort(values.begin(), values.end());
    std::vector<T> other(values.size());
    for (const unsigned shift : {64 - 2 * kBits, 64 - kBits}) {
        const auto digit = [&](const T& value) {
            return static_cast<std::size_t>(hash_of(value) >> shift) & ((std::size_t{1} << kBits) - 1);
        };
        std::array<std::uint32_t, std::size_t{1} << kBits> next{};
        for (const T& value : values) ++next[digit(value)];
        std::uint32_t sum = 0;
        for (std::uint32_t& place : next) sum += std::exchange(place, sum);
        for (const T& value : values) other[next[digit(value)]++] = value;
        values.swap(other);
    }
    const auto top = [&hash_of](const T& value) { return hash_of(value) >> (64 - 2 * kBits); };
    for (auto first = values.begin(); first != values.end();) {
        auto end = first + 1;
        while (end != values.end() && top(*end) == top(*first)) ++end;
        if (end - first > 1) std::sort(first, end);
        first = end;
    }
}

/// Which hashes a sorted list may hold: one bit rules out most of those that it does not hold.
class HashSieve {
public:
    explicit HashSieve(const std::vector<std::uint64_t>& hashes) {
        constexpr std::size_t kBitsPerHash = 16;
        while (words() * 64 < hashes.size() * kBitsPerHash) --shift_;
        bits_.resize(words());
        for (const std::uint64_t hash : hashes) bits_[hash >> shift_ >> 6U] |= bit(hash);
    }

    bool may_hold(std::uint64_t hash) const noexcept {
        return (bits_[hash >> shift_ >> 6U] & bit(hash)) != 0;
    }

private:
    std::size_t words() const noexcept { return std::size_t{1} << (64 - shift_ - 6U); }
    std::uint64_t bit(std::uint64_t hash) const noexcept {
        return std::uint64_t{1} << (hash >> shift_ & 63U);
    }

    unsigned shift_ = 64 - 10;
    std::vector<std::uint64_t> bits_;
};

}  // namespace psicarve::model
