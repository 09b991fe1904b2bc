// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/port_address.hpp"

#include <gtest/gtest.h>
#include <linux/parport.h>

#include <filesystem>
#include <fstream>

#include "rtcore/port/extended_mode.hpp"
#include "rtcore/port/ppdev_port.hpp"

namespace psicarve::port {
namespace {

TEST(PortAddress, KnowsThreeKinds) {
    EXPECT_TRUE(parse_port_address("sim")->is_simulated());
    const auto ppdev = parse_port_address("ppdev:/dev/parport1");
    ASSERT_TRUE(ppdev);
    EXPECT_EQ(ppdev->kind, PortKind::ppdev);
    EXPECT_EQ(ppdev->device, "/dev/parport1");
    const auto raw = parse_port_address("io:0x3BC");
    ASSERT_TRUE(raw);
    EXPECT_EQ(raw->kind, PortKind::raw);
    EXPECT_EQ(raw->base, 0x3bc);
}

TEST(PortAddress, RefusesWhatIsNeither) {
    for (const char* text : {"", "sim ", "ppdev:", "ppdev:parport0", "io:", "io:378", "io:0x", "io:0x10000",
                             "io:0x378 ", "io:-0x378", "usb:1"}) {
        const auto parsed = parse_port_address(text);
        ASSERT_FALSE(parsed) << text;
        EXPECT_EQ(parsed.error().code, ErrorCode::bad_usage);
    }
}

TEST(ExtendedMode, IsReadFromAByteThatCanBeNothingElse) {
    EXPECT_EQ(extended_mode_text(0x15, 0xcb), "SPP");
    EXPECT_EQ(extended_mode_text(0x35, 0xcb), "PS/2");
    EXPECT_EQ(extended_mode_text(0x75, 0xcb), "ECP");
    EXPECT_EQ(extended_mode_text(0x95, 0xcb), "EPP");
    EXPECT_EQ(extended_mode_text(0xff, 0xcb), "") << "nothing answers";
    EXPECT_EQ(extended_mode_text(0xc9, 0xc9), "") << "an old board shows the control register once more";
    EXPECT_EQ(extended_mode_text(0x74, 0xcb), "") << "a buffer neither empty nor full at rest";
}

TEST(PortModes, AreNamed) {
    EXPECT_EQ(port_modes_text(PARPORT_MODE_PCSPP), "SPP");
    EXPECT_EQ(port_modes_text(PARPORT_MODE_PCSPP | PARPORT_MODE_TRISTATE | PARPORT_MODE_EPP |
                              PARPORT_MODE_ECP | PARPORT_MODE_DMA),
              "SPP, PS/2, EPP, ECP");
    EXPECT_EQ(port_modes_text(0), "mode unknown");
}

}  // namespace
}  // namespace psicarve::port
