// SPDX-License-Identifier: GPL-3.0-or-later
// What a window knows of a program that a real core runs, after a job.
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>

#include "hmi/session/carving_watch.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/session/lost_core.hpp"
#include "shared/segment/segment_program.hpp"
#include "tests/hmi/session/session_rig.hpp"

namespace psicarve::session {
namespace {

using S = MachineState;
using std::chrono::milliseconds;

class ProgramOnCore : public test::SessionRig {
protected:
    /// Also what is carved is looked at, as a window does.
    template <typename Condition>
    bool becomes_true(Condition condition) {
        return comes_true([&] {
            if (watch_) watch_->refresh();
            return condition();
        });
    }
    void carve_a_job() {
        ASSERT_NO_FATAL_FAILURE(open_and_publish(two_process::lobed_job(3, 33)));
        home_session();
        watch_.emplace(*session_, *desk_);
        ASSERT_TRUE(becomes_true([&] { return watch_->record() != nullptr; }));
        session_->start(0);
        ASSERT_TRUE(becomes_true([&] {
            const auto& status = session_->view().status;
            return status->points_done == status->points_total && status->state == S::ready &&
                   status->job_end_tick != 0;
        }));
    }
    /// Spindle on, heads to `radius_mm` at the height of the job, a stop, and no end.
    void begin_program(double radius_mm) {
        segment_of_program_ = std::make_unique<Segment>(std::move(Segment::attach(segment_name_)).value());
        auto writer = ProgramWriter::claim(*segment_of_program_);
        ASSERT_TRUE(writer);
        writer_.emplace(std::move(*writer));
        ASSERT_TRUE(writer_->begin(milliseconds{60'000}));
        MotionRecord way{};
        way.kind = MotionKind::way;
        way.line = 7;
        way.axes = 0b1111;
        way.target[index_of(Axis::r1)] = radius_mm;
        way.target[index_of(Axis::r2)] = radius_mm;
        way.target[index_of(Axis::psi)] = 400.0;
        way.target[index_of(Axis::y)] = job_y_mm();
        ASSERT_EQ(writer_->put(way), ProgramPut::done);
        MotionRecord stop{};
        stop.kind = MotionKind::stop;
        stop.line = 8;
        stop.code = static_cast<std::uint8_t>(StopReason::tool_change);
        ASSERT_EQ(writer_->put(stop), ProgramPut::done);
        Command command{};
        command.kind = CommandKind::program;
        command.value2 = writer_->program();
        for (std::size_t k = 0; k < kAxisCount; ++k)
            command.target[k] = static_cast<double>(session_->view().status->position_pulses[k]);
        ASSERT_TRUE(send_command(*segment_of_program_, command, milliseconds{60'000}));
    }
    double job_y_mm() const {
        return static_cast<double>(desk_->core_job()->view.y_pulses(1, 0)) / Profile{}.y.pulses_per_mm;
    }
    bool is_held_in_program() {
        return becomes_true([&] {
            return session_->view().state() == S::held &&
                   session_->view().program.hold == ProgramHold::tool_change;
        });
    }

    std::optional<CarvingWatch> watch_;
    std::unique_ptr<Segment> segment_of_program_;
    std::optional<ProgramWriter> writer_;
};

TEST_F(ProgramOnCore, LeavesThePieceOfTheJobBeforeItAsItIs) {
    start_core();
    open_session();
    ASSERT_NO_FATAL_FAILURE(carve_a_job());
    const CoreStatus after_job = *session_->view().status;
    const std::uint64_t edition = watch_->edition();
    const std::uint64_t carved = watch_->record()->edition();
    ASSERT_NO_FATAL_FAILURE(begin_program(6.0));
    ASSERT_TRUE(is_held_in_program());
    EXPECT_TRUE(session_->view().runs_program());
    EXPECT_EQ(in_english(state_text(session_->view(), 3).second), "tool change (M6)");
    EXPECT_LT(done_ratio(session_->view()), 0.0);
    EXPECT_EQ(session_->view().status->job_end_tick, after_job.job_end_tick);
    session_->stop();
    ASSERT_TRUE(becomes_true([&] { return session_->view().state() == S::ready; }));
    for (int look = 0; look < 5; ++look) {
        const std::uint64_t heard = session_->view().status->heartbeat;
        ASSERT_TRUE(becomes_true([&] { return session_->view().status->heartbeat != heard; }));
    }
    EXPECT_EQ(watch_->edition(), edition) << "no fresh blank";
    EXPECT_EQ(watch_->record()->edition(), carved) << "nothing was cut of it";
    EXPECT_FALSE(session_->view().runs_program());
    EXPECT_DOUBLE_EQ(done_ratio(session_->view()), 1.0);
}

TEST_F(ProgramOnCore, IsNamedWithItsLineWhenItsCoreDies) {
    start_core();
    open_session();
    ASSERT_NO_FATAL_FAILURE(carve_a_job());
    ASSERT_NO_FATAL_FAILURE(begin_program(40.0));
    ASSERT_TRUE(is_held_in_program());
    core_->send_signal(SIGKILL);
    core_->wait_for_exit();
    ASSERT_TRUE(becomes_true([&] { return session_->view().life == CoreLife::none; }));
    const auto text = loud_text(session_->view());
    ASSERT_TRUE(text);
    EXPECT_EQ(in_english(text->title), "The core has ended in line 8 of its program");
    EXPECT_NE(all_messages().find("The core has ended in line 8 of its program"), std::string::npos)
        << all_messages();
    // A window that comes later finds the segment as the core has left it.
    watch_.reset();
    open_session();
    ASSERT_TRUE(comes_true([&] { return session_->view().status.has_value(); }));
    EXPECT_EQ(session_->view().program.line, 8U);
    EXPECT_EQ(session_->view().program.is_running, 1U);
}

}  // namespace
}  // namespace psicarve::session
