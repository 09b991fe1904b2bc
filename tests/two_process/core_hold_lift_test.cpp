// SPDX-License-Identifier: GPL-3.0-or-later
// Holds that lift the heads, on a core of its own; its pins are judged like any others.
#include <fstream>

#include "hmi/trace/trace_reader.hpp"
#include "hmi/verify/verifier.hpp"
#include "tests/thoroughness.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::two_process {
namespace {

class CoreHoldLift : public CoreRig {
protected:
    verify::VerifyReport judged(const JobTable& table, const Profile& profile,
                                const std::string& trace_path) {
        const auto blob = job_blob_from_table(table);
        const auto job = JobView::check(blob);
        EXPECT_TRUE(job.has_value());
        auto verifier = verify::Verifier::make(*job, profile);
        EXPECT_TRUE(verifier.has_value());
        auto trace = verify::open_trace(trace_path);
        EXPECT_TRUE(trace.has_value());
        auto report = verify::verify_trace(*verifier, **trace);
        EXPECT_TRUE(report.has_value());
        return report ? *report : verify::VerifyReport{};
    }
};

TEST_F(CoreHoldLift, TheVerifierPassesAllFourRules) {
    for (const Planner planner : {Planner::lookahead, Planner::angle}) {
        Profile profile;
        profile.job.lifts_on_hold = true;
        profile.job.planner = planner;
        std::ofstream{file("lift.toml")} << profile_to_toml(profile);
        start_core({"--profile", file("lift.toml"), "--trace", file("lift.trace")});
        home();
        const JobTable job = lobed_job(test::is_thorough() ? 200 : 60, 101, profile);
        ASSERT_EQ(publish(job), "");
        start_carving();
        int holds = 0;
        for (unsigned i = 0; i < 5; ++i) {
            ASSERT_TRUE(eventually(
                [&] { return status().points_done > 150U * (i + 1) || status().job_end_tick != 0; }));
            if (refusal_of(CommandKind::hold) != "") break;
            ++holds;
            ASSERT_TRUE(reaches(MachineState::held));
            EXPECT_NE(status().signals & bit_of(Signal::spindle), 0U);
            ASSERT_EQ(refusal_of(CommandKind::resume), "");
        }
        EXPECT_GT(holds, 0) << "carved before it could be held";
        ASSERT_TRUE(eventually([&] { return status().job_end_tick != 0; }));
        ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
        ASSERT_EQ(core_->wait_for_exit(), 0);
        const verify::VerifyReport report = judged(job, profile, file("lift.trace"));
        EXPECT_TRUE(report.ok) << verify::report_text(report);
        EXPECT_EQ(report.points_visited, report.points_total);
        EXPECT_EQ(report.max_deviation_pulses, 0);
        segment_.reset();
        ASSERT_TRUE(Segment::remove(segment_name_));
    }
}

}  // namespace
}  // namespace psicarve::two_process
