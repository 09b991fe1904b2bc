// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace psicarve::cycle {

/// A value that the tick writes and other threads of the core read whole: a sequence lock over words, odd
/// while being written. One writer. RT: yes.
template <typename T>
class SampleRecord {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % 8 == 0);
    static constexpr std::size_t kWords = sizeof(T) / 8;

public:
    void write(const T& value) noexcept {
        std::array<std::uint64_t, kWords> words;
        std::memcpy(words.data(), &value, sizeof(T));
        const std::uint64_t sequence = sequence_.load(std::memory_order_relaxed);
        sequence_.store(sequence + 1, std::memory_order_relaxed);
        // Release on each word: a reader that sees one of them sees the odd sequence, too. Free on x86.
        for (std::size_t i = 0; i < kWords; ++i) words_[i].store(words[i], std::memory_order_release);
        sequence_.store(sequence + 2, std::memory_order_release);
    }

    /// Any thread. Waits out a write, which takes well under a microsecond.
    T read() const noexcept {
        std::array<std::uint64_t, kWords> words;
        for (;;) {
            const std::uint64_t before = sequence_.load(std::memory_order_acquire);
            for (std::size_t i = 0; i < kWords; ++i) words[i] = words_[i].load(std::memory_order_acquire);
            if ((before & 1) == 0 && sequence_.load(std::memory_order_relaxed) == before) break;
        }
        T value;
        std::memcpy(&value, words.data(), sizeof(T));
        return value;
    }

private:
    std::atomic<std::uint64_t> sequence_{0};
    std::array<std::atomic<std::uint64_t>, kWords> words_{};
};

}  // namespace psicarve::cycle
