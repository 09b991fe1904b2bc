// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/raw_port.hpp"

#include <gtest/gtest.h>
#include <linux/parport.h>
#include <linux/ppdev.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <filesystem>
#include <fstream>

#include "rtcore/port/base_lock.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace {

// The kernel's part, before the C library's own: addresses that nobody touches here, and a driver whose port
// somebody else has.
int claims = 0;

int answer_of_a_busy_port(unsigned long request, void* argument) {
    if (request == PPGETMODES) {
        *static_cast<unsigned*>(argument) = PARPORT_MODE_PCSPP;
        return 0;
    }
    if (request == PPEXCL || request == PPCLAIM) ++claims;
    errno = ENXIO;
    return -1;
}

}  // namespace

extern "C" {
int ioperm(unsigned long /*from*/, unsigned long /*count*/, int /*on*/) noexcept {
    return 0;
}
int ioctl(int /*descriptor*/, unsigned long request, ...) noexcept {
    va_list list;
    va_start(list, request);
    void* const argument = va_arg(list, void*);
    va_end(list);
    return answer_of_a_busy_port(request, argument);
}
}

namespace psicarve::port {
namespace {

class RawPort : public ::testing::Test {
protected:
    RawPort() {
        put("proc/sys/dev/parport/parport0/base-addr", "888\t0\n");
        put("proc/sys/dev/parport/parport0/devices/active", "none\n");
        put("dev/port", "");
        put("dev/parport0", "");
    }
    void put(const std::string& path, const std::string& text) const {
        std::filesystem::create_directories(std::filesystem::path{folder_.path(path)}.parent_path());
        std::ofstream{folder_.path(path)} << text;
    }
    std::string refusal() const {
        const auto open = open_raw(0x378, PinMap::from_profile(Profile{}).value(),
                                   {.proc = folder_.path("proc"), .dev = folder_.path("dev")});
        return open ? "" : open.error().message;
    }
    const test::TemporaryFolder folder_;
};

// The claim writes to the port: spindle on, with the default wiring.
TEST_F(RawPort, IsNotClaimedBeforeTheLockOfItsBaseIsOurs) {
    const auto others = lock_range(folder_.path("dev/port"), 0x378, 3);
    ASSERT_TRUE(others && *others);
    claims = 0;
    EXPECT_NE(refusal().find("busy"), std::string::npos) << refusal();
    EXPECT_EQ(claims, 0) << "another core drives it by its addresses";
    ::close(**others);
    EXPECT_NE(refusal().find("busy"), std::string::npos) << "and the driver's own answer";
    EXPECT_GT(claims, 0);
}

TEST_F(RawPort, RefusedByTheDriverLeavesItsBaseToOthers) {
    EXPECT_NE(refusal(), "");
    const auto others = lock_range(folder_.path("dev/port"), 0x378, 3);
    EXPECT_TRUE(others && *others);
    if (others && *others) ::close(**others);
}

}  // namespace
}  // namespace psicarve::port
