// SPDX-License-Identifier: GPL-3.0-or-later
// Carving in passes that come by each other's begins.
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>

#include "tests/hmi/verify/verify_fixture.hpp"

namespace psicarve::verify {
namespace {

constexpr std::uint32_t kPassPoints = 21;
constexpr std::uint32_t kPassLayers = 4;

/// Two layers roughed, and finished at the same heights.
SampleJob job_of_two_passes() {
    SampleJob job(Profile{}, kPassLayers, kPassPoints, Joining::continuous,
                  [](double, double layer) { return layer < 1.5 ? 10.0 : 8.0; });
    const JobView view = job.view();
    JobTable table;
    table.layer_count = kPassLayers;
    table.point_count = kPassPoints;
    table.psi_sweep_pulses = view.psi_sweep_pulses();
    table.joining = Joining::continuous;
    table.feed_mm_s = job.profile.job.feed_mm_s;
    table.source_name = "passes.stl";
    table.profile_toml = profile_to_toml(job.profile);
    table.report_json = "{}";
    table.layer_height_pulses = {100, 180, 100, 180};
    for (std::uint32_t layer = 0; layer < kPassLayers; ++layer) {
        table.r_left_pulses.insert(table.r_left_pulses.end(), view.r_left_pulses(layer).begin(),
                                   view.r_left_pulses(layer).end());
        table.r_right_pulses.insert(table.r_right_pulses.end(), view.r_right_pulses(layer).begin(),
                                    view.r_right_pulses(layer).end());
    }
    JobPass roughing{};
    roughing.kind = static_cast<std::uint32_t>(PassKind::roughing);
    roughing.number = 1;
    roughing.layer_count = 2;
    roughing.allowance_mm = 2.0;
    JobPass finishing{};
    finishing.kind = static_cast<std::uint32_t>(PassKind::finishing);
    finishing.number = 2;
    finishing.first_layer = 2;
    finishing.layer_count = 2;
    table.passes = {roughing, finishing};
    job.blob = job_blob_from_table(table);
    return job;
}

/// Carves the job of two passes as a core does: each layer from outside, going in with the finishing pass
/// once in vain. `wrong_step`: a point of the first layer behind which R1 leaves its line.
PerfectMachine carved_passes(const SampleJob& job, std::optional<std::uint32_t> wrong_step = {}) {
    const JobView view = job.view();
    PerfectMachine machine(job);
    const auto out = [&] { machine.line({24000 - machine.position[0], 24000 - machine.position[1], 0, 0}); };
    const auto go_in = [&](std::uint32_t layer) {
        out();
        machine.move(Axis::psi, view.psi_pulses(layer, 0) - machine.position[2]);
        machine.move(Axis::y, view.y_pulses(layer, 0) - machine.position[3]);
        machine.set(Signal::spindle, true);
        machine.line({view.r_left_pulses(layer)[0] - machine.position[0],
                      view.r_right_pulses(layer)[0] - machine.position[1], 0, 0});
    };
    out();
    for (const Axis axis : kAllAxes) machine.set(enable_of(axis), true);
    go_in(0);
    for (std::uint32_t step = 1; step < kPassPoints; ++step) {
        machine.to_point(0, step);
        if (step != wrong_step) continue;
        machine.line({0, 0, 40, 0});
        machine.move(Axis::r1, -60).move(Axis::r1, 60);
    }
    go_in(1);
    machine.layer(1);
    go_in(2);
    machine.finish();
    go_in(2);
    machine.layer(2);
    go_in(3);
    machine.layer(3).finish();
    return machine;
}

// Heads that go in together to the finishing pass come by the place where roughing begins: nothing has begun
// there, and what was wrong in the attempt before stays so.
TEST(AttemptsOfPasses, ThatComeByAnothersBeginForgetNothing) {
    const SampleJob job = job_of_two_passes();
    for (const bool is_wrong : {false, true}) {
        const PerfectMachine machine =
            carved_passes(job, is_wrong ? std::optional<std::uint32_t>(7) : std::nullopt);
        const VerifyReport report = verified(job, machine);
        EXPECT_EQ(report.ok, !is_wrong) << report_text(report);
        EXPECT_EQ(report.points_visited, report.points_total);
    }
}

// The same where roughing alone is judged: it stays complete, and took as long as it did.
TEST(AttemptsOfPasses, ThatComeByTheBeginOfOneThatIsDoneLeaveItSo) {
    const SampleJob job = job_of_two_passes();
    const PerfectMachine machine = carved_passes(job);
    const VerifyReport roughing = verified(job, machine, {0, 2});
    EXPECT_TRUE(roughing.ok) << report_text(roughing);
    EXPECT_EQ(roughing.points_visited, 2U * kPassPoints);
    EXPECT_GT(roughing.carve_seconds, 1.0);
    const VerifyReport wrong = verified(job, carved_passes(job, 7), {0, 2});
    EXPECT_FALSE(wrong.ok);
    EXPECT_GT(wrong.carve_seconds, 1.0);
    EXPECT_EQ(first_of(wrong, 1).fault, "off-the-line");
}

// On their way out from the finishing pass the heads come by the place where roughing's last layer begins:
// nothing begins there either.
TEST(AttemptsOfPasses, ThatAreJudgedAloneDoNotBeginWhereHeadsGoOut) {
    const SampleJob job = job_of_two_passes();
    const JobView view = job.view();
    PerfectMachine machine = carved_passes(job);
    ASSERT_EQ(view.y_pulses(1, 0), view.y_pulses(3, 0));
    const std::int64_t rev = job.profile.psi.pulses_per_rev;
    ASSERT_EQ((view.psi_pulses(1, 0) - view.psi_pulses(3, 0)) % rev, 0);
    for (const LayerRange& range : {LayerRange{0, 2}, LayerRange{1, 1}, LayerRange{2, 2}, LayerRange{3, 1}}) {
        const VerifyReport report = verified(job, machine, range);
        EXPECT_TRUE(report.ok) << report_text(report);
    }
    machine.set(Signal::spindle, true);
    machine.move(Axis::psi, view.psi_pulses(3, 0) - machine.position[2]);
    machine.move(Axis::y, view.y_pulses(3, 0) - machine.position[3]);
    const auto to = [&](std::uint32_t layer, std::int64_t outward) {
        machine.line({view.r_left_pulses(layer)[0] + outward - machine.position[0],
                      view.r_right_pulses(layer)[0] + outward - machine.position[1], 0, 0});
    };
    to(3, 0);
    to(1, 2000);
    machine.move(Axis::psi, 700).finish();
    const VerifyReport report = verified(job, machine, {0, 2});
    EXPECT_TRUE(report.ok) << report_text(report);
}

}  // namespace
}  // namespace psicarve::verify
