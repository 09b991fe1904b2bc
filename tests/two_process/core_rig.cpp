// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/two_process/core_rig.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "shared/segment/segment.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/shared/stale_segments.hpp"
#include "tests/two_process/core_process.hpp"

namespace psicarve::two_process {

JobTable lobed_job(std::uint32_t layers, std::uint32_t points, const Profile& profile) {
    JobTable table;
    table.layer_count = layers;
    table.point_count = points;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.joining = profile.job.joining;
    table.feed_mm_s = profile.job.feed_mm_s;
    table.source_name = "lobed";
    table.profile_toml = profile_to_toml(profile);
    table.report_json = "{}";
    const std::size_t row_points = points;
    table.layer_height_pulses.reserve(layers);
    table.r_left_pulses.reserve(layers * row_points);
    table.r_right_pulses.reserve(layers * row_points);
    // At the same angle of another layer both heads have the same lobes.
    struct Lobes {
        std::int64_t psi_pulses = -1;
        double left_mm = 0.0;
        double right_mm = 0.0;
    };
    std::vector<Lobes> known(2 * row_points);  // a layer is half a turn
    const auto lobe_mm = [](double angle_rad) { return 10.0 + std::cos(3.0 * angle_rad); };
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        table.layer_height_pulses.push_back(pulses_from_mm(1.0 + 0.03 * layer, profile.y.pulses_per_mm));
        for (std::uint32_t point = 0; point < points; ++point) {
            const auto psi = table_angle_pulses(table.joining, table.psi_sweep_pulses, points, layer, point);
            const std::int64_t turned_pulses = psi % profile.psi.pulses_per_rev;
            Lobes& at = known[(layer % 2) * row_points + point];
            if (at.psi_pulses != turned_pulses) {
                const double angle_rad = rad_from_pulses(turned_pulses, profile.psi.pulses_per_rev);
                at = {turned_pulses, lobe_mm(angle_rad), lobe_mm(angle_rad + kPi)};
            }
            table.r_left_pulses.push_back(static_cast<std::int32_t>(
                pulses_from_mm(at.left_mm + 0.005 * layer, profile.r1.pulses_per_mm)));
            table.r_right_pulses.push_back(static_cast<std::int32_t>(
                pulses_from_mm(at.right_mm + 0.005 * layer, profile.r2.pulses_per_mm)));
        }
    }
    return table;
}

CoreRig::CoreRig() {
    test::remove_stale_segments_once();
    static std::atomic<int> count{0};
    segment_name_ = "/" + named_after_this_process(test::kTestSegmentPrefix) + "-" + std::to_string(++count);
}

CoreRig::~CoreRig() {
    core_.reset();
    segment_.reset();
    [[maybe_unused]] const auto removed = Segment::remove(segment_name_);
}

void CoreRig::start_core(std::vector<std::string> more) {
    std::vector<std::string> arguments{"--segment", segment_name_, "--capacity",
                                       "4000x400",  "--clock",     "virtual"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    core_ = std::make_unique<CoreProcess>(arguments, file("core.err"));
    attach();
    ASSERT_TRUE(eventually([&] { return segment_->core_pid() == std::uint32_t(core_->pid()); }))
        << text_of(file("core.err"));
}

void CoreRig::attach() {
    segment_.reset();
    ASSERT_TRUE(eventually([&] {
        auto segment = Segment::attach(segment_name_);
        if (segment) segment_ = std::make_unique<Segment>(std::move(*segment));
        return segment_ != nullptr;
    })) << text_of(file("core.err"));
}

CoreStatus CoreRig::status() {
    std::optional<CoreStatus> read;
    eventually([&] {
        read = read_record(segment_->header().status);
        return read.has_value();
    });
    return read.value_or(CoreStatus{});
}

::testing::AssertionResult CoreRig::reaches(MachineState state) {
    constexpr std::chrono::seconds kToLeaveAnAlarm{5};
    using Clock = std::chrono::steady_clock;
    CoreStatus seen;
    auto last_well = Clock::now();
    // Out of an alarm no other state comes by itself: no need to wait for it.
    eventually([&] {
        seen = status();
        if (seen.state != MachineState::alarm) last_well = Clock::now();
        return seen.state == state || Clock::now() - last_well > kToLeaveAnAlarm;
    });
    if (seen.state == state) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "state is " << name_of(seen.state) << ", not " << name_of(state)
                                         << "; alarm cause: " << name_of(seen.alarm_cause);
}

std::string CoreRig::refusal_of(const Command& command) {
    const auto sent = send_command(*segment_, command, kLimit);
    return sent ? std::string{} : sent.error().message;
}

std::string CoreRig::refusal_of(CommandKind kind, double value) {
    Command command{};
    command.kind = kind;
    command.value = value;
    const auto sent = send_command(*segment_, command, kLimit);
    return sent ? std::string{} : sent.error().message;
}

std::string CoreRig::refusal_of(CommandKind kind, Axis axis) {
    Command command{};
    command.kind = kind;
    command.axis = static_cast<std::uint32_t>(axis);
    const auto sent = send_command(*segment_, command, kLimit);
    return sent ? std::string{} : sent.error().message;
}

std::string CoreRig::publish(const JobTable& table) {
    const auto generation = publish_job(*segment_, job_blob_from_table(table));
    if (!generation) return generation.error().message;
    const auto accepted = wait_for_acceptance(*segment_, *generation, kLimit);
    return accepted ? std::string{} : accepted.error().message;
}

void CoreRig::home() {
    // On the real clock a host that takes this computer away for longer than a rotor coasts is rightly an
    // alarm.
    constexpr int kMostTries = 5;
    for (int tries = 1;; ++tries) {
        ASSERT_EQ(refusal_of(CommandKind::home), "");
        const auto is_home = reaches(MachineState::ready);
        if (is_home) return;
        ASSERT_TRUE(status().alarm_cause == AlarmCause::tick_gap && tries < kMostTries) << is_home.message();
        ASSERT_EQ(refusal_of(CommandKind::reset_alarm), "");
    }
}

void CoreRig::start_carving() {
    ASSERT_EQ(refusal_of(CommandKind::start), "");
    ASSERT_TRUE(reaches(MachineState::waiting));
    ASSERT_EQ(refusal_of(CommandKind::start_interpolation), "");
}

}  // namespace psicarve::two_process
