// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "rtcore/port/port.hpp"

namespace psicarve::supervisor {

/// A port whose inputs come from a recording while its outputs go to the port behind it: in a replay the core
/// sees the switches as they were. RT: yes.
class RecordedInputsPort final : public port::Port {
public:
    /// `heeded`: inputs that count as tripped, too, when the port behind shows them so now: on a real
    /// machine, where no recording knows what a hand or a carriage does today. None on a simulated machine,
    /// lest a replay differ from what was recorded.
    RecordedInputsPort(std::unique_ptr<port::Port> behind, SignalWord heeded) noexcept
        : behind_(std::move(behind)), heeded_(heeded) {}

    /// Between ticks only.
    void show_inputs(SignalWord levels) noexcept { inputs_ = levels & kInputMask; }

    SignalWord read_inputs(std::int64_t time_ns) noexcept override {
        return heeded_ == 0 ? inputs_ : inputs_ | (behind_->read_inputs(time_ns) & heeded_);
    }
    void write_outputs(SignalWord levels, std::int64_t time_ns) noexcept override {
        behind_->write_outputs(levels, time_ns);
    }
    void wait(std::int64_t width_ns) noexcept override { behind_->wait(width_ns); }
    void forget_written() noexcept override { behind_->forget_written(); }
    bool is_healthy() const noexcept override { return behind_->is_healthy(); }
    void try_safe_state() noexcept override { behind_->try_safe_state(); }
    SignalWord stuck_outputs() const noexcept override { return behind_->stuck_outputs(); }
    bool is_silent() const noexcept override { return behind_->is_silent(); }
    bool take_up_again() noexcept override { return behind_->take_up_again(); }

private:
    std::unique_ptr<port::Port> behind_;
    SignalWord inputs_ = 0;
    SignalWord heeded_;
};

}  // namespace psicarve::supervisor
