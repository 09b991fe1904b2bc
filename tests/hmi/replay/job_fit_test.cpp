// SPDX-License-Identifier: GPL-3.0-or-later
// Whether what lies beside a trace is of the same run.
#include "hmi/replay/job_fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "hmi/replay/recording.hpp"
#include "tests/hmi/replay/recorded_run.hpp"

namespace psicarve::replay {
namespace {

using session::Check;
using test::RecordedRun;
using testing::HasSubstr;
using two_process::text_of;

class TraceNeighbour : public RecordedRun {
protected:
    void save_job(const JobTable& table, const std::string& path) {
        Snapshot snapshot;
        snapshot.job_blob = job_blob_from_table(table);
        ASSERT_TRUE(save_snapshot(snapshot, path));
    }
    std::unique_ptr<Recording> open(const std::string& path, const std::string& job_path = {}) {
        auto opened = open_recording({path, job_path, Profile{}}, {});
        EXPECT_TRUE(opened) << opened.error().message;
        return opened ? std::move(*opened) : nullptr;
    }
    JobFit fit_of(const JobTable& table) {
        save_job(table, file("judged.job"));
        auto snapshot = load_snapshot(file("judged.job"));
        EXPECT_TRUE(snapshot);
        const auto job = cam::prepare_snapshot(std::move(*snapshot), "judged.job");
        EXPECT_TRUE(job);
        const auto index = TraceIndex::build(trace(), job->profile, {});
        EXPECT_TRUE(index);
        const auto geometry = verify::JobGeometry::make(job->view, job->profile);
        EXPECT_TRUE(geometry);
        const auto fit = job_fit(*index, *geometry);
        EXPECT_TRUE(fit);
        return *fit;
    }
    static JobTable own() { return two_process::lobed_job(kLayers, kPoints); }
    /// A tenth of a millimetre further out everywhere.
    static JobTable wider() {
        JobTable table = own();
        const auto pulses = static_cast<std::int32_t>(pulses_from_mm(0.1, Profile{}.r1.pulses_per_mm));
        for (std::int32_t& radius : table.r_left_pulses) radius += pulses;
        for (std::int32_t& radius : table.r_right_pulses) radius += pulses;
        return table;
    }
    static Check job_row(const Recording& recording) {
        for (const Check& row : recording.facts().contents) {
            if (in_english(row.name) == "Job") return row;
        }
        return {};
    }
};

TEST_F(TraceNeighbour, FitsWhatItsHeadsDidAndNothingElse) {
    record();
    const JobFit its = fit_of(own());
    EXPECT_GT(its.places, 100U);
    EXPECT_GT(its.fitting * 10, its.places * 9) << its.fitting << " of " << its.places;
    EXPECT_TRUE(its.is_its_job());
    const JobFit wider_fit = fit_of(wider());
    EXPECT_TRUE(wider_fit.is_known());
    EXPECT_FALSE(wider_fit.is_its_job()) << wider_fit.fitting << " of " << wider_fit.places;
    JobTable higher = own();
    for (std::int64_t& height : higher.layer_height_pulses)
        height += (higher.layer_height_pulses[1] - higher.layer_height_pulses[0]) / 2;
    EXPECT_FALSE(fit_of(higher).is_its_job());
    JobTable turned = own();  // every other layer the other way round
    turned.joining = Joining::zigzag;
    EXPECT_FALSE(fit_of(turned).is_its_job()) << "half of it is the same";
}

TEST_F(TraceNeighbour, OfAnotherRunIsNotTakenAndThatIsSaid) {
    record();
    save_job(wider(), file("run.snap"));
    auto sut = open(trace());
    EXPECT_FALSE(sut->facts().job);
    ASSERT_EQ(sut->facts().warnings.size(), 1U);
    EXPECT_EQ(in_english(sut->facts().warnings[0]),
              "run.snap lies beside this trace, but is of another run: it is not used");
    EXPECT_EQ(job_row(*sut).verdict, Check::Verdict::fail);
    EXPECT_EQ(in_english(job_row(*sut).detail), "none: not run.snap");
    std::filesystem::copy_file(job(), file("run.job"));
    sut = open(trace());
    ASSERT_TRUE(sut->facts().job) << "the next neighbour is its own";
    EXPECT_EQ(sut->facts().warnings.size(), 1U);
    EXPECT_EQ(job_row(*sut).verdict, Check::Verdict::pass);
    EXPECT_EQ(in_english(job_row(*sut).detail), "run.job, checked");
}

TEST_F(TraceNeighbour, ThatCannotBeReadIsSaid) {
    record();
    std::ofstream(file("run.job"), std::ios::binary) << "no job";
    const auto sut = open(trace());
    EXPECT_FALSE(sut->facts().job);
    ASSERT_EQ(sut->facts().warnings.size(), 1U);
    EXPECT_THAT(in_english(sut->facts().warnings[0]), HasSubstr("run.job"));
}

TEST_F(TraceNeighbour, ThatWasAskedForIsTakenWithAWarning) {
    record();
    save_job(wider(), file("other_run.job"));
    const auto sut = open(trace(), file("other_run.job"));
    EXPECT_TRUE(sut->facts().job);
    ASSERT_EQ(sut->facts().warnings.size(), 1U);
    EXPECT_THAT(in_english(sut->facts().warnings[0]), HasSubstr("other_run.job is not this trace's job"));
    EXPECT_EQ(job_row(*sut).verdict, Check::Verdict::fail);
}

TEST_F(TraceNeighbour, OfATraceThatCarvesNothingIsTakenUnchecked) {
    record();
    std::filesystem::copy_file(job(), file("cut.job"));
    const std::string whole = text_of(trace());
    std::ofstream(file("cut.trace"), std::ios::binary) << whole.substr(0, 2000);  // homing
    const auto sut = open(file("cut.trace"));
    EXPECT_TRUE(sut->facts().job);
    EXPECT_EQ(job_row(*sut).verdict, Check::Verdict::info);
    EXPECT_THAT(in_english(job_row(*sut).detail), HasSubstr("not checked"));
}

}  // namespace
}  // namespace psicarve::replay
