// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "shared/segment/segment.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/hmi/cli/program_run.hpp"

namespace psicarve::test {

/// A core on the virtual clock, on a segment of its own, that users talk to by commands.
class CommandedCore : public CliTest {
protected:
    void start_core(const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{"--segment", segment_, "--clock", "virtual"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        core_ = std::make_unique<RunningProgram>("psicarve-rtcore", arguments);
        ASSERT_TRUE(eventually([&] {
            const auto segment = Segment::attach(segment_);
            return segment && segment->core_pid().value_or(0) != 0;
        }));
    }
    CoreStatus status() const {
        const auto segment = Segment::attach(segment_);
        const auto status = segment ? read_record(segment->header().status) : std::nullopt;
        return status.value_or(CoreStatus{});
    }
    bool reaches(MachineState state) {
        return eventually([&] { return status().state == state; });
    }
    std::string sliced_box(const std::string& layers, const std::string& points,
                           const std::vector<std::string>& more = {}) const {
        const std::string path = file("box.job");
        std::vector<std::string> words{"slice", box_stl("box.stl"), "-o",  path, "--layers",
                                       layers,  "--points",         points};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = psicarve(words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
        return path;
    }

    std::unique_ptr<RunningProgram> core_;
};

}  // namespace psicarve::test
