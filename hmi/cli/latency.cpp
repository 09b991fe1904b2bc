// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/latency_text.hpp"
#include "hmi/cli/operator_break.hpp"
#include "hmi/cli/progress_bar.hpp"
#include "shared/atomic_file.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kText{
    "latency", "Measure how late the core's ticks are on this computer",
    "Runs the core's own tick loop with nothing in the tick, beside whatever else the computer does: load "
    "it\n"
    "meanwhile as it will be loaded. Ctrl-C shows what was measured until then. Touches no machine.",
    "psicarve latency --seconds 3600\n  psicarve latency --period 100 --cpu 3 --csv late.csv"};

constexpr std::uint32_t kMostSeconds = 1'000'000;
constexpr std::uint32_t kMostPeriod_us = 1'000'000;
constexpr std::uint32_t kMostPriority = 99;

struct Options {
    machine::LatencyWish wish;
    std::string csv_path;
};

Result<int> measure(const CommonOptions& common, const Options& options) {
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
    if (!options.csv_path.empty()) {
        const std::string csv = latency_csv(*result);
        const auto written = write_file_atomically(options.csv_path, std::as_bytes(std::span{csv}));
        if (!written) return written.error();
    }
    const std::string text =
        common.json ? latency_json(*result, options.wish).dump() + "\n" : latency_text(*result, options.wish);
    std::fputs(text.c_str(), stdout);
    return kExitDone;
}

}  // namespace

void add_latency(CommandSet& commands) {
    const auto options = std::make_shared<Options>();
    commands.add(kText, [options](const CommonOptions& common) { return measure(common, *options); })
        .option("--seconds", options->wish.seconds, 1, kMostSeconds, "How long; 10 if not given")
        .option("--period", options->wish.period_us, 10, kMostPeriod_us, "Of the tick [us]; 50 if not given")
        .option("--priority", options->wish.priority, 1, kMostPriority, "Of SCHED_FIFO; 80 if not given")
        .option("--cpu", options->wish.cpu, "N|any", "The tick's processor; without it as the core chooses")
        .option("--csv", options->csv_path, "FILE", "Write how many ticks were how many us late");
}

}  // namespace psicarve::cli
