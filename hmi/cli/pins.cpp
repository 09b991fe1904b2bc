// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/known_profile.hpp"
#include "hmi/cli/motion_command.hpp"
#include "hmi/cli/operator_break.hpp"
#include "hmi/cli/watch_loop.hpp"
#include "hmi/machine/jog.hpp"
#include "hmi/profile/pin_rows.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kPinsText{
    "pins", "The level of every signal; with SIGNAL: test one output",
    "A test needs the drives off (before homing, or after drives-off). The one output is active until "
    "Ctrl-C,\n"
    "or sends --pulses; all others are inactive, and every change of a level is shown. It ends by itself "
    "when\n"
    "this program does. Levels are logical; pins are those of --profile when it is the core's.",
    "psicarve pins --watch\n  psicarve pins spindle\n  psicarve pins r1_step --pulses 200 --rate 50"};

constexpr std::uint32_t kMostPulses = 10'000;
constexpr std::uint32_t kMostRate_hz = 500;
constexpr std::uint32_t kUsualRate_hz = 50;

struct PinsOptions {
    std::string signal;
    std::uint32_t pulses = 0;
    std::uint32_t rate_hz = kUsualRate_hz;
    std::optional<double> lease_s;
    bool watch = false;
};

using Rows = std::vector<session::PinRow>;

/// Without pins where the core's profile is not known.
Rows rows_of(const std::optional<Profile>& profile) {
    Rows rows = session::pin_rows(profile.value_or(Profile{}));
    for (session::PinRow& row : rows) row.pin = profile ? row.pin : 0;
    return rows;
}

/// The charge pump's bit says that it toggles.
const char* level_text(Signal signal, SignalWord levels) {
    const bool is_active = (levels & bit_of(signal)) != 0;
    if (signal == Signal::charge_pump) return is_active ? "toggling" : "still";
    return is_active ? "high" : "low";
}

std::string levels_text(const Rows& rows, SignalWord levels) {
    std::string text;
    for (const session::PinRow& row : rows) {
        char line[80];
        const std::string pin = row.pin == 0 ? "-" : std::to_string(row.pin);
        (void)std::snprintf(line, sizeof line, "%3s  %-12s %-3s  %s\n", pin.c_str(),
                            std::string{name_of(row.signal)}.c_str(), is_output(row.signal) ? "out" : "in",
                            level_text(row.signal, levels));
        text += line;
    }
    return text;
}

std::string levels_line(SignalWord levels) {
    std::string text;
    for (std::size_t i = 0; i < kSignalCount; ++i) {
        if ((levels >> i & 1U) != 0) text += " " + std::string{name_of(static_cast<Signal>(i))};
    }
    return "high:" + (text.empty() ? " none" : text) + "\n";
}

std::string levels_json(const Rows& rows, const CoreStatus& status) {
    nlohmann::ordered_json signals;
    for (const session::PinRow& row : rows) {
        signals[std::string{name_of(row.signal)}] = {{"pin", row.pin},
                                                     {"is_output", is_output(row.signal)},
                                                     {"level", (status.signals & bit_of(row.signal)) != 0}};
    }
    return nlohmann::ordered_json{{"state", name_of(status.state)},
                                  {"port_silent", status.is_port_silent != 0},
                                  {"signals", signals}}
               .dump() +
           "\n";
}

/// Judges how a test ended.
Result<void> judge_test(const CoreStatus& status, bool was_asked) {
    if (was_asked || status.move_end == MoveEnd::reached) return {};
    const bool is_lease_gone = status.move_end == MoveEnd::lease_gone;
    return Error{ErrorCode::machine_refused,
                 is_lease_gone ? "pins: ended early, the core had not heard from us for too long; is the "
                                 "computer busy?"
                               : "pins: ended early: somebody stopped the machine"};
}

Result<int> test_output(const CommonOptions& common, machine::MachineLink& link, const PinsOptions& options,
                        std::chrono::milliseconds lease) {
    const auto output = signal_from_name(options.signal);
    if (!output || !is_output(*output)) {
        return Error{ErrorCode::bad_usage,
                     "pins: '" + options.signal + "' is no output; as in the profile's [port.pins]: r1_step"};
    }
    OperatorBreak operator_break;
    auto held = machine::HeldJog::test(link, *output, options.pulses, options.rate_hz, lease);
    if (!held) return held.error();
    std::optional<SignalWord> shown;
    const auto watch = [&](const CoreStatus& status) -> Result<void> {
        if (operator_break.was_asked()) {
            held->release();
        } else {
            held->renew();
        }
        if (!common.json && shown != status.signals && options.pulses == 0)
            std::printf("%s", levels_line(status.signals).c_str());
        std::fflush(stdout);
        shown = status.signals;
        return {};
    };
    const auto end = link.wait_for_state({MachineState::off}, watch);
    if (!end) return end.error();
    if (const auto whole = judge_test(*end, operator_break.was_asked()); !whole) return whole.error();
    report_motion(common, kPinsText.name, *end);
    return kExitDone;
}

Result<int> pins(const CommonOptions& common, const PinsOptions& options) {
    const auto lease = lease_argument(options.lease_s, kJogLease);
    if (!lease) return lease.error();
    auto known = KnownProfile::read(common);
    if (!known) return known.error();
    auto link = link_to_core(common);
    if (!link) return link.error();
    if (!options.signal.empty()) return test_output(common, *link, options, *lease);
    const auto show = [&](bool as_line) -> Result<std::string> {
        const auto status = link->status();
        if (!status) return status.error();
        const Rows rows = rows_of(known->of(*link));
        if (common.json) return levels_json(rows, *status);
        const std::string warning =
            status->is_port_silent != 0 ? std::string{kSilentPortRemedy} + "\n" : std::string{};
        return warning + (as_line ? levels_line(status->signals) : levels_text(rows, status->signals));
    };
    return show_or_watch(show, options.watch, common.json);
}

}  // namespace

void add_pins(CommandSet& commands) {
    const auto options = std::make_shared<PinsOptions>();
    commands.add(kPinsText, [options](const CommonOptions& common) { return pins(common, *options); })
        .optional_argument("SIGNAL", options->signal, "The output to test, as in the profile: r1_step")
        .option("--pulses", options->pulses, 1, kMostPulses, "Send so many pulses and end")
        .option("--rate", options->rate_hz, 1, kMostRate_hz, "Pulses in a second")
        .option(
            "--lease", options->lease_s, "SECONDS",
            "How long a test goes on after this program has died, 0.1 to 2 [0.2]: longer on a computer that "
            "is busy")
        .flag("--watch", options->watch, "Go on showing the levels until Ctrl-C");
}

}  // namespace psicarve::cli
