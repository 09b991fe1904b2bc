// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "shared/machine/recording.hpp"
#include "shared/segment/segment.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/hmi/cli/program_run.hpp"
#include "tests/two_process/slow_machine.hpp"

namespace psicarve::test {

using std::chrono::milliseconds;

/// At what a host may spoil that takes the computer away for longer than a rotor coasts.
inline constexpr int kMostTries = 8;

/// A core on a segment of its own that users talk to by commands.
class Machine : public CliTest {
protected:
    ~Machine() override {
        // A core that outlived the carve that began it is no child of this process.
        if (const auto pid = core_pid()) kill(static_cast<pid_t>(*pid), SIGKILL);
    }
    void start_core(const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{"--segment", segment_};
        if (std::ranges::find(more, "--clock") == more.end())
            arguments.insert(arguments.end(), {"--clock", "virtual"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        core_ = std::make_unique<RunningProgram>("psicarve-rtcore", arguments);
        ASSERT_TRUE(eventually([&] { return core_pid().has_value(); }));
    }
    /// The pid of a core that has signed. A core that only has the lock as yet has pid 0, which kill() takes
    /// for this test and the process that runs it.
    std::optional<std::uint32_t> core_pid() const {
        const auto segment = Segment::attach(segment_);
        const auto pid = segment ? segment->core_pid() : std::nullopt;
        return pid == 0U ? std::nullopt : pid;
    }
    MachineState state() const {
        const auto segment = Segment::attach(segment_);
        if (!segment) return MachineState::off;
        const auto status = read_record(segment->header().status);
        return status ? status->state : MachineState::off;
    }
    std::string job(const std::string& layers, const std::string& points) const {
        const std::string path = file("box.job");
        const Outcome outcome =
            psicarve({"slice", box_stl("box.stl"), "-o", path, "--layers", layers, "--points", points});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
        return path;
    }
    /// Whether a program makes the machine carve; what it said when it ended instead.
    testing::AssertionResult makes_it_carve(RunningProgram& program) const {
        bool carves = false;
        const bool is_decided = eventually([&] {
            carves = state() == MachineState::carving;
            return carves || program.has_ended();
        });
        if (carves) return testing::AssertionSuccess();
        if (!is_decided) return testing::AssertionFailure() << "it neither carves nor ends";
        const int exit_code = program.wait();
        return testing::AssertionFailure() << "ended with " << exit_code << ": " << program.error();
    }
    /// What stands in the segment, as a file.
    std::string published_job() const {
        const std::string path = file("published.job");
        EXPECT_EQ(run({"snapshot", "save", path}).exit_code, 0);
        return path;
    }
    /// Takes several seconds on the virtual clock: long enough to be disturbed in the middle.
    std::string long_job() const { return job("400", "400"); }

    std::unique_ptr<RunningProgram> core_;
};

}  // namespace psicarve::test
