// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/latency_text.hpp"
#include "hmi/cli/operator_break.hpp"
#include "hmi/cli/progress_bar.hpp"
#include "hmi/report/latency_report.hpp"
#include "shared/computer/cpu_list.hpp"
#include "shared/file/atomic_file.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kLatencyText{
    "latency", "Measure how late the core's ticks are on this computer",
    "Runs the core's own tick loop with nothing in the tick, beside whatever else the computer does: load "
    "it\n"
    "meanwhile as it will be loaded. Ctrl-C shows what was measured until then. Touches no machine.",
    "psicarve latency --seconds 3600\n  psicarve latency --period 100 --cpu 3 --csv late.csv"};

constexpr std::uint32_t kMostMeasured_s = 1'000'000;
constexpr std::uint32_t kMostPeriod_us = 1'000'000;
constexpr std::uint32_t kMostPriority = 99;

struct LatencyOptions {
    machine::LatencyOptions wish;
    std::string csv_path;
};

Result<void> check_cpu(const std::string& text) {
    if (text.empty() || text == "any") return {};
    const auto cpus = cpus_from_list(text);
    const long count = sysconf(_SC_NPROCESSORS_CONF);
    if (cpus && cpus->size() == 1 && cpus->front() < count) return {};
    return Error{ErrorCode::bad_usage, "latency: --cpu " + text +
                                           ": no processor of this computer, which has 0 to " +
                                           std::to_string(count - 1) + ", nor any"};
}

Result<int> measure(const CommonOptions& common, const LatencyOptions& options) {
    if (const auto known = check_cpu(options.wish.cpu); !known) return known.error();
    if (!options.csv_path.empty()) {
        if (const auto writable = check_writable(options.csv_path); !writable) return writable.error();
    }
    OperatorBreak operator_break;
    ProgressBar bar{"measuring"};
    const auto show = [&](const machine::LatencyProgress& now) {
        bar.update(static_cast<double>(now.seconds) / options.wish.seconds,
                   std::to_string(now.missed) + " missed, at most " + std::to_string(now.max_ns / 1000) +
                       " us late");
    };
    const auto result =
        machine::measure_latency(options.wish, show, [&] { return operator_break.was_asked(); });
    clear_progress_line();
    if (!result) return result.error();
    const std::string text = common.json ? report::latency_json(*result, options.wish).dump() + "\n"
                                         : latency_text(*result, options.wish);
    std::fputs(text.c_str(), stdout);
    if (!options.csv_path.empty()) {
        const std::string csv = report::latency_csv(*result);
        const auto written = write_file_atomically(options.csv_path, std::as_bytes(std::span{csv}));
        if (!written) return written.error();
    }
    return kExitDone;
}

}  // namespace

void add_latency(CommandSet& commands) {
    const auto options = std::make_shared<LatencyOptions>();
    commands.add(kLatencyText, [options](const CommonOptions& common) { return measure(common, *options); })
        .option("--seconds", options->wish.seconds, 1, kMostMeasured_s, "How long; 10 if not given")
        .option("--period", options->wish.period_us, 10, kMostPeriod_us, "Of the tick [us]; 50 if not given")
        .option("--priority", options->wish.priority, 1, kMostPriority, "Of SCHED_FIFO; 80 if not given")
        .option("--cpu", options->wish.cpu, "N|any", "The tick's processor; without it as the core chooses")
        .option("--csv", options->csv_path, "FILE", "Write how many ticks were how many us late");
}

}  // namespace psicarve::cli
