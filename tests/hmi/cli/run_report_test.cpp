// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/run_report.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "hmi/cli/carved_piece.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/judged_pins.hpp"
#include "tests/shared/job_fixture.hpp"

namespace psicarve::cli {
namespace {

using report::run_exit_code;
using report::run_json;
using report::verdict_of;

RunReport verified_run() {
    RunReport report;
    report.has_started = true;
    report.last.is_simulator = 1;
    report.verification.emplace();
    report.verification->ok = true;
    return report;
}

TEST(RunReport, OfRightPinsIsVerified) {
    const RunReport sut = verified_run();
    EXPECT_EQ(nlohmann::json::parse(run_json(sut))["verified"], true);
    EXPECT_NE(run_text(sut).find("verified   yes"), std::string::npos);
    EXPECT_FALSE(verdict_of(sut));
}

TEST(RunReport, OfRightPinsThatTheMachineDidNotFollowIsNot) {
    RunReport sut = verified_run();
    sut.lost_steps = "r1 stalls 3";
    const auto json = nlohmann::json::parse(run_json(sut));
    EXPECT_EQ(json["verified"], false);
    EXPECT_EQ(json["verification"]["verified"], true);  // the pins alone
    EXPECT_NE(run_text(sut).find("verified   NO"), std::string::npos);
    EXPECT_NE(run_text(sut).find("STEPS LOST: r1 stalls 3"), std::string::npos);
    ASSERT_TRUE(verdict_of(sut));
    EXPECT_EQ(run_exit_code(sut, *verdict_of(sut)), kExitDifference);
}

TEST(RunReport, SaysByHowMuchTheSimulatedMachineIsOffWhereItLostSteps) {
    const std::vector<std::byte> blob = job_blob_from_table(small_job());  // 400 pulses/mm, 6400 a turn
    machine::JobRun run;
    run.before.sim_stalls[0] = 7;
    run.after = run.before;
    run.after.position_pulses[0] = run.after.position_pulses[2] = run.after.position_pulses[3] = 5000;
    run.after.sim_true_position_pulses[0] = 4952;
    run.after.sim_true_position_pulses[2] = 5000 + 3 * 6400 + 40;
    run.after.sim_true_position_pulses[3] = 4000;  // of old: it lost nothing in this run
    const auto lost_by = [&] { return report::report_of(JobView::check(blob).value(), run).lost_steps; };
    EXPECT_EQ(lost_by(), "");
    run.after.sim_stalls[0] += 3;
    run.after.sim_timing_lost[2] = 40;
    EXPECT_EQ(lost_by(),
              "r1 stalls 3, stands -0.120 mm off, psi pulses against the driver's timing 40, stands +2.250 "
              "degrees off");
    run.after.sim_true_position_pulses[0] = 5000;
    run.after.sim_true_position_pulses[2] = 5000 - 6400;
    EXPECT_EQ(lost_by(), "r1 stalls 3, psi pulses against the driver's timing 40")
        << "it came back by itself";
}

TEST(RunReport, SaysByHowMuchTheTableIsOffAndWhichLayersThatAffects) {
    RunReport sut = verified_run();
    sut.table = {6400, 0.0};
    sut.figures.alarms.push_back({100, AlarmCause::steps_lost, 2, 4, 3, 19'200, 19'240});
    EXPECT_NE(
        run_text(sut).find("alarms     steps lost of psi at tick 100\n"
                           "lost       the table stands -2.250 degrees (-40 pulses) off; layers 3 to 6 can "
                           "be wrong\n"),
        std::string::npos)
        << run_text(sut);
    const auto alarm = nlohmann::json::parse(run_json(sut))["alarms"][0];
    EXPECT_EQ(alarm["off_deg"], -2.25);
    EXPECT_EQ(alarm["last_layer"], 6);
}

TEST(RunReport, ThatWasNotVerifiedIsNeither) {
    RunReport sut = verified_run();
    sut.verification.reset();
    sut.lost_steps = "r1 stalls 3";
    EXPECT_TRUE(nlohmann::json::parse(run_json(sut))["verified"].is_null());
}

RunReport cut_off_run() {
    RunReport report;
    report.has_started = true;
    report.figures.is_complete = true;
    add_verification(report, bad_input("the core's trace: it was cut off"));
    return report;
}

TEST(RunReport, OfPinsThatWereNotJudgedSaysWhy) {
    const RunReport sut = cut_off_run();
    EXPECT_FALSE(verdict_of(sut)) << "a job is carved all the same where others have its pins";
    EXPECT_EQ(nlohmann::json::parse(run_json(sut))["unverified_reason"], "the core's trace: it was cut off");
    EXPECT_FALSE(nlohmann::json::parse(run_json(verified_run())).contains("unverified_reason"));
}

TEST(RunReport, ThatMustBeVerifiedHasFailedWithoutThat) {
    RunReport sut = cut_off_run();
    require_verification(sut);
    ASSERT_TRUE(verdict_of(sut));
    EXPECT_EQ(verdict_of(sut)->message, "not verified: the core's trace: it was cut off");
    EXPECT_EQ(run_exit_code(sut, *verdict_of(sut)), kExitMachine);
    RunReport right = verified_run();
    require_verification(right);
    EXPECT_FALSE(verdict_of(right));
    // A recorded run that does not reach its job's end.
    RunReport part = cut_off_run();
    part.figures.is_complete = false;
    require_verification(part);
    EXPECT_FALSE(verdict_of(part));
}

TEST(RunReport, WithoutThePictureThatWasAskedForHasFailed) {
    const Profile profile;
    const auto blob = job_blob_from_table(small_job(profile));
    const auto job = JobView::check(blob);
    ASSERT_TRUE(job);
    const auto verifier = verify::Verifier::make(*job, profile);
    ASSERT_TRUE(verifier);
    RunReport sut = cut_off_run();
    add_picture(sut, *job, verifier->surface(), "");
    EXPECT_FALSE(verdict_of(sut));
    add_picture(sut, *job, verifier->surface(), "out.png");
    ASSERT_TRUE(verdict_of(sut));
    EXPECT_NE(verdict_of(sut)->message.find("out.png"), std::string::npos);
    EXPECT_NE(verdict_of(sut)->message.find("it was cut off"), std::string::npos);
}

TEST(RunReport, WithoutThePieceThatWasAskedForHasFailed) {
    PreparedJob job;
    job.blob = job_blob_from_table(small_job());
    job.view = *JobView::check(job.blob);
    const auto piece = CarvedPiece::make(job, nullptr, {.model = {}, .mesh = "out.stl", .picture = {}});
    ASSERT_TRUE(piece) << piece.error().message;
    RunReport sut = cut_off_run();
    add_piece(sut, *piece);
    ASSERT_TRUE(verdict_of(sut));
    EXPECT_NE(verdict_of(sut)->message.find("out.stl"), std::string::npos);
    EXPECT_TRUE(sut.piece_path.empty());
}

TEST(RunReport, WithoutTheComparisonThatWasAskedForHasFailed) {
    PreparedJob job;
    job.blob = job_blob_from_table(small_job());
    job.view = *JobView::check(job.blob);
    const auto piece = CarvedPiece::make(job, nullptr, {.model = "box.stl", .mesh = {}, .picture = {}});
    ASSERT_TRUE(piece) << piece.error().message;
    RunReport sut = cut_off_run();
    add_piece(sut, *piece);
    ASSERT_TRUE(verdict_of(sut));
    EXPECT_NE(verdict_of(sut)->message.find("box.stl: the piece is not known"), std::string::npos);
}

}  // namespace
}  // namespace psicarve::cli
