// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>

namespace psicarve::sim {

/// A number that one thread changes and any may read. As cheap as a plain one. RT: yes.
class Counter {
public:
    Counter() = default;
    explicit Counter(std::int64_t value) noexcept : value_(value) {}
    // Copied only while machines are built, before a second thread can see them.
    Counter(const Counter& other) noexcept : value_(other.get()) {}
    Counter& operator=(const Counter& other) noexcept {
        set(other.get());
        return *this;
    }
    ~Counter() = default;

    void set(std::int64_t value) noexcept { value_.store(value, std::memory_order_relaxed); }
    void add(std::int64_t value) noexcept { set(get() + value); }
    std::int64_t get() const noexcept { return value_.load(std::memory_order_relaxed); }
    std::uint64_t count() const noexcept { return static_cast<std::uint64_t>(get()); }

private:
    std::atomic<std::int64_t> value_{0};
};

}  // namespace psicarve::sim
