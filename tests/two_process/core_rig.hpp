// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "shared/base/units.hpp"
#include "shared/job/job.hpp"
#include "shared/record/snapshot_file.hpp"
#include "shared/segment/segment.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/shared/temporary_folder.hpp"
#include "tests/thoroughness.hpp"
#include "tests/two_process/core_process.hpp"

namespace psicarve::two_process {

using std::chrono::milliseconds;

/// Generous: a sanitizer on a busy machine. Nothing is judged by how long it takes.
inline constexpr milliseconds kLimit{120'000};

/// A job that is no body of revolution, for the machine of `profile`.
JobTable lobed_job(std::uint32_t layers, std::uint32_t points, const Profile& profile = Profile{});

/// So long that a test can interfere while it is carved, however busy the computer is. A sanitizer's core
/// takes three times as long for each layer, at least.
inline constexpr std::uint32_t kLongLayers = test::kIsSanitized ? 2000 : 4000;
inline JobTable long_job(const Profile& profile = Profile{}) {
    return lobed_job(kLongLayers, 201, profile);
}

/// A segment of its own for each test, and cores on it.
class CoreRig : public ::testing::Test {
protected:
    CoreRig();
    ~CoreRig() override;

    std::string file(const std::string& name) const { return folder_.path(name); }

    void start_core(std::vector<std::string> more = {});
    void attach();

    template <typename Condition>
    static bool eventually(Condition condition, milliseconds limit = kLimit) {
        // What comes after a failure comes at once or not at all.
        if (::testing::Test::HasFatalFailure()) limit = std::min(limit, milliseconds{2000});
        const auto end = std::chrono::steady_clock::now() + limit;
        while (!condition()) {
            if (std::chrono::steady_clock::now() > end) return false;
            std::this_thread::sleep_for(milliseconds{1});
        }
        return true;
    }

    CoreStatus status();
    ::testing::AssertionResult reaches(MachineState state);
    std::string refusal_of(CommandKind kind, Axis axis = Axis::r1);
    std::string refusal_of(CommandKind kind, double value);
    std::string refusal_of(const Command& command);
    std::string publish(const JobTable& table);
    void home();
    void start_carving();

    std::string segment_name_;
    test::TemporaryFolder folder_;
    std::unique_ptr<Segment> segment_;
    std::unique_ptr<CoreProcess> core_;
};

}  // namespace psicarve::two_process
