// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/sim/wiring.hpp"

#include <gtest/gtest.h>

#include "rtcore/sim/sim_config.hpp"
#include "shared/profile/pin_map.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::sim {
namespace {

Wiring wiring_of(const Profile& profile) {
    return Wiring(sim_config_from_profile(profile).wiring);
}

constexpr std::uint8_t kIdleControl = 0x0B;  // pins 1, 14 and 17 low: their register bits are inverted

TEST(Wiring, SeesTheOriginalsPins) {
    const Wiring sut = wiring_of(Profile{});
    EXPECT_EQ(sut.outputs(0x00, kIdleControl), 0U);
    EXPECT_EQ(sut.outputs(0x08, kIdleControl), bit_of(Signal::r1_step));
    EXPECT_EQ(sut.outputs(0x01, kIdleControl), bit_of(Signal::r2_step));
    EXPECT_EQ(sut.outputs(0x02, kIdleControl), bit_of(Signal::psi_step));
    EXPECT_EQ(sut.outputs(0x00, 0x09), bit_of(Signal::y_step));
    EXPECT_EQ(sut.outputs(0x80, kIdleControl), bit_of(Signal::r1_dir));
    EXPECT_EQ(sut.outputs(0x00, 0x03), bit_of(Signal::r2_dir));
    EXPECT_EQ(sut.outputs(0x40, kIdleControl), bit_of(Signal::psi_dir));
    EXPECT_EQ(sut.outputs(0x04, kIdleControl), bit_of(Signal::y_dir));
    EXPECT_EQ(sut.outputs(0x20, kIdleControl), bit_of(Signal::r2_enable));
    EXPECT_EQ(sut.outputs(0x00, 0x0A), bit_of(Signal::y_enable));
    EXPECT_EQ(sut.outputs(0x00, 0x0F), bit_of(Signal::spindle));
}

TEST(Wiring, PinSixEnablesTwoDrives) {
    const Wiring sut = wiring_of(Profile{});
    EXPECT_EQ(sut.outputs(0x10, kIdleControl), bit_of(Signal::r1_enable) | bit_of(Signal::psi_enable));
}

TEST(Wiring, ShowsTheOriginalsInputs) {
    const Wiring sut = wiring_of(Profile{});
    EXPECT_EQ(sut.status(0), 0x80);
    EXPECT_EQ(sut.status(bit_of(Signal::r1_limit)), 0x90);
    EXPECT_EQ(sut.status(bit_of(Signal::r2_limit)), 0x00);
    EXPECT_EQ(sut.status(bit_of(Signal::psi_index)), 0xA0);
    EXPECT_EQ(sut.status(bit_of(Signal::y_limit)), 0xC0);
    EXPECT_EQ(sut.status(bit_of(Signal::estop)), 0x80) << "not wired";
}

TEST(Wiring, ADriveWithoutAnEnableWireIsOn) {
    Profile profile;
    profile.port.pins[index_of(Signal::y_enable)] = 0;
    const Wiring sut = wiring_of(profile);
    EXPECT_EQ(sut.outputs(0x00, kIdleControl), bit_of(Signal::y_enable));
}

TEST(Wiring, AgreesWithTheCoresPinMapOnEveryLevel) {
    Profile odd;
    odd.port.pins = {-5, 2, 3, -14, -9, 17, 8, 4, -6, 7, -6, -1, -16, -13, 11, -12, 10, -15};
    odd.r1.positive_is_high = false;
    odd.y.positive_is_high = false;
    for (const Profile& profile : {Profile{}, odd}) {
        const PinMap map = PinMap::from_profile(profile).value();
        const Wiring sut = wiring_of(profile);
        for (SignalWord levels = 0; levels <= kMachineOutputMask; ++levels) {
            const OutputRegisters registers = map.encode(levels);
            SignalWord expected = levels;
            const SignalWord shared = bit_of(Signal::r1_enable) | bit_of(Signal::psi_enable);
            if ((levels & shared) != 0) expected |= shared;
            ASSERT_EQ(sut.outputs(registers.data, registers.control), expected) << levels;
        }
        for (SignalWord inputs = 0; inputs < 32; ++inputs) {
            SignalWord word = inputs << kFirstInput;
            if (profile.port.pins[index_of(Signal::estop)] == 0) word &= ~bit_of(Signal::estop);
            ASSERT_EQ(map.decode_status(sut.status(word)), word);
        }
    }
}

}  // namespace
}  // namespace psicarve::sim
