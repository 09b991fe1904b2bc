// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace psicarve::rtcore {

/// Lets a thread that others wait for run at once when it wakes: before all ordinary threads, after every
/// tick. While raised it has the least real-time priority; without the right to it, or where the thread is a
/// real-time one anyway, nothing changes. All calls come from that thread. For short work: lower it before
/// long work.
class Promptness {
public:
    explicit Promptness(bool is_wanted) noexcept : is_possible_(is_wanted) {}
    ~Promptness() { lower(); }
    Promptness(const Promptness&) = delete;
    Promptness& operator=(const Promptness&) = delete;

    void raise() noexcept;
    void lower() noexcept;

private:
    bool is_possible_;
    bool is_raised_ = false;
};

}  // namespace psicarve::rtcore
