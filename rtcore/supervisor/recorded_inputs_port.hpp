// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "rtcore/port/port.hpp"

namespace psicarve::supervisor {

/// A port whose inputs come from a recording while its outputs go to the port behind it: a replay shows the
/// core the switches as they were. RT: yes.
class RecordedInputsPort final : public port::Port {
public:
    explicit RecordedInputsPort(std::unique_ptr<port::Port> behind) noexcept : behind_(std::move(behind)) {}

    /// Between ticks only.
    void show_inputs(SignalWord levels) noexcept { inputs_ = levels & kInputMask; }

    SignalWord read_inputs(std::int64_t /*time_ns*/) noexcept override { return inputs_; }
    void write_outputs(SignalWord levels, std::int64_t time_ns) noexcept override {
        behind_->write_outputs(levels, time_ns);
    }
    void wait(std::int64_t width_ns) noexcept override { behind_->wait(width_ns); }
    bool is_healthy() const noexcept override { return behind_->is_healthy(); }

private:
    std::unique_ptr<port::Port> behind_;
    SignalWord inputs_ = 0;
};

}  // namespace psicarve::supervisor
