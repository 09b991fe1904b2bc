// SPDX-License-Identifier: GPL-3.0-or-later
// A real core's trace, held against the job that it carries.
#include "hmi/session/trace_judge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "hmi/cam/prepared_job.hpp"
#include "tests/hmi/replay/recorded_run.hpp"

namespace psicarve::replay {
namespace {

using testing::HasSubstr;

class JudgedTrace : public test::RecordedRun {
protected:
    std::shared_ptr<const session::Judgement> judge(const std::string& path,
                                                    std::shared_ptr<const cam::PreparedJob> job = nullptr) {
        sut_.judge(path, std::move(job));
        EXPECT_TRUE(this->eventually([&] {
            sut_.poll();
            return !sut_.is_judging();
        }));
        return sut_.take();
    }
    static std::shared_ptr<const cam::PreparedJob> prepared(const JobTable& table) {
        Snapshot snapshot;
        snapshot.job_blob = job_blob_from_table(table);
        auto job = cam::prepare_snapshot(std::move(snapshot), "open.job");
        EXPECT_TRUE(job);
        return std::make_shared<const cam::PreparedJob>(std::move(job).value());
    }

    session::MessageLog log_;
    session::TraceJudge sut_{log_};
};

TEST_F(JudgedTrace, NeedsNoOtherFileAndIsNotHeldAgainstWhatHappensToBeOpen) {
    record();
    const auto alone = judge(whole_trace());
    ASSERT_TRUE(alone);
    EXPECT_TRUE(alone->report.ok);
    EXPECT_EQ(alone->report.points_visited, std::uint64_t{kLayers} * kPoints);
    JobTable other = two_process::lobed_job(kLayers, kPoints);
    for (std::int32_t& radius : other.r_left_pulses) radius += 100;
    const auto beside_another = judge(whole_trace(), prepared(other));
    ASSERT_TRUE(beside_another);
    EXPECT_TRUE(beside_another->report.ok);
    const auto older = judge(trace(), prepared(other));
    ASSERT_TRUE(older);
    EXPECT_FALSE(older->report.ok) << "it carries none: the open one counts";
}

TEST_F(JudgedTrace, WithoutAJobIsRefusedInOneLine) {
    record();
    EXPECT_FALSE(judge(trace()));
    EXPECT_THAT(in_english(log_.messages().back().what),
                HasSubstr("run.trace: carries no job; open its job first"));
}

}  // namespace
}  // namespace psicarve::replay
