// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "rtcore/port/port.hpp"

namespace psicarve::bench {

/// Nothing hangs on it: what is left is the cost of the tick itself.
class NullPort final : public port::Port {
public:
    SignalWord read_inputs(std::int64_t) noexcept override { return 0; }
    void write_outputs(SignalWord levels, std::int64_t) noexcept override { last_ = levels; }
    void wait(std::int64_t) noexcept override {}
    bool is_healthy() const noexcept override { return true; }

private:
    SignalWord last_ = 0;
};

}  // namespace psicarve::bench
