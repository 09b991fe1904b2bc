// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>

#include "shared/base/result.hpp"

namespace psicarve::guard {

/// The counters that core and guard share: memory of these two processes alone, made before they part.
/// Neither waits for the other. Move-only.
class GuardPage {
public:
    static Result<GuardPage> make();
    GuardPage(GuardPage&& other) noexcept;
    GuardPage& operator=(GuardPage&&) = delete;
    ~GuardPage();

    /// The core's tick says that it lives. RT: yes.
    void note_tick() noexcept { words_->ticks.fetch_add(1, std::memory_order_relaxed); }
    /// Says that ticks come from now on, or that none will: whether silence means a fault.
    void set_ticking(bool is_ticking) noexcept { words_->is_ticking.store(is_ticking ? 1 : 0); }
    bool is_ticking() const noexcept { return words_->is_ticking.load() != 0; }
    std::uint64_t ticks() const noexcept { return words_->ticks.load(std::memory_order_relaxed); }

    /// The guard says that it has put the port into its safe state because the core does not tick.
    void note_act() noexcept { words_->acts.fetch_add(1); }
    std::uint32_t acts() const noexcept { return words_->acts.load(std::memory_order_acquire); }

    /// The guard says that it lives.
    void note_look() noexcept { words_->looks.fetch_add(1, std::memory_order_relaxed); }
    std::uint64_t looks() const noexcept { return words_->looks.load(std::memory_order_relaxed); }

private:
    struct Words {
        std::atomic<std::uint64_t> ticks;
        std::atomic<std::uint32_t> is_ticking;
        std::atomic<std::uint32_t> acts;
        std::atomic<std::uint64_t> looks;
    };
    explicit GuardPage(Words* words) noexcept : words_(words) {}
    Words* words_;
};

}  // namespace psicarve::guard
