// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <memory>
#include <string>

#include "hmi/cli/checkpoint_text.hpp"
#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/go_on_text.hpp"
#include "hmi/cli/motion_command.hpp"
#include "hmi/cli/unfinished_look.hpp"
#include "hmi/cli/unfinished_text.hpp"
#include "shared/job/job.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kStartText{
    "start", "Drives and spindle on, heads to the job's first point, wait there",
    "Waits until the machine is there. With --carve it goes on to carve and returns when "
    "carving has begun.\n"
    "After a stop, an alarm or a crash of the core --resume goes on behind the last finished layer, with\n"
    "the last good point of the next where that is known, and\n"
    "--from-layer with any other: its pulses are those of the whole run.\n"
    "--from-point goes on within that layer: the heads go in at that very point.\n"
    "With --layers it stops in order after so many layers; --from-layer goes on with the next.",
    "psicarve start --resume --carve\n  psicarve start --from-layer 120 --layers 1 --carve\n"
    "  psicarve start --from-layer 120 --from-point 300 --carve"};

constexpr std::uint32_t kMostLayer = kMaxJobCount - 1;
constexpr std::uint32_t kMostPoint = kMaxJobCount - 1;
constexpr std::uint32_t kFromBegin = ~std::uint32_t{0};

struct StartOptions {
    bool carve = false;
    bool resume = false;
    bool dry_run = false;
    std::uint32_t from_layer = 0;
    std::uint32_t from_point = kFromBegin;
    std::uint32_t layers = 0;
    std::string state_folder;
};

/// Nothing was carved since: the operator must see that the record is of this piece, and not of one of last
/// month.
void tell_disk_source(machine::MachineLink& link, const StartOptions& options) {
    const auto checkpoint = link.checkpoint();
    if (!checkpoint || !checkpoint->is_from_disk()) return;
    // The end of the run before comes from a disk, too.
    const bool is_by_it =
        options.resume || (options.from_layer != 0 && options.from_layer == checkpoint->earlier_layer);
    if (!is_by_it || options.dry_run) return;
    UnfinishedLook look{options.state_folder};
    const auto& found = look.look(link.segment_name(), checkpoint->is_simulated(),
                                  link.segment().core_keeping(), kDiskPatience);
    const std::string unknown = "where the piece goes on is known from a disk that ";
    if (look.is_silent()) return print_warning(unknown + "does not answer now: of when is not known");
    // Another core's record says nothing about this one's piece.
    if (!found || found->keeper == Keeper::other_core)
        return print_warning(unknown + "was not looked at, or tells of none by now: of when is not known");
    if (!is_same_place(found->saved.checkpoint, *checkpoint))
        return print_warning(unknown + "tells of another piece or layer by now: of when is not known");
    const bool is_other_core = link.segment().header().core_profile_hash.load() != found->saved.profile_hash;
    const std::string source = "goes on by " + disk_source_text(*found, is_other_core);
    if (is_other_core) return print_warning(source);
    print_note(source);
}

/// A start that resumes goes on within a layer where it can.
void tell_point(const machine::MachineLink& link, const StartOptions& options) {
    if (!options.resume) return;
    if (const auto place = place_to_go_on(link))
        print_note("goes on within layer " + std::to_string(place->layer) + ", with its point " +
                   std::to_string(place->point));
}

Result<int> start(const CommonOptions& common, const StartOptions& options) {
    auto link = link_to_core(common);
    if (!link) return link.error();
    if (const std::string remark = in_words(current_remarks(link->job_remarks(), link->checkpoint()));
        !remark.empty())
        print_warning(remark);
    tell_disk_source(*link, options);
    tell_point(*link, options);
    MotionCommand command{CommandKind::start, {}, {MachineState::waiting}};
    command.details.value = options.from_layer;
    command.details.value2 = options.layers;
    if (options.from_point != kFromBegin) set_start_point(command.details, options.from_point);
    command.details.axis =
        (options.resume ? kStartResumes | kStartResumesWithin : 0) | (options.dry_run ? kStartsDry : 0);
    auto status = run_motion(*link, command);
    if (status && options.carve) status = run_motion(*link, {CommandKind::start_interpolation, {}, {}});
    if (!status) return status.error();
    report_motion(common, kStartText.name, *status);
    return kExitDone;
}

}  // namespace

void add_start(CommandSet& commands) {
    const auto options = std::make_shared<StartOptions>();
    commands.add(kStartText, [options](const CommonOptions& common) { return start(common, *options); })
        .option("--from-layer", options->from_layer, 0, kMostLayer,
                "Leave out the layers before N; the first is 0")
        .option("--from-point", options->from_point, 0, kMostPoint,
                "And of that layer the points before N, as status counts them; the first is 0")
        .option("--layers", options->layers, 0, kMostLayer + 1, "Carve N layers; 0 carves all that follow")
        .flag("--resume", options->resume, "Go on behind the last layer that was finished")
        .excludes("--resume", "--from-layer")
        .excludes("--resume", "--from-point")
        .option("--state", options->state_folder, "FOLDER",
                "Where the core keeps what is unfinished, if it was given --state")
        .flag("--dry-run", options->dry_run,
              "Heads stay outside the blank, spindle off; table and Y go as they would")
        .flag("--carve", options->carve, "Begin to carve at once");
}

}  // namespace psicarve::cli
