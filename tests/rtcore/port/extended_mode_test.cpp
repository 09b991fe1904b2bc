// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/extended_mode.hpp"

#include <gtest/gtest.h>

#include <map>
#include <utility>
#include <vector>

namespace psicarve::port {
namespace {

constexpr std::uint16_t kBase = 0x378;
constexpr std::uint16_t kExtended = 0x77a;

/// Remembers what is written, where something keeps it.
class FakeBus : public Bus {
public:
    std::uint8_t read(std::uint16_t address) override { return bytes[address]; }
    void write(std::uint16_t address, std::uint8_t byte) override {
        writes.emplace_back(address, byte);
        if (is_register) bytes[address] = static_cast<std::uint8_t>((byte & 0xfc) | 0x01);
    }
    std::map<std::uint16_t, std::uint8_t> bytes{{kBase + 2, 0xcb}};
    std::vector<std::pair<std::uint16_t, std::uint8_t>> writes;
    bool is_register = true;
};

TEST(ExtendedMode, StandsWhereTheKernelSays) {
    const std::vector<KernelPort> ports{
        {.name = "parport0", .base = 0xd000, .extended_base = 0xd008, .holder = ""},
        {.name = "parport1", .base = 0xd010, .extended_base = 0, .holder = ""},
        {.name = "parport2", .base = 0x278, .extended_base = 0, .holder = ""}};
    EXPECT_EQ(extended_address(0xd000, ports), 0xd00a);
    EXPECT_EQ(extended_address(0xd010, ports), std::nullopt) << "another device's registers";
    EXPECT_EQ(extended_address(0x278, ports), std::nullopt) << "the kernel knows better";
    EXPECT_EQ(extended_address(0x378, ports), 0x77a);
    EXPECT_EQ(extended_address(0xe000, ports), std::nullopt);
}

TEST(ExtendedMode, IsLeftForPlainAccess) {
    FakeBus bus;
    bus.bytes[kExtended] = 0x75;
    EXPECT_EQ(take_plain_mode(bus, kBase, kExtended), "found in mode ECP");
    EXPECT_EQ(bus.bytes[kExtended], 0x15);
}

TEST(ExtendedMode, NothingIsWrittenToWhatIsNoSuchRegister) {
    for (const int byte : {0xff, 0xcb, 0x74}) {
        FakeBus bus;
        bus.bytes[kExtended] = static_cast<std::uint8_t>(byte);
        EXPECT_EQ(take_plain_mode(bus, kBase, kExtended), "SPP");
        EXPECT_TRUE(bus.writes.empty());
    }
}

TEST(ExtendedMode, WhatOnlyLooksLikeOneGetsItsByteBack) {
    FakeBus bus;
    bus.is_register = false;
    bus.bytes[kExtended] = 0x55;
    EXPECT_EQ(take_plain_mode(bus, kBase, kExtended), "mode unknown");
    ASSERT_FALSE(bus.writes.empty());
    EXPECT_EQ(bus.writes.back(), std::make_pair(kExtended, std::uint8_t{0x55}));
}

}  // namespace
}  // namespace psicarve::port
