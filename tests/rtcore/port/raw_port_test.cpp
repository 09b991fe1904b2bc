// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/raw_port.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>

#include "rtcore/port/base_lock.hpp"
#include "rtcore/process/privileges.hpp"
#include "shared/computer/kernel_ports.hpp"
#include "tests/rtcore/port/kernel_stand_in.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace {

// The claims of a driver whose port another process has.
int claims = 0;
std::function<void()> at_claim;

}  // namespace

int psicarve::port::test::answer_of_driver(unsigned long request) noexcept {
    if (request == PPEXCL || request == PPCLAIM) {
        ++claims;
        if (at_claim) at_claim();
    }
    errno = ENXIO;
    return -1;
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
    Result<int> lock_its_name() const { return lock_name(base_lock_name(folder_.path("dev"), 0x378)); }
    const psicarve::test::TemporaryFolder folder_;
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

// A core that is let at the device of addresses beside one that is not, as a service that has the capability
// alone: each of them sees the other.
TEST_F(RawPort, IsNotOpenedBesideACoreThatIsNotLetAtTheDevice) {
    const auto others = lock_its_name();
    ASSERT_TRUE(others) << others.error().message;
    claims = 0;
    EXPECT_NE(refusal().find("busy"), std::string::npos) << refusal();
    EXPECT_NE(refusal().find("(pid " + std::to_string(::getpid()) + ")"), std::string::npos) << refusal();
    EXPECT_EQ(claims, 0);
    const auto bytes = lock_range(folder_.path("dev/port"), 0x378, 3);
    EXPECT_TRUE(bytes && *bytes) << "whoever is refused keeps none of its locks";
    if (bytes && *bytes) ::close(**bytes);
    ::close(*others);
}

TEST_F(RawPort, RefusedByTheDriverLeavesItsBaseToOthers) {
    EXPECT_NE(refusal(), "");
    const auto bytes = lock_range(folder_.path("dev/port"), 0x378, 3);
    EXPECT_TRUE(bytes && *bytes);
    EXPECT_NE(refusal().find("busy"), std::string::npos) << "the bytes are in others' hands now";
    if (bytes && *bytes) ::close(**bytes);
    const auto name = lock_its_name();
    EXPECT_TRUE(name) << "whoever is refused keeps none of its locks";
    if (name) ::close(*name);
}

// As a core that has left root for another user.
TEST_F(RawPort, IsClaimedByWhoMayOpenTheDeviceByCapabilityAlone) {
    std::filesystem::permissions(folder_.path("dev/parport0"), std::filesystem::perms{0600});
    claims = 0;
    const pid_t child = ::fork();
    if (child == 0) {
        // A user who is not root cannot become another user, and opens their own files.
        if (::geteuid() == 0) {
            const auto account = rtcore::account_of("nobody");
            if (!account || !rtcore::become_user(*account)) ::_exit(1);
            rtcore::raise_privileges();
        }
        static_cast<void>(refusal());
        ::_exit(claims > 0 ? 0 : 2);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
}

TEST_F(RawPort, HasBothItsLocksBeforeItIsClaimed) {
    bool has_name = false;
    bool has_bytes = false;
    at_claim = [&] {
        has_name = !lock_its_name();
        has_bytes = !lock_range(folder_.path("dev/port"), 0x378, 3);
    };
    EXPECT_NE(refusal(), "");
    at_claim = nullptr;
    EXPECT_TRUE(has_name);
    EXPECT_TRUE(has_bytes);
}

}  // namespace
}  // namespace psicarve::port
