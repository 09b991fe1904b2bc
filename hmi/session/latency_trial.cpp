// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/latency_trial.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "hmi/phrase/error_phrase.hpp"
#include "hmi/session/display_text.hpp"
#include "shared/base/units.hpp"

namespace psicarve::session {
namespace {

std::string us_text(double duration_us) {
    return duration_text(std::llround(duration_us * static_cast<double>(kNsPerUs)));
}

/// Bar 0: below a microsecond; bar n: 2^(n-1) to 2^n.
std::size_t bar_of(std::uint32_t late_us) {
    return static_cast<std::size_t>(std::bit_width(late_us));
}

}  // namespace

LatencyTrial::LatencyTrial(MessageLog& log, Measure measure) : log_(log), measure_(std::move(measure)) {}

LatencyTrial::~LatencyTrial() {
    end();
}

void LatencyTrial::begin(const machine::LatencyOptions& options) {
    if (is_measuring_) return;
    is_measuring_ = true;
    wish_ = options;
    ends_.store(false);
    {
        const std::lock_guard lock{mutex_};
        progress_ = {};
    }
    queue_.post([this, options]() -> BackgroundQueue::Finish {
        const auto note = [this](const machine::LatencyProgress& now) {
            const std::lock_guard lock{mutex_};
            progress_ = now;
        };
        const auto measured = measure_(options, note, [this] { return ends_.load(); });
        return [this, options, measured] {
            is_measuring_ = false;
            if (!measured) {
                return log_.add(Severity::warning, joined(phrase("Measure"), error_phrase(measured.error())));
            }
            last_ = LatencyMeasurement{options, *measured};
            log_.add(Severity::info,
                     phrase("Measured %1 ticks: 99.9 % at most %2 late, %3 missed", counted(measured->ticks),
                            us_text(measured->late_us(0.999)), counted(measured->missed)));
        };
    });
}

machine::LatencyProgress LatencyTrial::progress() const {
    const std::lock_guard lock{mutex_};
    return progress_;
}

std::optional<Phrase> latency_lock(const MachineView& machine) {
    if (machine.is_heard() && !is_at_rest(machine.state()))
        return phrase("Measure: the machine is at work, and would be disturbed");
    return std::nullopt;
}

TickHealth latency_health(const LatencyMeasurement& measured) {
    const machine::LatencyResult& result = measured.result;
    TickHealth health;
    health.ticks = result.ticks;
    health.missed = result.missed;
    health.period_ns = std::int64_t{measured.options.period_us} * kNsPerUs;
    health.greatest_ns = result.max_ns;
    health.period_bar = bar_of(measured.options.period_us);
    std::vector<std::uint64_t> rows(health.period_bar + 1);
    for (const auto& [late_us, ticks] : result.bins) {
        rows.resize(std::max(rows.size(), bar_of(late_us) + 1));
        rows[bar_of(late_us)] += ticks;
    }
    const double most = static_cast<double>(*std::max_element(rows.begin(), rows.end()));
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const double height =
            rows[row] > 0 ? std::log1p(static_cast<double>(rows[row])) / std::log1p(most) : 0.0;
        health.bars.push_back(
            {"\u2264 " + us_text(std::ldexp(1.0, static_cast<int>(row))), rows[row], height});
    }
    return health;
}

std::vector<LatencyRow> latency_rows(const LatencyMeasurement& measured) {
    const machine::LatencyResult& result = measured.result;
    const auto late = [&](double share) { return us_text(result.late_us(share)); };
    std::vector<LatencyRow> rows{
        {phrase("Ticks measured, missed"), phrase("%1, %2", counted(result.ticks), counted(result.missed))},
        {phrase("Late: median, 99 %, 99.9 %"), phrase("%1, %2, %3", late(0.5), late(0.99), late(0.999))},
        {phrase("Latest of all"), phrase("%1", duration_text(result.max_ns))},
        {phrase("Thread"), result.priority > 0
                               ? phrase("SCHED_FIFO, priority %1", std::to_string(result.priority))
                               : phrase("ordinary scheduling")},
        {phrase("Processor"),
         result.cpu < 0 ? phrase("any processor") : phrase("processor %1", std::to_string(result.cpu))},
        {phrase("Page faults, preemptions of the tick"),
         phrase("%1, %2", counted(result.page_faults), counted(result.preemptions))}};
    for (const std::string& step : result.refused) rows.push_back({phrase("%1", step), phrase("refused")});
    return rows;
}

}  // namespace psicarve::session
