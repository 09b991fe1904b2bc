// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <memory>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/motion_command.hpp"
#include "shared/job.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kText{
    "start", "Drives and spindle on, heads to the job's first point, wait there",
    "Waits until the machine is there. With --carve it goes on to carve and returns when "
    "carving has begun.\n"
    "After a stop or an alarm --from-layer goes on with a layer: its pulses are those of the whole run.\n"
    "With --layers it stops in order after so many layers; --from-layer goes on with the next.",
    "psicarve start --from-layer 120 --layers 1 --carve"};

constexpr std::uint32_t kMostLayer = kMaxJobCount - 1;

struct Options {
    bool carve = false;
    std::uint32_t from_layer = 0;
    std::uint32_t layers = 0;
};

Result<int> start(const CommonOptions& common, const Options& options) {
    auto link = link_to_core(common);
    if (!link) return link.error();
    MotionCommand command{CommandKind::start, {}, {MachineState::waiting}};
    command.details.value = options.from_layer;
    command.details.value2 = options.layers;
    auto status = run_motion(*link, command);
    if (status && options.carve) status = run_motion(*link, {CommandKind::start_interpolation, {}, {}});
    if (!status) return status.error();
    report_motion(common, kText.name, *status);
    return kExitDone;
}

}  // namespace

void add_start(CommandSet& commands) {
    const auto options = std::make_shared<Options>();
    commands.add(kText, [options](const CommonOptions& common) { return start(common, *options); })
        .option("--from-layer", options->from_layer, 0, kMostLayer,
                "Leave out the layers before N; the first is 0")
        .option("--layers", options->layers, 0, kMostLayer + 1, "Carve N layers; 0 carves all that follow")
        .flag("--carve", options->carve, "Begin to carve at once");
}

}  // namespace psicarve::cli
