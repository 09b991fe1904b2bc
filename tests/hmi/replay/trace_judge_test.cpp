// SPDX-License-Identifier: GPL-3.0-or-later
// A real core's trace, held against the job that it carries.
#include "hmi/session/trace_judge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <thread>

#include "hmi/cam/prepared_job.hpp"
#include "shared/job/job.hpp"
#include "shared/trace/trace_format.hpp"
#include "tests/hmi/replay/recorded_run.hpp"

namespace psicarve::replay {
namespace {

using testing::HasSubstr;

class JudgedTrace : public test::RecordedRun {
protected:
    std::shared_ptr<const session::Judgement> judge(const std::string& path,
                                                    std::shared_ptr<const cam::PreparedJob> job = nullptr,
                                                    const verify::AskedCarving& asked = {}) {
        sut_.judge(path, std::move(job), asked);
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

TEST_F(JudgedTrace, IsJudgedByWhatWasAskedForAndSaysSo) {
    record();
    const auto says = [&](const verify::AskedCarving& asked) {
        const auto judged = judge(whole_trace(), nullptr, asked);
        std::string text;
        if (judged) {
            for (const session::VerdictRow& row : session::verdict_rows(judged->report))
                text += in_english(row.name) + ": " + in_english(row.value) + "\n";
        }
        return text;
    };
    EXPECT_THAT(says({}), HasSubstr("Judged: the whole job\n"));
    const std::string last = std::to_string(kLayers);
    EXPECT_THAT(says({{1, 0, {}}}), HasSubstr("Judged: layers 2 to " + last + "\n"));
    EXPECT_THAT(says({{1, 0, 3}}), HasSubstr("Judged: layers 2 to " + last + ", from point 4 on\n"));
    EXPECT_THAT(says({{}, false, false}), HasSubstr("Judged: the pulses of a dry run\n"));
}

TEST_F(JudgedTrace, WithADamagedJobTakesTheOneThatIsOpen) {
    record();
    std::string bytes = two_process::text_of(whole_trace());
    const auto blob = job_blob_from_table(two_process::lobed_job(kLayers, kPoints));
    const std::size_t at = bytes.find(std::string(reinterpret_cast<const char*>(blob.data()), blob.size()));
    ASSERT_NE(at, std::string::npos);
    bytes[at + blob.size() / 2] ^= 0x10;
    std::ofstream(trace(), std::ios::binary) << bytes;
    EXPECT_FALSE(judge(trace()));
    EXPECT_THAT(in_english(log_.messages().back().what), HasSubstr("the job that it carries is damaged"));
    const auto judged = judge(trace(), prepared(two_process::lobed_job(kLayers, kPoints)));
    ASSERT_TRUE(judged);
    EXPECT_TRUE(judged->report.ok);
}

TEST_F(JudgedTrace, OfSeveralJobsIsJudgedByTheOpenOneOrNone) {
    record();
    const std::string bytes = two_process::text_of(whole_trace());
    const std::string before = "abc";
    std::array<std::uint8_t, kTraceRecordMaxBytes> room{};
    const auto* const end =
        encode_trace_job_head(room.data(), before.size(), job_checksum(std::as_bytes(std::span{before})));
    const std::string head(reinterpret_cast<const char*>(room.data()),
                           static_cast<std::size_t>(end - room.data()));
    std::ofstream(trace(), std::ios::binary)
        << bytes.substr(0, sizeof(TraceHeader)) + head + before + bytes.substr(sizeof(TraceHeader));
    EXPECT_FALSE(judge(trace()));
    EXPECT_THAT(in_english(log_.messages().back().what),
                HasSubstr("run.trace: carries several jobs; open the one that is meant"));
    const auto judged = judge(trace(), prepared(two_process::lobed_job(kLayers, kPoints)));
    ASSERT_TRUE(judged);
    EXPECT_TRUE(judged->report.ok);
}

TEST_F(JudgedTrace, WithoutAJobIsRefusedInOneLine) {
    record();
    EXPECT_FALSE(judge(trace()));
    EXPECT_THAT(in_english(log_.messages().back().what),
                HasSubstr("run.trace: carries no job; open its job first"));
}

}  // namespace
}  // namespace psicarve::replay
