// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "shared/computer/process_identity.hpp"
#include "shared/record/saved_checkpoint.hpp"
#include "shared/segment/reached_point.hpp"
#include "shared/segment/shared_record.hpp"
#include "tests/hmi/session/session_rig.hpp"
#include "tests/places.hpp"
#include "tests/two_process/quick_planning.hpp"

namespace psicarve::session {
namespace {

using S = MachineState;

class SessionOnCore : public test::SessionRig {};

TEST_F(SessionOnCore, GoesTheWholeWayFromAModelToADoneJob) {
    start_core();
    open_session();
    desk_->open(example("small.stl"));
    ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::model; })) << all_messages();
    cam::JobOptions options;
    options.layer_count = 12;
    options.point_count = 40;
    desk_->slice(options, Profile{});
    EXPECT_EQ(desk_->view().state, OpenJobState::slicing);
    ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::job; })) << all_messages();
    EXPECT_EQ(desk_->view().layer_count, 12U);
    desk_->publish();
    ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::published; })) << all_messages();
    home_session();
    session_->start(0);
    ASSERT_TRUE(comes_true([&] {
        const auto& status = session_->view().status;
        return status->points_total == 12 * 40 && status->points_done == status->points_total &&
               status->state == S::ready;
    })) << all_messages();
    EXPECT_GT(desk_->job()->least.total(), 0.0);
    EXPECT_LE(desk_->job()->least.total(), 1.001 * session_->view().status->reference_seconds);
}

TEST_F(SessionOnCore, HoldsResumesStopsAtOnceAndResets) {
    const psicarve::test::QuickPlanning quick{file("quick.toml")};
    start_core();
    open_session();
    open_and_publish(two_process::long_job(quick.profile()));
    home_session();
    session_->start(0);
    ASSERT_TRUE(comes_to(S::carving));
    session_->set_override(150);
    ASSERT_TRUE(comes_true([&] { return session_->view().status->override_percent == 150; }));
    session_->order(CommandKind::hold, phrase("Hold"));
    ASSERT_TRUE(comes_to(S::held));
    session_->order(CommandKind::resume, phrase("Resume"));
    ASSERT_TRUE(comes_to(S::carving));
    EXPECT_TRUE(session_->emergency_stop());
    ASSERT_TRUE(comes_to(S::alarm));
    EXPECT_EQ(session_->view().status->alarm_cause, AlarmCause::emergency_stop);
    session_->order(CommandKind::reset_alarm, phrase("Reset alarm"));
    ASSERT_TRUE(comes_to(S::off));
    home_session();
    session_->start(session_->view().status->layer);
    ASSERT_TRUE(comes_to(S::carving));
    EXPECT_TRUE(session_->stop());
    ASSERT_TRUE(comes_to(S::ready));
}

TEST_F(SessionOnCore, JogsWhileTheHandIsThere) {
    start_core();
    open_session();
    ASSERT_TRUE(comes_true([&] { return session_->view().is_heard(); }));
    home_session();
    const auto y_pulses = [&] { return session_->view().status->position_pulses[index_of(Axis::y)]; };
    const auto from_pulses = y_pulses();
    session_->jog().step(Axis::y, 1.0, 5.0);
    ASSERT_TRUE(comes_true([&] {
        return y_pulses() == from_pulses + 400 && session_->view().state() == S::ready;
    })) << all_messages();
    session_->jog().hold(Axis::y, true, 5.0);
    ASSERT_TRUE(comes_true([&] { return y_pulses() > from_pulses + 400; })) << all_messages();
    session_->jog().release();
    ASSERT_TRUE(comes_to(S::ready));
    ASSERT_TRUE(comes_true([&] { return session_->view().status->move_end != MoveEnd::none; }));
}

// The core limits the speed, and says so once, however often the key is pressed.
TEST_F(SessionOnCore, TellsThatAJogIsSlowerThanAskedFor) {
    start_core();
    open_session();
    ASSERT_TRUE(comes_true([&] { return session_->view().is_heard(); }));
    home_session();
    const auto told = [&] {
        const std::string all = all_messages();
        std::size_t count = 0;
        for (std::size_t at = 0; (at = all.find("By hand: Y goes at", at)) != std::string::npos; ++at)
            ++count;
        return count;
    };
    for (int press = 1; press <= 2; ++press) {
        const auto from = session_->view().status->position_pulses[index_of(Axis::y)];
        session_->jog().step(Axis::y, 1.0, 5'000.0);
        ASSERT_TRUE(comes_true([&] {
            return session_->view().status->position_pulses[index_of(Axis::y)] == from + 400 &&
                   session_->view().state() == S::ready;
        })) << all_messages();
        ASSERT_TRUE(comes_true([&] { return told() > 0; })) << all_messages();
    }
    EXPECT_EQ(told(), 1U) << all_messages();
}

TEST_F(SessionOnCore, SaysThatTheCoreIsGoneAndFindsTheNext) {
    open_session();
    ASSERT_TRUE(comes_true([&] { return session_->view().life == CoreLife::none; }));
    EXPECT_FALSE(session_->emergency_stop());
    start_core();
    ASSERT_TRUE(comes_true([&] { return session_->view().life == CoreLife::alive; }));
    core_.reset();
    ASSERT_TRUE(comes_true([&] { return session_->view().life == CoreLife::none; }));
    start_core();
    ASSERT_TRUE(comes_true([&] { return session_->view().life == CoreLife::alive; }));
    home_session();
}

TEST_F(SessionOnCore, FindsTheNextCoreThoughTheDiskOfAProfileHangs) {
    Profile own;
    own.r1.pulses_per_mm *= 2.0;
    std::ofstream{file("own.toml")} << profile_to_toml(own);
    start_core({"--profile", file("own.toml")});
    std::promise<void> disk;
    const auto is_sought = std::make_shared<std::atomic<bool>>(false);
    open_session();
    SessionOptions options{segment_name_, {}, {}};
    options.find_profile = [is_sought, answers = disk.get_future().share()](std::uint32_t, std::uint64_t) {
        is_sought->store(true);
        answers.wait();
        return std::optional<Profile>{};
    };
    session_ = std::make_unique<MachineSession>(options, log_);
    ASSERT_TRUE(comes_true([&] { return is_sought->load(); }));
    // Its segment goes with it.
    core_.reset();
    segment_.reset();
    ASSERT_TRUE(Segment::remove(segment_name_));
    ASSERT_TRUE(comes_true([&] { return session_->view().life == CoreLife::none; }));
    start_core();
    EXPECT_TRUE(comes_true([&] { return session_->view().life == CoreLife::alive; }));
    EXPECT_TRUE(session_->stop()) << "somebody hears it";
    disk.set_value();
}

// It may plan the job that was left first, which takes seconds: no frame waits for that.
TEST_F(SessionOnCore, TakesACoreThatHasNotSignedForNone) {
    SegmentOptions options;
    options.name = segment_name_;
    auto core = Segment::create_or_attach(options);
    ASSERT_TRUE(core) << core.error().message;
    ASSERT_TRUE(core->take_core_lock());
    constexpr std::uint64_t kHash = 77;
    core->header().core_profile_hash.store(kHash);
    open_session();
    ASSERT_TRUE(comes_true([&] { return session_->view().core_profile_hash == kHash; })) << "it is attached";
    EXPECT_EQ(session_->view().life, CoreLife::none);
    EXPECT_FALSE(session_->stop()) << "nobody hears it";

    core->sign_core();

    ASSERT_TRUE(comes_true([&] { return session_->view().core_pid == own_pid(); }));
    EXPECT_TRUE(session_->stop());
    // As one in another container: alive by its lock, and its pid is of no process here.
    core->header().core.start_time.store(0);
    core->header().core.pid.store(1);
    EXPECT_TRUE(comes_true([&] { return session_->view().core_pid == 1U; }));
}

// A run may have begun anew with another blank: the segment's point counts beside a disk that agrees.
TEST_F(SessionOnCore, KnowsNoPointOfADeadCoreWhereTheDiskTellsOfAnotherPlace) {
    start_core();
    open_session();
    open_and_publish(two_process::long_job());
    SessionOptions options{segment_name_, {}, {}};
    options.state_folder = file("");
    session_ = std::make_unique<MachineSession>(options, log_);
    ASSERT_TRUE(comes_true([&] { return session_->view().is_heard(); }));
    core_.reset();
    SegmentHeader& header = segment_->header();
    const std::uint64_t job = *published_checksum(*segment_);
    const auto known = [&](std::uint32_t layer) {
        return checkpoint_at(job, layer, 40, 0, kCheckpointSimulated);
    };
    write_record(header.checkpoint, known(3));
    header.reached_point.store(reached_word(job, 3, 56));
    const auto& machine_view = session_->view();
    ASSERT_TRUE(comes_true([&] { return !machine_view.is_heard() && machine_view.resumable_point == 56U; }));
    SavedCheckpoint saved;
    saved.segment_name = segment_name_;
    saved.is_simulator = true;
    const std::string path = StateNames{file(""), segment_name_, true}.checkpoint();
    saved.checkpoint = known(2);
    ASSERT_TRUE(save_checkpoint(saved, path));
    EXPECT_TRUE(comes_true([&] { return machine_view.saved_piece && !machine_view.resumable_point; }));
    saved.checkpoint = known(3);
    ASSERT_TRUE(save_checkpoint(saved, path));
    EXPECT_TRUE(comes_true([&] { return machine_view.resumable_point == 56U; }));
}

// The segment of the shop's machine may have been the simulated one's before, and a core takes its time to be
// seen.
TEST_F(SessionOnCore, ShowsNoPieceBeforeItKnowsWhoseMachineIsThere) {
    SavedCheckpoint saved;
    saved.segment_name = segment_name_;
    saved.source_name = "owl.stl";
    for (const bool is_simulator : {false, true}) {
        saved.is_simulator = is_simulator;
        saved.checkpoint = checkpoint_at(1, is_simulator ? 7 : 131, 500);
        ASSERT_TRUE(save_checkpoint(saved, StateNames{file(""), segment_name_, is_simulator}.checkpoint()));
    }
    start_core();
    open_session();
    SessionOptions options{segment_name_, {}, {}};
    options.state_folder = file("");
    session_ = std::make_unique<MachineSession>(options, log_);
    bool was_others = false;
    bool was_too_early = false;
    const auto& machine_view = session_->view();
    ASSERT_TRUE(comes_true([&] {
        if (!machine_view.saved_piece) return false;
        was_too_early = was_too_early || !machine_view.is_heard();
        was_others = was_others || !machine_view.saved_piece->saved.is_simulator;
        return machine_view.saved_piece->saved.checkpoint.next_layer == 7;
    }));
    EXPECT_FALSE(was_too_early) << "as if there were no core";
    EXPECT_FALSE(was_others);
    // Without a core it is the real machine's, until one comes that drives another.
    core_.reset();
    ASSERT_TRUE(comes_true(
        [&] { return machine_view.saved_piece && !machine_view.saved_piece->saved.is_simulator; }));
    start_core();
    ASSERT_TRUE(comes_true([&] { return machine_view.is_heard() && machine_view.status; }));
    EXPECT_FALSE(machine_view.saved_piece && !machine_view.saved_piece->saved.is_simulator);
}

/// As a core's guard does once it has made the port safe.
void leave_words_of_guard(Segment& segment) {
    SegmentHeader& header = segment.header();
    CoreStatus status = load_words<CoreStatus>(header.status.words);
    status.state = S::alarm;
    status.alarm_cause = AlarmCause::core_lost;
    status.homed_mask = 0;
    ++status.heartbeat;
    write_record(header.status, status);
}

TEST_F(SessionOnCore, KeepsWhenACoreWasHeardThoughItsGuardSpeaksAfterIt) {
    start_core();
    open_session();
    home_session();
    const auto heard = session_->view().status_time;
    EXPECT_NE(heard.time_since_epoch().count(), 0);
    core_->send_signal(SIGKILL);
    core_->wait_for_exit();
    ASSERT_TRUE(comes_true([&] { return session_->view().life == CoreLife::none; }));
    attach();
    leave_words_of_guard(*segment_);
    ASSERT_TRUE(comes_to(S::alarm));
    EXPECT_GE(session_->view().status_time, heard);
    EXPECT_EQ(session_->view().heard_state, S::ready) << "its own word, not its guard's";
    open_session();  // and one that comes too late
    ASSERT_TRUE(comes_to(S::alarm));
    EXPECT_EQ(session_->view().status_time.time_since_epoch().count(), 0);
    EXPECT_FALSE(session_->view().heard_state);
}

TEST_F(SessionOnCore, ShowsTheJobOfARunningCoreAfterItsOwnRestart) {
    start_core();
    open_session();
    open_and_publish(two_process::lobed_job(7, 30));
    open_session();  // as after a crash: knows nothing
    ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::published; })) << all_messages();
    EXPECT_EQ(desk_->view().layer_count, 7U);
    EXPECT_EQ(session_->view().state(), S::off);
}

TEST_F(SessionOnCore, KeepsTheJobOfACoreThatIsSilentForAMoment) {
    start_core();
    open_session();
    open_and_publish(two_process::lobed_job(7, 30));
    MachineView machine_view = session_->view();
    machine_view.life = CoreLife::silent;
    desk_->poll(machine_view);
    EXPECT_EQ(desk_->view().state, OpenJobState::published);
    machine_view.life = CoreLife::none;
    desk_->poll(machine_view);
    EXPECT_EQ(desk_->view().state, OpenJobState::job);
}

TEST_F(SessionOnCore, KnowsTheCoresJobWhateverIsOpenedMeanwhile) {
    start_core();
    open_session();
    open_and_publish(two_process::lobed_job(7, 30));
    EXPECT_EQ(desk_->core_job(), desk_->job());
    desk_->open(example("small.stl"));
    ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::model; })) << all_messages();
    ASSERT_NE(desk_->core_job(), nullptr);
    EXPECT_EQ(desk_->core_job()->view.layer_count(), 7U);
    EXPECT_EQ(desk_->view().core_layer_count, 7U);
    open_session();  // opens a model at once: the core's job is fetched nevertheless, and not shown
    desk_->open(example("small.stl"));
    ASSERT_TRUE(comes_true([&] { return desk_->core_job() != nullptr; })) << all_messages();
    EXPECT_EQ(desk_->core_job()->view.layer_count(), 7U);
    EXPECT_EQ(desk_->job(), nullptr);
    EXPECT_EQ(desk_->view().state, OpenJobState::model);
}

// The core's own words, with the command's name once.
TEST_F(SessionOnCore, SaysARefusalInTheWindowsWords) {
    start_core();
    open_session();
    ASSERT_TRUE(comes_true([&] { return session_->view().is_heard(); }));
    session_->order(CommandKind::hold, phrase("Hold"));
    ASSERT_TRUE(comes_true([&] {
        return all_messages().find("Hold: not while off; home first") != std::string::npos;
    })) << all_messages();
    session_->start(0);
    ASSERT_TRUE(comes_true([&] { return all_messages().find("Start: ") != std::string::npos; }))
        << all_messages();
    EXPECT_STRNE(log_.messages().back().what.inner.at(1).english, "%1") << all_messages();
}

TEST_F(SessionOnCore, SlicingCanBeCancelledAndRefusalsAreTold) {
    start_core();
    open_session();
    desk_->open(example("figurine.stl"));
    ASSERT_TRUE(comes_true([&] { return desk_->view().state == OpenJobState::model; })) << all_messages();
    desk_->slice(cam::JobOptions{}, Profile{});
    desk_->cancel();
    ASSERT_TRUE(comes_true([&] { return !desk_->view().is_busy(); }));
    EXPECT_EQ(desk_->view().state, OpenJobState::model) << all_messages();
    session_->start(0);
    ASSERT_TRUE(comes_true([&] { return all_messages().find("Start: ") != std::string::npos; }))
        << all_messages();
    desk_->open("no/such/file.stl");
    ASSERT_TRUE(comes_true([&] { return !desk_->view().is_busy(); }));
    EXPECT_NE(all_messages().find("no/such/file.stl"), std::string::npos);
    EXPECT_EQ(desk_->view().state, OpenJobState::model);
}

// The hand is renewed by a thread of its own, but only as long as the window's own loop is heard.
TEST_F(SessionOnCore, LetsGoOfAJogOnceItsOwnerHangs) {
    start_core();
    session_ =
        std::make_unique<MachineSession>(SessionOptions{segment_name_, {}, {}, kLongestJogLease}, log_);
    desk_ = std::make_unique<OpenJob>(segment_name_, std::string{}, log_);
    ASSERT_TRUE(comes_true([&] { return session_->view().is_heard(); }));
    home_session();
    session_->jog().hold(Axis::psi, true, 30.0);  // has no end of its own
    ASSERT_TRUE(comes_to(S::moving));
    // From here on no thread calls poll(), as when the window hangs, and the button is not released.
    attach();
    ASSERT_TRUE(reaches(S::ready));
    EXPECT_EQ(status().move_end, MoveEnd::released);
    session_->poll();
    EXPECT_EQ(status().state, S::ready) << "and does not begin again when it is heard anew";
}

}  // namespace
}  // namespace psicarve::session
