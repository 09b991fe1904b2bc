// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/planned_time.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <limits>
#include <string>
#include <thread>
#include <utility>

#include "hmi/machine/core_process.hpp"
#include "hmi/machine/machine_link.hpp"
#include "hmi/machine/private_segment.hpp"
#include "hmi/machine/unique_fd.hpp"

namespace psicarve::machine {
namespace {

constexpr std::chrono::milliseconds kLook{50};

std::string path_of(const UniqueFd& file) {
    return "/proc/self/fd/" + std::to_string(file.get());
}

/// Each layer's time, from the lines "layer,seconds" of the times at which layers are over.
Result<std::vector<double>> layer_seconds_in(const UniqueFd& file, std::uint32_t layer_count) {
    const std::string text = tail_of(file.get(), std::numeric_limits<std::size_t>::max());
    std::vector<double> seconds;
    double before = 0.0;
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
        const std::size_t comma = text.find(',', at);
        if (comma == std::string::npos) break;
        double until = 0.0;
        const auto read = std::from_chars(text.data() + comma + 1, text.data() + text.size(), until);
        if (read.ec != std::errc{} || *read.ptr != '\n') break;
        seconds.push_back(until - before);
        before = until;
    }
    if (seconds.size() == layer_count) return seconds;
    return Error{ErrorCode::no_core, "the core did not tell how long each layer takes"};
}

Result<std::shared_ptr<const PointPlan>> points_in(const UniqueFd& file, const JobView& job) {
    const std::string bytes = tail_of(file.get(), std::numeric_limits<std::size_t>::max());
    auto points =
        point_plan_from(std::as_bytes(std::span{bytes}), std::size_t{job.layer_count()} * job.point_count());
    if (!points) return Error{ErrorCode::no_core, "the core did not tell how long each point takes"};
    return std::make_shared<const PointPlan>(std::move(points).value());
}

}  // namespace

Result<PlannedTime> planned_time(std::span<const std::byte> blob, const JobView& job, const Profile& profile,
                                 const std::function<bool()>& goes_on, bool keeps_points) {
    const std::string toml = profile_to_toml(profile);
    const auto profile_file = open_memory_file("profile", std::as_bytes(std::span{toml}));
    if (!profile_file) return profile_file.error();
    const auto times_file = open_memory_file("layer-times");
    if (!times_file) return times_file.error();
    const auto points_file = open_memory_file("point-times");
    if (!points_file) return points_file.error();
    remove_stale_private_segments();
    CoreLaunch launch;
    launch.segment_name = private_segment_name();
    launch.is_private = true;
    launch.profile_path = path_of(*profile_file);
    launch.layer_times_path = "fd:" + std::to_string(times_file->get());
    launch.inherited_fds = {profile_file->get(), times_file->get()};
    if (keeps_points) {
        launch.point_times_path = "fd:" + std::to_string(points_file->get());
        launch.inherited_fds.push_back(points_file->get());
    }
    launch.capacity_layers = std::max(launch.capacity_layers, job.layer_count());
    launch.capacity_points = std::max(launch.capacity_points, job.point_count());
    auto core = CoreProcess::start(launch);
    if (!core) return core.error();
    auto link = MachineLink::attach(launch.segment_name);
    if (!link) return link.error();
    if (const auto taken = link->publish(blob); !taken) return taken.error();
    for (;;) {
        const auto status = link->status();
        if (!status) return status.error();
        if (status->seconds_left >= 0.0) {
            PlannedTime planned;
            planned.carve_seconds = status->seconds_left;
            auto layers = layer_seconds_in(*times_file, job.layer_count());
            if (!layers) return layers.error();
            planned.layer_seconds = std::move(*layers);
            if (keeps_points) {
                auto points = points_in(*points_file, job);
                if (!points) return points.error();
                planned.points = std::move(*points);
            }
            if (status->reference_seconds >= 0.0) planned.reference_seconds = status->reference_seconds;
            return planned;
        }
        if (goes_on && !goes_on()) return Error{ErrorCode::cancelled, "the estimate was cancelled"};
        std::this_thread::sleep_for(kLook);
    }
}

}  // namespace psicarve::machine
