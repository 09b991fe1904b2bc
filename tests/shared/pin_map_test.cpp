// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/profile/pin_map.hpp"

#include <gtest/gtest.h>

#include <string>

namespace psicarve {
namespace {

PinMap map_of(const Profile& profile) {
    auto map = PinMap::from_profile(profile);
    if (!map) throw std::runtime_error(map.error().message);
    return std::move(map).value();
}

struct SignalBytes {
    Signal signal;
    std::uint8_t data;
    std::uint8_t control;
};

// By hand from the wiring: control bits 0, 1 and 3 are inverted by the port's hardware, so at rest they
// are 1.
constexpr SignalBytes kDefaultWiring[]{
    {Signal::r1_step, 0x08, 0x0B},   {Signal::r2_step, 0x01, 0x0B},    {Signal::psi_step, 0x02, 0x0B},
    {Signal::y_step, 0x00, 0x09},    {Signal::r1_dir, 0x80, 0x0B},     {Signal::r2_dir, 0x00, 0x03},
    {Signal::psi_dir, 0x40, 0x0B},   {Signal::y_dir, 0x04, 0x0B},      {Signal::r1_enable, 0x10, 0x0B},
    {Signal::r2_enable, 0x20, 0x0B}, {Signal::psi_enable, 0x10, 0x0B}, {Signal::y_enable, 0x00, 0x0A},
    {Signal::spindle, 0x00, 0x0F}};

TEST(PinMap, EncodesNothingActiveAsTheRestingBytes) {
    EXPECT_EQ(map_of({}).encode(0), (OutputRegisters{0x00, 0x0B}));
}

TEST(PinMap, EncodesEachSignalOfTheDefaultWiring) {
    const PinMap sut = map_of({});
    for (const SignalBytes& expected : kDefaultWiring) {
        EXPECT_EQ(sut.encode(bit_of(expected.signal)), (OutputRegisters{expected.data, expected.control}))
            << name_of(expected.signal);
    }
}

TEST(PinMap, EncodesAllSignalsTogether) {
    EXPECT_EQ(map_of({}).encode(kOutputMask), (OutputRegisters{0xFF, 0x04}));
}

TEST(PinMap, IgnoresInputsInWhatItEncodes) {
    EXPECT_EQ(map_of({}).encode(kInputMask), (OutputRegisters{0x00, 0x0B}));
}

TEST(PinMap, DecodesEachSensorOfTheDefaultWiring) {
    const PinMap sut = map_of({});
    EXPECT_EQ(sut.decode_status(0x80), 0U);  // all pins low; bit 7 is inverted
    EXPECT_EQ(sut.decode_status(0x90), bit_of(Signal::r1_limit));
    EXPECT_EQ(sut.decode_status(0x00), bit_of(Signal::r2_limit));
    EXPECT_EQ(sut.decode_status(0xA0), bit_of(Signal::psi_index));
    EXPECT_EQ(sut.decode_status(0xC0), bit_of(Signal::y_limit));
    EXPECT_EQ(sut.decode_status(0x78), kInputMask & ~bit_of(Signal::estop));
}

TEST(PinMap, SensorsThatAreNotWiredAreNeverTripped) {
    Profile profile;
    profile.port.pins[index_of(Signal::r2_limit)] = 0;
    profile.r2.home = HomeSensor::none;
    const PinMap sut = map_of(profile);
    EXPECT_FALSE(sut.is_wired(Signal::r2_limit));
    for (unsigned status = 0; status < 256; ++status) {
        const SignalWord levels = sut.decode_status(static_cast<std::uint8_t>(status));
        EXPECT_EQ(levels & (bit_of(Signal::r2_limit) | bit_of(Signal::estop)), 0U) << status;
        EXPECT_EQ(levels & ~kInputMask, 0U);
    }
}

TEST(PinMap, StatusOfInputsIsWhatThePortWouldShow) {
    Profile profile;
    profile.port.pins[index_of(Signal::estop)] = 15;
    const PinMap sut = map_of(profile);
    EXPECT_EQ(sut.status_from_inputs(0), 0x80);
    EXPECT_EQ(sut.status_from_inputs(bit_of(Signal::estop)), 0x88);
    EXPECT_EQ(sut.status_from_inputs(bit_of(Signal::r2_limit)), 0x00);
    EXPECT_EQ(sut.status_from_inputs(kInputMask), 0x78);
    EXPECT_EQ(map_of({}).status_from_inputs(bit_of(Signal::estop)), 0x80) << "not wired";
}

TEST(PinMap, InputsComeBackThroughTheStatusByte) {
    Profile profile;
    profile.port.pins[index_of(Signal::estop)] = -15;
    profile.port.pins[index_of(Signal::r2_limit)] = -11;
    const PinMap sut = map_of(profile);
    for (SignalWord inputs = 0; inputs <= kInputMask; inputs += bit_of(Signal::r1_limit)) {
        EXPECT_EQ(sut.decode_status(sut.status_from_inputs(inputs)), inputs);
    }
}

/// What a machine sees of these levels: pin 6 is shared by two enables.
SignalWord with_shared_enables(SignalWord levels) {
    const SignalWord shared = bit_of(Signal::r1_enable) | bit_of(Signal::psi_enable);
    return (levels & shared) != 0 ? levels | shared : levels;
}

TEST(PinMap, EveryOutputWordComesBackThroughTheRegisters) {
    const PinMap sut = map_of({});
    for (SignalWord levels = 0; levels <= kMachineOutputMask; ++levels) {
        ASSERT_EQ(sut.outputs_from_registers(sut.encode(levels)), with_shared_enables(levels));
    }
}

TEST(PinMap, EveryOutputWordComesBackWithEveryPolarityTurned) {
    Profile profile;
    for (std::size_t i = 0; i < kFirstInput; ++i) profile.port.pins[i] *= -1;
    profile.r1.positive_is_high = false;
    profile.psi.positive_is_high = false;
    const PinMap sut = map_of(profile);
    for (SignalWord levels = 0; levels <= kMachineOutputMask; ++levels) {
        ASSERT_EQ(sut.outputs_from_registers(sut.encode(levels)), with_shared_enables(levels));
    }
}

/// Four of the outputs that programs switch: enables that share a pin make room for them.
Profile with_switched_outputs() {
    Profile profile;
    profile.port.pins[index_of(Signal::r2_enable)] = 6;
    profile.port.pins[index_of(Signal::y_enable)] = 6;
    profile.port.pins[index_of(Signal::spindle)] = 0;
    profile.port.pins[index_of(Signal::mist)] = 1;
    profile.port.pins[index_of(Signal::flood)] = -7;
    profile.port.pins[index_of(Signal::output_3)] = -16;
    return profile;
}

TEST(PinMap, RestsSwitchedOutputsByTheirPolarity) {
    const OutputRegisters resting = map_of(with_switched_outputs()).encode(0);
    EXPECT_EQ(resting, (OutputRegisters{0x20, 0x0F})) << "pin 7 and pin 16 are high, as both are off";
    EXPECT_EQ(map_of({}).encode(kSwitchedMask), map_of({}).encode(0)) << "not wired";
}

TEST(PinMap, SwitchedOutputsComeBackBesideEveryOtherOutput) {
    const PinMap sut = map_of(with_switched_outputs());
    EXPECT_TRUE(sut.is_wired(Signal::flood));
    EXPECT_FALSE(sut.is_wired(Signal::output_0));
    const SignalWord wired = bit_of(Signal::mist) | bit_of(Signal::flood) | bit_of(Signal::output_3) |
                             (kMachineOutputMask & ~bit_of(Signal::spindle));
    for (SwitchedOutputs on = 0; on <= kAllSwitchedOutputs; ++on) {
        for (SignalWord machine = 0; machine <= kMachineOutputMask; machine += 7) {
            const SignalWord levels = machine | levels_of(on);
            SignalWord seen = levels & wired;
            if ((seen & kEnableMask) != 0) seen |= kEnableMask;
            ASSERT_EQ(sut.outputs_from_registers(sut.encode(levels)), seen) << levels;
        }
    }
}

TEST(PinMap, ActiveLowTurnsThePin) {
    Profile profile;
    profile.port.pins[index_of(Signal::r1_step)] = -5;
    profile.port.pins[index_of(Signal::y_step)] = -14;
    const PinMap sut = map_of(profile);
    EXPECT_EQ(sut.encode(0), (OutputRegisters{0x08, 0x09}));
    EXPECT_EQ(sut.encode(bit_of(Signal::r1_step) | bit_of(Signal::y_step)), (OutputRegisters{0x00, 0x0B}));
    EXPECT_EQ(sut.pin_of(Signal::r1_step), 5);
}

TEST(PinMap, PositiveLowTurnsTheDirectionPinAlone) {
    Profile profile;
    profile.r1.positive_is_high = false;
    const PinMap sut = map_of(profile);
    EXPECT_EQ(sut.encode(0), (OutputRegisters{0x80, 0x0B}));
    EXPECT_EQ(sut.encode(bit_of(Signal::r1_dir) | bit_of(Signal::r1_step)), (OutputRegisters{0x08, 0x0B}));
}

TEST(PinMap, ActiveLowAndPositiveLowTogetherCancel) {
    Profile profile;
    profile.r1.positive_is_high = false;
    profile.port.pins[index_of(Signal::r1_dir)] = -9;
    EXPECT_EQ(map_of(profile).encode(bit_of(Signal::r1_dir)), (OutputRegisters{0x80, 0x0B}));
}

TEST(PinMap, ActiveLowEnablesOnOnePinAreActiveWhileEitherIs) {
    Profile profile;
    profile.port.pins[index_of(Signal::r1_enable)] = -6;
    profile.port.pins[index_of(Signal::psi_enable)] = -6;
    const PinMap sut = map_of(profile);
    EXPECT_EQ(sut.encode(0).data, 0x10);
    EXPECT_EQ(sut.encode(bit_of(Signal::r1_enable)).data, 0x00);
    EXPECT_EQ(sut.encode(bit_of(Signal::psi_enable)).data, 0x00);
}

TEST(PinMap, TheChargePumpIsABitOfItsOwn) {
    Profile profile;
    profile.port.pins[index_of(Signal::y_enable)] = 6;
    for (const int pin : {1, -1}) {
        profile.port.charge_pump_pin = pin;
        const PinMap sut = map_of(profile);
        EXPECT_EQ(sut.pin_of(Signal::charge_pump), 1);
        for (SignalWord levels = 0; levels <= kMachineOutputMask; ++levels) {
            const OutputRegisters still = sut.encode(levels);
            const OutputRegisters pumped = sut.encode(levels | kChargePumpBit);
            ASSERT_EQ(still.data, pumped.data);
            ASSERT_EQ(still.control ^ pumped.control, 1);
            ASSERT_EQ(sut.outputs_from_registers(pumped), sut.outputs_from_registers(still) | kChargePumpBit);
            ASSERT_EQ(sut.outputs_from_registers(still) & kChargePumpBit, 0U);
        }
        // Safe: the pin is low, or high where it is active low.
        EXPECT_EQ(sut.pins_from_registers(sut.encode(0)) >> 1 & 1U, pin < 0 ? 1U : 0U);
    }
}

TEST(PinMap, PinLevelsAreElectric) {
    const PinMap sut = map_of({});
    EXPECT_EQ(sut.pins_from_registers({0x00, 0x0B}), 0U);
    EXPECT_EQ(sut.pins_from_registers({0x09, 0x0F}), (1U << 2) | (1U << 5) | (1U << 16));
    EXPECT_EQ(sut.pins_from_registers({0x00, 0x00}), (1U << 1) | (1U << 14) | (1U << 17));
}

TEST(PinMap, ADriveWhoseEnableIsNotWiredIsAlwaysOn) {
    Profile profile;
    profile.port.pins[index_of(Signal::y_enable)] = 0;
    const PinMap sut = map_of(profile);
    EXPECT_EQ(sut.outputs_from_registers(sut.encode(0)), bit_of(Signal::y_enable));
}

TEST(PinMap, RefusesWhatThePortCannotCarry) {
    Profile profile;
    profile.port.pins[index_of(Signal::spindle)] = 18;
    const auto impossible = PinMap::from_profile(profile);
    ASSERT_FALSE(impossible);
    EXPECT_NE(impossible.error().message.find("port.pins.spindle: the port has no signal pin 18"),
              std::string::npos);
    profile.port.pins[index_of(Signal::spindle)] = 2;
    const auto shared = PinMap::from_profile(profile);
    ASSERT_FALSE(shared);
    EXPECT_NE(shared.error().message.find("output pin 2"), std::string::npos);
}

TEST(PinPlace, FivePinsAreInputsAndTwelveAreOutputs) {
    int inputs = 0;
    int outputs = 0;
    for (int pin = -1; pin <= 26; ++pin) {
        const bool exists = place_of_pin(pin).has_value();
        EXPECT_EQ(exists, pin >= 1 && pin <= 17) << pin;
        if (is_input_pin(pin)) ++inputs;
        if (exists && !is_input_pin(pin)) ++outputs;
    }
    EXPECT_EQ(inputs, 5);
    EXPECT_EQ(outputs, 12);
}

}  // namespace
TEST(PoweredOutputs, AreNamedWhereTheyAreWired) {
    Profile profile;
    EXPECT_EQ(names_of_powered(profile), "drives and spindle");
    profile.port.pins[index_of(Signal::mist)] = 1;
    profile.port.pins[index_of(Signal::output_2)] = -7;
    EXPECT_EQ(names_of_powered(profile), "drives, spindle, mist and output_2");
}

}  // namespace psicarve
