// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/job/layer_times.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string_view>
#include <system_error>

#include "rtcore/process/words.hpp"
#include "shared/file/atomic_file.hpp"

namespace psicarve::supervisor {

constexpr std::string_view kInherited = "fd:";

std::string layer_times_csv(const plan::JobEstimate& estimate, const JobView& job) {
    std::string text = "layer,seconds\n";
    for (std::uint32_t layer = 0; layer < job.layer_count(); ++layer) {
        std::array<char, 64> line{};
        const std::uint64_t points_done = (std::uint64_t{layer} + 1) * job.point_count();
        std::snprintf(line.data(), line.size(), "%u,%.9f\n", layer, estimate.seconds_to(points_done));
        text += line.data();
    }
    return text;
}

namespace {

/// Writes to a file that the process that started us has open, each time a job comes.
Result<void> write_inherited(const char* option, const std::string& path, std::span<const std::byte> bytes) {
    int descriptor = -1;
    const char* const end = path.data() + path.size();
    const auto [stopped, error] = std::from_chars(path.data() + kInherited.size(), end, descriptor);
    const bool is_number = error == std::errc{} && stopped == end && descriptor >= 0;
    if (!is_number) {
        return Error{ErrorCode::bad_usage,
                     std::string{option} + " " + path + ": write fd:N, N being an open descriptor's number"};
    }
    const bool is_written =
        ::ftruncate(descriptor, 0) == 0 &&
        ::pwrite(descriptor, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size());
    if (is_written) return {};
    return bad_input(std::string{option} + " " + path +
                     ": cannot be written: " + std::generic_category().message(errno));
}

Result<void> write_one(const char* option, const std::string& path, std::span<const std::byte> bytes) {
    if (path.starts_with(kInherited)) return write_inherited(option, path, bytes);
    const auto written = write_file_atomically(path, bytes);
    if (written) return {};
    return Error{written.error().code, std::string{option} + " " + written.error().message};
}

}  // namespace

Result<void> write_planned(const PlannedFiles& files, const plan::JobEstimate& estimate, const JobView& job) {
    Result<void> layers;
    if (!files.layers.empty()) {
        const std::string text = layer_times_csv(estimate, job);
        layers = write_one("--layer-times", files.layers, std::as_bytes(std::span{text}));
    }
    if (files.points.empty()) return layers;
    const auto points = write_one("--point-times", files.points, point_plan_bytes(estimate.point_plan()));
    return layers ? points : layers;
}

bool LayerTimesFile::tell(const std::shared_ptr<const plan::JobEstimate>& estimate,
                          const std::shared_ptr<const LoadedJob>& job) {
    constexpr std::chrono::seconds kPatience{2};
    if (!wanted_.are_wanted() || estimate == nullptr) {
        told_ = nullptr;
        return true;
    }
    const auto now = std::chrono::steady_clock::now();
    if (estimate != told_) {
        told_ = estimate;
        begun_ = now;
        is_written_ = std::make_shared<std::atomic<bool>>(false);
        const bool is_taken = files_->do_later([wanted = wanted_, estimate, job, is_written = is_written_] {
            const auto written = write_planned(wanted, *estimate, job->view);
            if (!written) rtcore::say(written.error().message);
            is_written->store(true);
        });
        if (!is_taken) is_written_->store(true);
    }
    return is_written_->load() || now - begun_ > kPatience;
}

}  // namespace psicarve::supervisor
