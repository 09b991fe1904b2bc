// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/job_facts.hpp"

#include <gtest/gtest.h>

#include <string>

#include "hmi/scene/radius_map.hpp"
#include "tests/shared/job_fixture.hpp"
#include "tests/shared/passes_fixture.hpp"

namespace psicarve::session {
namespace {

std::vector<std::byte> job_that_says(const std::string& report) {
    JobTable table;
    table.layer_count = 2;
    table.point_count = 2;
    table.psi_sweep_pulses = 600;
    table.feed_mm_s = 20.0;
    table.joining = Joining::zigzag;
    table.layer_height_pulses = {400, 500};
    table.r_left_pulses = {1000, 1000, 1000, 1000};
    table.r_right_pulses = {1000, 1000, 1000, 1000};
    table.report_json = report;
    table.profile_toml = profile_to_toml(Profile{});
    return job_blob_from_table(table);
}

std::string said(const std::vector<FactRow>& rows) {
    std::string text;
    for (const FactRow& row : rows) text += in_english(row.name) + ": " + in_english(row.value) + "\n";
    return text;
}

TEST(JobFacts, AreThoseOfTheSlicersReport) {
    const auto blob = job_that_says(R"({"triangles":248312,"undercut_share":0.038,"open_points":4})");
    const JobFacts sut = job_facts(JobView::check(blob).value());
    EXPECT_EQ(said(fact_rows(sut, 12'400'000)),
              "Source size: 12.4 MB, 248\u2009312 faces\nJoining: zigzag\nUndercut: 3.8 % of the surface\n"
              "Open points: 4\n");
}

TEST(JobFacts, AreNotMadeUpWhereAJobDoesNotSay) {
    for (const char* report : {"", "[]", R"({"triangles":-1,"undercut_share":"much"})"}) {
        const auto blob = job_that_says(report);
        const JobFacts sut = job_facts(JobView::check(blob).value());
        EXPECT_EQ(said(fact_rows(sut, 0)), "Source size: –\nJoining: zigzag\nUndercut: –\nOpen points: –\n")
            << report;
    }
}

TEST(JobFacts, TellThePassesAndWhichIsCarved) {
    JobTable table = small_job({}, 6);
    table.layer_height_pulses = {100, 120, 100, 100, 110, 120};
    const auto told = [&](std::optional<std::uint32_t> layer) {
        const auto blob = job_blob_from_table(table);
        return in_english(pass_phrase(JobView::check(blob).value(), layer));
    };
    EXPECT_EQ(told({}), "");
    EXPECT_EQ(told(2), "");
    set_passes(table, {2, 1, 3});
    EXPECT_EQ(told({}), "2 roughing, finishing");
    EXPECT_EQ(told(1), "roughing 1 of 2");
    EXPECT_EQ(told(2), "roughing 2 of 2");
    EXPECT_EQ(told(3), "finishing pass");
    EXPECT_EQ(told(6), "2 roughing, finishing");
}

TEST(RadiusMap, IsOfTheFinishingPassWhereverALayerIs) {
    cam::PreparedJob job;
    JobTable table = small_job({}, 6);
    table.layer_height_pulses = {100, 120, 110, 100, 110, 120};
    for (std::size_t i = 0; i < std::size_t{3} * table.point_count; ++i)
        table.r_left_pulses[i] = table.r_right_pulses[i] = 8000;
    set_passes(table, {2, 1, 3});
    job.blob = job_blob_from_table(table);
    job.view = JobView::check(job.blob).value();
    EXPECT_EQ(radius_map(job, 8, 8).rows, 3U);
    EXPECT_EQ(radius_map(job, 8, 8).most_mm, 11.0);
    const std::vector<double> wanted{0.5, 2.5, 1.5, 0.5, 1.5, 2.5};
    for (std::uint32_t layer = 0; layer < 6; ++layer)
        EXPECT_DOUBLE_EQ(place_in_map(job.view, layer), wanted[layer] / 3.0) << layer;
}

TEST(JobFacts, TellWhatBoundsTheTimeMost) {
    cam::LeastTime least;
    EXPECT_EQ(in_english(bound_phrase(least)), "–");
    least.feed_seconds = 18.0;
    least.axis_seconds[index_of(Axis::r2)] = 71.0;
    least.axis_seconds[index_of(Axis::psi)] = 11.0;
    EXPECT_EQ(in_english(bound_phrase(least)), "R2 71 %, feed 18 %");
    least.feed_seconds = 98.0;
    least.axis_seconds[index_of(Axis::r2)] = 2.0;
    least.axis_seconds[index_of(Axis::psi)] = 0.0;
    EXPECT_EQ(in_english(bound_phrase(least)), "feed 98 %");
}

}  // namespace
}  // namespace psicarve::session
