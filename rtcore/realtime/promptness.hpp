// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace psicarve::rtcore {

/// Lets a thread that is waited for run at once when it wakes: before everything ordinary, after every tick.
/// At the least real-time priority, while raised; without the right to it, or where the thread is a real-time
/// one anyway, nothing changes. All by that thread. For short work: what takes long is done lowered.
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
