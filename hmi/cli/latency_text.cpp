// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/latency_text.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <map>

#include "shared/base/units.hpp"

namespace psicarve::cli {
namespace {

constexpr int kBarWidth = 40;

template <typename... Args>
std::string latency_words(const char* format, Args... args) {
    char text[160];
    (void)std::snprintf(text, sizeof text, format, args...);
    return text;
}

/// Row n: 2^(n-1) to 2^n us; row 0: below one.
std::map<unsigned, std::uint64_t> rows_of(const machine::LatencyResult& result) {
    std::map<unsigned, std::uint64_t> rows;
    for (const auto& [late_us, ticks] : result.bins)
        rows[static_cast<unsigned>(std::bit_width(late_us))] += ticks;
    return rows;
}

std::string picture_of(const machine::LatencyResult& result) {
    const auto rows = rows_of(result);
    if (rows.empty()) return {};
    std::uint64_t most = 1;
    for (const auto& [row, ticks] : rows) most = std::max(most, ticks);
    std::string text = "   us late   ticks   (bars are logarithmic)\n";
    for (unsigned row = rows.begin()->first; row <= rows.rbegin()->first; ++row) {
        const auto found = rows.find(row);
        const std::uint64_t ticks = found == rows.end() ? 0 : found->second;
        const double share = std::log1p(static_cast<double>(ticks)) / std::log1p(static_cast<double>(most));
        const auto length = static_cast<std::size_t>(std::ceil(share * kBarWidth));
        const unsigned from_us = row == 0 ? 0 : 1U << (row - 1);
        text += latency_words("%5u-%-5u %9llu ", from_us, 1U << row, static_cast<unsigned long long>(ticks)) +
                std::string(length, '#') + "\n";
    }
    return text;
}

double max_us(const machine::LatencyResult& result) {
    return static_cast<double>(result.max_ns) / static_cast<double>(kNsPerUs);
}

}  // namespace

std::string latency_text(const machine::LatencyResult& result, const machine::LatencyOptions& options) {
    std::string text = picture_of(result);
    text += latency_words("late       median %.1f us, 99 %% %.1f us, 99.9 %% %.1f us, at most %.1f us\n",
                          result.late_us(0.5), result.late_us(0.99), result.late_us(0.999), max_us(result));
    text += latency_words("ticks      %llu of %u us, %llu missed\n",
                          static_cast<unsigned long long>(result.ticks), options.period_us,
                          static_cast<unsigned long long>(result.missed));
    text += result.priority > 0 ? latency_words("thread     SCHED_FIFO %d", result.priority)
                                : "thread     ordinary scheduling";
    text += result.cpu < 0 ? ", any processor" : latency_words(", processor %d", result.cpu);
    text += latency_words(", %llu page faults, preempted %llu times\n",
                          static_cast<unsigned long long>(result.page_faults),
                          static_cast<unsigned long long>(result.preemptions));
    for (const std::string& step : result.refused)
        text += "refused    " + step + " (psicarve doctor says more)\n";
    return text;
}

}  // namespace psicarve::cli
