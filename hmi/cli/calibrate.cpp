// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "hmi/cli/calibration_talk.hpp"
#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/cli/motion_command.hpp"
#include "hmi/cli/number_argument.hpp"
#include "hmi/cli/saved_draft.hpp"
#include "hmi/profile/calibration.hpp"
#include "hmi/profile/calibration_steps.hpp"

namespace psicarve::cli {
namespace {

using profile::ProfileDraft;

constexpr CommandText kCalibrateText{
    "calibrate", "Measure the two heads, so that their halves meet",
    "Writes what was measured into the machine's profile (--profile), whose old state becomes FILE.bak.\n"
    "Without a measurement on the command line it asks, step by step.\n"
    "--r1-at and --r2-at: where the head is shown to stand while its tip touches the pin, or here.",
    "psicarve calibrate --profile machine.toml\n"
    "  psicarve calibrate --profile machine.toml --pin-diameter 6 --r1-at here\n"
    "  psicarve calibrate --profile machine.toml --blank-diameter 40 --mark-around -0.35 --mark-up 0.2\n"
    "  psicarve calibrate --profile machine.toml --r2-wear 0.04"};

struct CalibrateOptions {
    std::optional<double> pin_diameter_mm;
    std::string r1_at;
    std::string r2_at;
    std::optional<double> blank_diameter_mm;
    std::string mark_around;
    std::string mark_up;
    std::string r1_wear;
    std::string r2_wear;
    bool guided = false;

    bool has_measurement() const {
        return pin_diameter_mm || blank_diameter_mm ||
               !(r1_at + r2_at + mark_around + mark_up + r1_wear + r2_wear).empty();
    }
};

Error wrong_usage(const std::string& text) {
    return Error{ErrorCode::bad_usage, "calibrate: " + text};
}

Result<double> counted_place(const CommonOptions& common, const ProfileDraft& draft, Axis head) {
    auto link = link_to_core(common);
    if (!link) return link.error();
    const auto status = link->status();
    if (!status) return status.error();
    const auto on_file = load_profile(draft.path());
    if (!on_file) return on_file.error();
    return profile::counted_place_mm(draft.path(), *on_file,
                                     link->segment().header().core_profile_hash.load(), *status, head);
}

Result<void> touch_off(ProfileDraft& draft, const CommonOptions& common, const CalibrateOptions& options,
                       Axis head) {
    const std::string& at = head == Axis::r2 ? options.r2_at : options.r1_at;
    if (at.empty()) return {};
    if (!options.pin_diameter_mm) return wrong_usage("--pin-diameter says what the tip touches");
    const auto counted_mm = at == "here" ? counted_place(common, draft, head)
                                         : number_argument(head == Axis::r2 ? "--r2-at" : "--r1-at", at);
    if (!counted_mm) return counted_mm.error();
    return profile::touch_off(draft, head, *options.pin_diameter_mm, *counted_mm);
}

Result<void> two_marks(ProfileDraft& draft, const CalibrateOptions& options) {
    const bool has_ways = !options.mark_around.empty() && !options.mark_up.empty();
    if (!options.blank_diameter_mm && options.mark_around.empty() && options.mark_up.empty()) return {};
    if (!options.blank_diameter_mm || !has_ways)
        return wrong_usage("two marks take --blank-diameter, --mark-around and --mark-up");
    const auto around_mm = number_argument("--mark-around", options.mark_around);
    if (!around_mm) return around_mm.error();
    const auto up_mm = number_argument("--mark-up", options.mark_up);
    if (!up_mm) return up_mm.error();
    return profile::two_marks(draft, *options.blank_diameter_mm, *around_mm, *up_mm);
}

Result<void> wear(ProfileDraft& draft, const CalibrateOptions& options, Axis head) {
    const std::string& text = head == Axis::r2 ? options.r2_wear : options.r1_wear;
    if (text.empty()) return {};
    const auto wear_mm = number_argument(head == Axis::r2 ? "--r2-wear" : "--r1-wear", text);
    if (!wear_mm) return wear_mm.error();
    return profile::tool_wear(draft, head, *wear_mm);
}

Result<void> take_options(ProfileDraft& draft, const CommonOptions& common, const CalibrateOptions& options) {
    if (options.pin_diameter_mm && options.r1_at.empty() && options.r2_at.empty())
        return wrong_usage("--r1-at or --r2-at says where the tip touches the pin");
    for (const Axis head : {Axis::r1, Axis::r2}) {
        if (auto done = touch_off(draft, common, options, head); !done) return done;
    }
    if (auto done = two_marks(draft, options); !done) return done;
    for (const Axis head : {Axis::r1, Axis::r2}) {
        if (auto done = wear(draft, options, head); !done) return done;
    }
    return {};
}

Result<int> calibrate(const CommonOptions& common, const CalibrateOptions& options) {
    const std::string path = chosen_profile_path(common);
    if (path.empty())
        return wrong_usage(
            "--profile says which file is written; psicarve profile show > machine.toml makes one");
    const bool is_talk = options.guided || !options.has_measurement();
    if (options.guided && options.has_measurement())
        return wrong_usage("--guided asks for the measurements; give none");
    if (is_talk && !options.guided && ::isatty(STDIN_FILENO) == 0)
        return wrong_usage("no measurement is given and nobody is there to ask; see --help, or --guided");
    auto draft = ProfileDraft::open(path);
    if (!draft) return draft.error();
    if (const auto whole = draft->profile(); !whole) return whole.error();
    const auto place_of = [&](Axis head) { return counted_place(common, *draft, head); };
    const auto taken = is_talk ? talk_calibration(*draft, place_of) : take_options(*draft, common, options);
    if (!taken) return taken.error();
    return save_draft(*draft, common);
}

}  // namespace

void add_calibrate(CommandSet& commands) {
    const auto options = std::make_shared<CalibrateOptions>();
    commands
        .add(kCalibrateText, [options](const CommonOptions& common) { return calibrate(common, *options); })
        .option("--pin-diameter", options->pin_diameter_mm, "MM", "Diameter of the pin on the axis")
        .option("--r1-at", options->r1_at, "MM|here", "Where R1 is shown to stand, its tip at the pin")
        .option("--r2-at", options->r2_at, "MM|here", "Likewise R2")
        .option("--blank-diameter", options->blank_diameter_mm, "MM", "Of the blank with the two marks")
        .option("--mark-around", options->mark_around, "MM",
                "From R1's mark to R2's along the surface, counter-clockwise from above is positive")
        .option("--mark-up", options->mark_up, "MM", "How much higher R2's mark is")
        .option("--r1-wear", options->r1_wear, "MM", "How much shorter R1's tool is since its touch-off")
        .option("--r2-wear", options->r2_wear, "MM", "Likewise R2")
        .flag("--guided", options->guided, "Ask, also when the answers come from a file");
}

}  // namespace psicarve::cli
