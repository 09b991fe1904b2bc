// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing is cut off, in any language, on a screen of 1280 x 720 and on one of 1920 x 1080 at 200 %: whatever
// the machine is at. Forms and lists are in fit_forms_test.cpp.
#include "tests/hmi/ui/fit_rig.hpp"

namespace psicarve::ui {
namespace {

TEST_P(Fit, WithNothingOpen) {
    open_small();
    ASSERT_TRUE(comes_true([&] { return machine_view().is_heard(); }));
    expect_pages_and_panels_fit("empty");
}

TEST_P(Fit, WithoutACore) {
    open_on_screen();
    expect_with_panels_fit("no_core");
}

TEST_P(Fit, WithAFileThatWasRefused) {
    open_small();
    ASSERT_NO_FATAL_FAILURE(publish_job(two_process::lobed_job(2, 24, Profile{})));
    const std::string long_name(120, 'x');
    window_->open(QString::fromStdString(file("a_folder/" + long_name + ".stl")));
    ASSERT_TRUE(comes_true([&] { return part<QLabel>("refusal_title").isVisible(); }));
    expect_fit("refused");
    EXPECT_FALSE(part<QLabel>("refusal_why").text().contains("a_folder")) << "the tool tip has it";
    EXPECT_TRUE(part<QLabel>("refusal_why").toolTip().contains("a_folder"));
}

TEST_P(Fit, WithAPieceThatIsUnfinished) {
    open_small();
    ASSERT_NO_FATAL_FAILURE(publish_job(two_process::long_job()));
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(MachineState::ready));
    const auto carve = [&](std::uint32_t layers) {
        window_->context().machine.start(0, layers);
        ASSERT_TRUE(comes_true([&] {
            return machine_view().state() == MachineState::ready && machine_view().resumable_layer == layers;
        }));
    };
    carve(4);
    carve(2);
    ASSERT_TRUE(comes_true([&] { return part<QLabel>("unfinished_title").isVisible(); }));
    expect_with_panels_fit("unfinished_piece");
    start_core_anew();
    ASSERT_TRUE(
        comes_true([&] { return machine_view().is_heard() && machine_view().state() == MachineState::off; }));
    expect_fit("unfinished_piece_of_a_core_before");
    // What has to be done first, and the way back, are no matter of room.
    EXPECT_TRUE(part<QLabel>("unfinished_details").isVisible());
    SharedRecord<Checkpoint>& record = segment_->header().checkpoint;
    const Checkpoint own = read_record(record).value_or(Checkpoint{});
    write_record(record, checkpoint_at(own.job_checksum, own.next_layer, own.layer_count, own.earlier_layer,
                                       own.origin | kCheckpointFromDisk));
    ASSERT_TRUE(comes_true([&] { return machine_view().is_checkpoint_from_disk; }));
    EXPECT_TRUE(button("unfinished_forget").isVisible());
    expect_fit("unfinished_piece_from_disk");
    const session::UnfinishedPiece piece{2, 4, 4000};
    const auto needs = session::unfinished_needs(piece, machine_view());
    EXPECT_EQ(needs.size(), 2U);
    on_each_screen([&] {
        settle();
        for (const session::Phrase& need : room_in(size()) == Room::small ? needs : decltype(needs){})
            EXPECT_TRUE(part<QLabel>("unfinished_details").text().contains(words(need)))
                << words(need).toStdString();
    });
}

TEST_P(Fit, WithAPieceThatOnlyADiskKnows) {
    keep_state_in_own_folder();
    SavedCheckpoint saved;
    saved.checkpoint = checkpoint_at(1, 3131, 4000, 3999);
    saved.segment_name = segment_name_;
    saved.source_name = std::string(120, 'x') + ".stl";
    saved.tool = "ball, 3.175 mm";
    const StateNames names{file(""), segment_name_, false};
    ASSERT_TRUE(save_checkpoint(saved, names.checkpoint()));
    open_on_screen();
    ASSERT_TRUE(comes_true([&] { return part<QLabel>("unfinished_title").isVisible(); }));
    settle();
    expect_fit("saved_piece_without_its_job");
    EXPECT_FALSE(button("unfinished_open").isVisible());
}

TEST_P(Fit, WithAPieceThatADiskKnowsAndItsJob) {
    keep_state_in_own_folder();
    SavedCheckpoint saved;
    saved.checkpoint = checkpoint_at(1, 3131, 4000, 3999);
    saved.segment_name = segment_name_;
    saved.source_name = std::string(120, 'x') + ".stl";
    saved.tool = "ball, 3.175 mm";
    const StateNames names{file(""), segment_name_, false};
    ASSERT_TRUE(save_checkpoint(saved, names.checkpoint()));
    ASSERT_TRUE(save_job_for_everybody(std::vector<std::byte>(64), names.job(1)));
    open_on_screen();
    ASSERT_TRUE(comes_true([&] { return part<QLabel>("unfinished_title").isVisible(); }));
    settle();
    expect_fit("saved_piece");
    EXPECT_TRUE(button("unfinished_open").isVisible());
}

/// All that there is to be known of such a piece, each in its longest words.
TEST_P(Fit, WithAPieceOfAnotherCoreAndProfile) {
    keep_state_in_own_folder();
    SavedCheckpoint saved;
    saved.checkpoint = checkpoint_at(1, 3131, 4000, 3999);
    saved.segment_name = segment_name_;
    saved.is_simulator = true;
    saved.profile_hash = 1;
    saved.source_name = std::string(120, 'x') + ".stl";
    saved.tool = "ball, 3.175 mm";
    const StateNames names{file(""), segment_name_, true};
    ASSERT_TRUE(save_checkpoint(saved, names.checkpoint()));
    ASSERT_TRUE(save_job_for_everybody(std::vector<std::byte>(64), names.job(1)));
    std::filesystem::create_directory(file("elsewhere"));
    start_core({"--state", file("elsewhere")});
    open_on_screen();
    ASSERT_TRUE(comes_true([&] {
        return machine_view().is_heard() && machine_view().saved_piece &&
               machine_view().saved_piece->keeper == Keeper::other_core;
    }));
    expect_fit("saved_piece_of_another_core");
    const auto needs = session::saved_needs(*machine_view().saved_piece, machine_view());
    EXPECT_EQ(needs.size(), 4U);
    on_each_screen([&] {
        settle();
        for (const session::Phrase& need : room_in(size()) == Room::small ? needs : decltype(needs){})
            EXPECT_TRUE(part<QLabel>("unfinished_details").text().contains(words(need)))
                << words(need).toStdString();
    });
}

TEST_P(Fit, WithAJobBeforeAndWhileItIsCarved) {
    open_small();
    open_example("figurine.stl");
    expect_fit("model");
    ASSERT_NO_FATAL_FAILURE(publish_job(two_process::long_job()));
    expect_pages_and_panels_fit("published");
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(MachineState::ready));
    expect_with_panels_fit("ready");
    window_->context().machine.set_override(80);
    ASSERT_TRUE(comes_true([&] { return machine_view().status->override_percent == 80; }));
    expect_with_panels_fit("ready_to_be_looked_at");
    ASSERT_TRUE(click("start"));
    ASSERT_TRUE(comes_to(MachineState::carving));
    expect_pages_and_panels_fit("carving");
    ASSERT_TRUE(click("hold"));
    ASSERT_TRUE(comes_to(MachineState::held));
    expect_panels_fit("held");
    window_->emergency_stop();
    ASSERT_TRUE(comes_to(MachineState::alarm));
    expect_pages_and_panels_fit("alarm");
}

TEST_P(Fit, WithAnotherJobOnTheDeskThanInTheMachine) {
    open_small();
    ASSERT_NO_FATAL_FAILURE(publish_job(two_process::long_job()));
    std::filesystem::copy_file(example("figurine.stl"), file(kLongName));
    window_->open(QString::fromStdString(file(kLongName)));
    ASSERT_TRUE(comes_to(session::OpenJobState::model));
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_to(session::OpenJobState::job));
    ASSERT_FALSE(part<QWidget>("desk_job").isHidden());
    expect_with_panels_fit("two_jobs");
    ASSERT_TRUE(click("home"));
    ASSERT_TRUE(comes_to(MachineState::ready));
    window_->context().machine.start(0);  // by another program
    ASSERT_TRUE(comes_to(MachineState::carving));
    expect_with_panels_fit("two_jobs_carving");
}

TEST_P(Fit, WithASlicingThatWasRefused) {
    open_small();
    std::filesystem::copy_file(example("figurine.stl"), file(kLongName));
    window_->open(QString::fromStdString(file(kLongName)));
    ASSERT_TRUE(comes_to(session::OpenJobState::model));
    part<QDoubleSpinBox>("scale").setValue(10.0);
    ASSERT_TRUE(click("slice"));
    ASSERT_TRUE(comes_true([&] { return part<QWidget>("desk_refusal").isVisible(); }));
    expect_fit("not_sliced");
}

TEST_P(Fit, WithAnotherProfileThanTheCores) {
    Profile given;
    given.name = "mill_in_the_workshop";
    given.r1.pulses_per_mm *= 2.0;
    given.r2.pulses_per_mm *= 2.0;
    given.y.pulses_per_mm *= 2.0;
    given.head_clearance_mm += 1.0;
    open_small();
    window_->context().machine.set_profile(given);
    ASSERT_TRUE(comes_true([&] { return part<QWidget>("core_profile").isVisible(); }));
    expect_fit("other_profile");
}

TEST_P(Fit, WithPositionsInPulses) {
    Profile own;
    own.r1.pulses_per_mm *= 2.0;
    std::ofstream{file("own.toml")} << profile_to_toml(own);
    start_core({"--profile", file("own.toml")});
    std::filesystem::remove(file("own.toml"));
    open_on_screen();
    core_->send_signal(SIGSTOP);  // its words are ours
    auto& record = segment_->header().status;
    auto status = load_words<CoreStatus>(record.words);
    status.position_pulses[index_of(Axis::r1)] = -48'000;
    status.position_pulses[index_of(Axis::psi)] = 1'006'160;
    on_each_screen([&] {
        ASSERT_TRUE(comes_true([&] {
            ++status.heartbeat;
            write_record(record, status);
            return part<QLabel>("position_psi").text().startsWith("1");
        }));
        look_here("pulses");
    });
}

TEST_P(Fit, WithAProgramThatIsHeld) {
    open_small();
    core_->send_signal(SIGSTOP);  // its words are ours
    auto status = load_words<CoreStatus>(segment_->header().status.words);
    status.state = MachineState::held;
    status.homed_mask = 0xF;
    ProgramStatus program{};
    program.program = 1;
    program.line = 10'000'000;
    program.is_running = 1;
    on_each_screen([&] {
        settle();
        for (std::uint8_t number = 0; number < kProgramHoldCount; ++number) {
            const auto hold = static_cast<ProgramHold>(number);
            program.hold = hold;
            write_record(segment_->header().program.status, program);
            auto& panels = part<QTabBar>("side_names");
            for (int panel = 0; panel < (panels.isVisible() ? panels.count() : 1); ++panel) {
                panels.setCurrentIndex(panel);
                ASSERT_TRUE(comes_true([&] {
                    ++status.heartbeat;
                    write_record(segment_->header().status, status);
                    return machine_view().runs_program() && machine_view().program.hold == hold;
                }));
                look_here("program_" + QString::number(number) + "_panel_" + QString::number(panel + 1));
            }
        }
    });
}

TEST_P(Fit, WithOrdersThatWereRefused) {
    open_small();
    window_->emergency_stop();
    ASSERT_TRUE(comes_to(MachineState::alarm));
    auto& machine = window_->context().machine;
    const auto refused = [&](CommandKind kind) {
        machine.order(kind, session::phrase("Home"));
        return comes_true([&] { return machine.refused_order().has_value(); });
    };
    part<QTabWidget>("tabs").setCurrentIndex(5);
    ASSERT_TRUE(refused(CommandKind::spindle));
    expect_panels_fit("refused_jog");
    ASSERT_TRUE(refused(CommandKind::resume));
    expect_fit("refused_job");
    part<QTabWidget>("tabs").setCurrentIndex(3);
    ASSERT_TRUE(refused(CommandKind::drives_off));
    expect_fit("refused_outputs");
    EXPECT_TRUE(machine.refused_order().has_value()) << "shown on every screen";
}

std::vector<Language> languages_that_fit() {
    if (psicarve::test::kIsSanitized) return {Language::chinese};
    return {Language::english, Language::chinese, Language::russian};
}

INSTANTIATE_TEST_SUITE_P(OfTheWindow, Fit, ::testing::ValuesIn(languages_that_fit()), [](const auto& named) {
    return std::string{kLanguages[static_cast<std::size_t>(named.param)].code};
});

}  // namespace
}  // namespace psicarve::ui
