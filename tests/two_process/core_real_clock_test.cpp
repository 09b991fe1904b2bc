// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/two_process/core_rig.hpp"
#include "tests/two_process/slow_machine.hpp"

namespace psicarve::two_process {
namespace {

JobTable square_job(const Profile& profile) {
    JobTable table = lobed_job(2, 9, profile);
    for (std::size_t layer = 0; layer < 2; ++layer) {
        table.layer_height_pulses[layer] = 20 + 2 * static_cast<std::int64_t>(layer);
    }
    return table;
}

class CoreOnTheRealClock : public CoreRig {};

// Three threads meet here: also run under ThreadSanitizer, whose findings end the core with another exit
// code.
TEST_F(CoreOnTheRealClock, HomesCarvesAndEndsInOrder) {
    const Profile profile = slow_machine();
    const std::string text = profile_to_toml(profile);
    ASSERT_TRUE(write_file_atomically(file("slow.toml"), std::as_bytes(std::span{text})));
    core_ = std::make_unique<CoreProcess>(
        std::vector<std::string>{"--segment", segment_name_, "--clock", "real", "--profile",
                                 file("slow.toml"), "--trace", file("real.trace"), "--capacity", "10x20"},
        file("core.err"));
    attach();
    ASSERT_TRUE(eventually([&] { return segment_->core_pid() == std::uint32_t(core_->pid()); }))
        << text_of(file("core.err"));
    home();
    ASSERT_EQ(publish(square_job(profile)), "");
    start_carving();
    ASSERT_TRUE(eventually([&] {
        const CoreStatus now = status();
        return now.job_end_tick != 0 || now.state == MachineState::alarm;
    }));
    const CoreStatus end = status();
    EXPECT_EQ(end.state, MachineState::ready) << name_of(end.alarm_cause);
    EXPECT_EQ(end.points_done, 18U);
    for (const Axis axis : kAllAxes) {
        EXPECT_EQ(end.sim_true_position_pulses[index_of(axis)], end.position_pulses[index_of(axis)])
            << name_of(axis);
    }
    EXPECT_EQ(end.trace_lost, 0U);
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0) << text_of(file("core.err"));
}

}  // namespace
}  // namespace psicarve::two_process
