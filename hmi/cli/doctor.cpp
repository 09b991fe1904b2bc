// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/latency_text.hpp"
#include "hmi/cli/operator_break.hpp"
#include "hmi/cli/progress_bar.hpp"
#include "hmi/doctor/checks.hpp"
#include "hmi/report/latency_report.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kDoctorText{
    "doctor", "Check this computer before it drives a machine",
    "Rights, kernel, processors, clock, memory and ports, each with what it means and what to do; then a\n"
    "latency measurement of ten seconds. Touches no machine. Exit code 4 when there is a problem that keeps "
    "a\n"
    "real machine from being driven; warnings leave it 0.",
    "psicarve doctor\n  psicarve doctor --no-latency --json"};

constexpr std::uint32_t kMostSeconds = 3600;

struct DoctorOptions {
    machine::LatencyOptions wish;
    bool no_latency = false;
};

const char* word_of(doctor::Verdict verdict) {
    switch (verdict) {
        case doctor::Verdict::ok:
            return "ok";
        case doctor::Verdict::warning:
            return "warning";
        case doctor::Verdict::problem:
            return "problem";
    }
    return "";
}

std::string text_of(const std::vector<doctor::Finding>& findings) {
    std::string text;
    for (const doctor::Finding& finding : findings) {
        char head[48];
        (void)std::snprintf(head, sizeof head, "%-8s %-22s ", word_of(finding.verdict), finding.name.c_str());
        text += head + finding.seen + "\n";
        if (finding.verdict == doctor::Verdict::ok) continue;
        text += "           " + finding.meaning + "\n           remedy: " + finding.remedy + "\n";
    }
    return text;
}

nlohmann::ordered_json json_of(const std::vector<doctor::Finding>& findings) {
    auto array = nlohmann::ordered_json::array();
    for (const doctor::Finding& finding : findings) {
        array.push_back({{"name", finding.name},
                         {"verdict", word_of(finding.verdict)},
                         {"seen", finding.seen},
                         {"meaning", finding.meaning},
                         {"remedy", finding.remedy}});
    }
    return array;
}

Result<machine::LatencyResult> measured(const machine::LatencyOptions& wish) {
    OperatorBreak operator_break;
    ProgressBar bar{"measuring"};
    const auto show = [&](const machine::LatencyProgress& now) {
        bar.update(static_cast<double>(now.seconds) / wish.seconds);
    };
    auto result = machine::measure_latency(wish, show, [&] { return operator_break.was_asked(); });
    clear_progress_line();
    return result;
}

Result<int> examine(const CommonOptions& common, const DoctorOptions& options) {
    const auto findings = doctor::check_all(doctor::SystemFiles{});
    const doctor::Verdict worst = doctor::worst_of(findings);
    nlohmann::ordered_json report{{"verdict", word_of(worst)}, {"findings", json_of(findings)}};
    if (!common.json) {
        std::fputs(text_of(findings).c_str(), stdout);
        std::fflush(stdout);
    }
    if (!options.no_latency) {
        const auto result = measured(options.wish);
        if (!result) return result.error();
        report["latency"] = report::latency_json(*result, options.wish);
        if (!common.json) std::fputs(("\n" + latency_text(*result, options.wish)).c_str(), stdout);
    }
    if (common.json) std::printf("%s\n", report.dump().c_str());
    return worst == doctor::Verdict::problem ? kExitMachine : kExitDone;
}

}  // namespace

void add_doctor(CommandSet& commands) {
    const auto options = std::make_shared<DoctorOptions>();
    commands.add(kDoctorText, [options](const CommonOptions& common) { return examine(common, *options); })
        .flag("--no-latency", options->no_latency, "Measure nothing")
        .option("--seconds", options->wish.seconds, 1, kMostSeconds, "Of the measurement; 10 if not given");
}

}  // namespace psicarve::cli
