// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>

#include "hmi/machine/latency_probe.hpp"
#include "hmi/session/background_queue.hpp"
#include "hmi/session/machine_view.hpp"
#include "hmi/session/message_log.hpp"
#include "hmi/session/tick_health.hpp"

namespace psicarve::session {

/// A request and its result.
struct LatencyMeasurement {
    machine::LatencyOptions options;
    machine::LatencyResult result;
};

/// Measures how late the core's ticks would be on this computer, as `psicarve latency` does, on a thread of
/// its own. All calls come from one thread, the owner's.
class LatencyTrial {
public:
    using Measure = std::function<Result<machine::LatencyResult>(
        const machine::LatencyOptions&, const std::function<void(const machine::LatencyProgress&)>&,
        const std::function<bool()>&)>;

    explicit LatencyTrial(MessageLog& log, Measure measure = machine::measure_latency);
    /// Ends the measurement under way and waits for it.
    ~LatencyTrial();

    void begin(const machine::LatencyOptions& options);
    /// The measurement so far becomes the result.
    void end() noexcept { ends_.store(true); }
    /// Call it at screen rate.
    void poll() { queue_.deliver(); }

    bool is_measuring() const noexcept { return is_measuring_; }
    /// Of the measurement under way.
    const machine::LatencyOptions& options() const noexcept { return wish_; }
    machine::LatencyProgress progress() const;
    /// The last measurement.
    const std::optional<LatencyMeasurement>& last() const noexcept { return last_; }

private:
    MessageLog& log_;
    Measure measure_;
    machine::LatencyOptions wish_;
    bool is_measuring_ = false;
    std::atomic<bool> ends_{false};
    mutable std::mutex mutex_;
    machine::LatencyProgress progress_;  ///< under mutex_
    std::optional<LatencyMeasurement> last_;
    BackgroundQueue queue_;  // last: its thread uses the others
};

/// Why it cannot measure: a second tick loop would disturb a machine at work.
std::optional<Phrase> latency_lock(const MachineView& machine);

/// For the histogram: a bar for each doubling of microseconds.
TickHealth latency_health(const LatencyMeasurement& measured);

struct LatencyRow {
    Phrase name;
    Phrase value;
};
std::vector<LatencyRow> latency_rows(const LatencyMeasurement& measured);

}  // namespace psicarve::session
