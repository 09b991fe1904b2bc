// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <type_traits>

namespace psicarve {

/// Fixed-size queue between one writing and one reading thread; storage inline, wait-free on both sides. RT:
/// yes. kCapacity is a power of two; all of it can be used.
template <typename T, std::size_t kCapacity>
class SpscRing {
    static_assert(std::is_trivially_copyable_v<T>);
    static_assert(kCapacity >= 2 && (kCapacity & (kCapacity - 1)) == 0);

public:
    /// Writer only. False when full; nothing is overwritten.
    bool push(const T& value) noexcept {
        const std::size_t tail = tail_.load(std::memory_order_relaxed);
        if (tail - head_seen_ == kCapacity) {
            head_seen_ = head_.load(std::memory_order_acquire);
            if (tail - head_seen_ == kCapacity) return false;
        }
        entries_[tail & (kCapacity - 1)] = value;
        tail_.store(tail + 1, std::memory_order_release);
        return true;
    }

    /// Reader only. The oldest entry, or nullptr when empty; valid until pop().
    const T* front() noexcept {
        const std::size_t head = head_.load(std::memory_order_relaxed);
        if (head == tail_seen_) {
            tail_seen_ = tail_.load(std::memory_order_acquire);
            if (head == tail_seen_) return nullptr;
        }
        return &entries_[head & (kCapacity - 1)];
    }

    /// Reader only. The entry that front() would be after so many pop(), or nullptr; valid until it is
    /// popped.
    const T* ahead(std::size_t pops) const noexcept {
        return pops < size() ? &entries_[(head_.load(std::memory_order_relaxed) + pops) & (kCapacity - 1)]
                             : nullptr;
    }

    /// Reader only. Requires that front() was not nullptr.
    void pop() noexcept { head_.store(head_.load(std::memory_order_relaxed) + 1, std::memory_order_release); }

    /// Reader only.
    bool pop_into(T& value) noexcept {
        const T* entry = front();
        if (entry == nullptr) return false;
        value = *entry;
        pop();
        return true;
    }

    /// Either side; exact about the index that the caller's side writes, possibly old about the other.
    std::size_t size() const noexcept {
        return tail_.load(std::memory_order_acquire) - head_.load(std::memory_order_acquire);
    }
    static constexpr std::size_t capacity() noexcept { return kCapacity; }

private:
    // Reader and writer each own a cache line: the index they write and their copy of the other's.
    alignas(64) std::atomic<std::size_t> head_{0};
    std::size_t tail_seen_ = 0;
    alignas(64) std::atomic<std::size_t> tail_{0};
    std::size_t head_seen_ = 0;
    alignas(64) std::array<T, kCapacity> entries_;
};

}  // namespace psicarve
