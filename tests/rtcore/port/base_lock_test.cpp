// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/base_lock.hpp"

#include <fcntl.h>
#include <grp.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "tests/shared/temporary_folder.hpp"

namespace psicarve::port {
namespace {

constexpr std::uint16_t kLockedBase = 0x378;
constexpr std::uint16_t kLockedRegisters = 3;

/// Unique to this process: tests run beside each other.
std::string own_name() {
    return "psicarve-test-" + std::to_string(getpid());
}

TEST(BaseLock, OfARangeIsForOneAtATimeAndForItsAddressesAlone) {
    const test::TemporaryFolder folder;
    const std::string device = folder.path("port");
    std::ofstream{device};
    const auto first = lock_range(device, kLockedBase, kLockedRegisters);
    ASSERT_TRUE(first && *first) << first.error().message;
    const auto second = lock_range(device, kLockedBase + 2, kLockedRegisters);
    ASSERT_FALSE(second) << "they overlap";
    EXPECT_NE(second.error().message.find("busy"), std::string::npos) << second.error().message;
    const auto other = lock_range(device, 0x278, kLockedRegisters);
    ASSERT_TRUE(other && *other) << "another port";
    ::close(**other);
    ::close(**first);
    const auto third = lock_range(device, kLockedBase, kLockedRegisters);
    ASSERT_TRUE(third && *third);
    ::close(**third);
}

TEST(BaseLock, OfARangeNeedsTheDevice) {
    const test::TemporaryFolder folder;
    const auto none = lock_range(folder.path("port"), kLockedBase, kLockedRegisters);
    ASSERT_TRUE(none);
    EXPECT_FALSE(*none);
}

TEST(BaseLock, OfANameIsForOneAtATimeAndNamesItsHolder) {
    const auto first = lock_name(own_name());
    ASSERT_TRUE(first) << first.error().message;
    const auto second = lock_name(own_name());
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().message.find("pid " + std::to_string(getpid())), std::string::npos)
        << second.error().message;
    const auto other = lock_name(own_name() + "0");
    ASSERT_TRUE(other);
    ::close(*other);
    ::close(*first);
    const auto third = lock_name(own_name());
    ASSERT_TRUE(third) << third.error().message;
    ::close(*third);
}

TEST(BaseLock, OfANameGoesWithItsHolderHoweverItEnds) {
    const pid_t child = fork();
    if (child == 0) {
        static_cast<void>(lock_name(own_name() + "-child"));
        kill(getpid(), SIGKILL);
    }
    int status = 0;
    waitpid(child, &status, 0);
    const auto lock = lock_name("psicarve-test-" + std::to_string(child) + "-child");
    ASSERT_TRUE(lock) << lock.error().message;
    ::close(*lock);
}

/// A process that has signed a device, until it is killed.
class Signer {
public:
    explicit Signer(const std::string& device) {
        std::array<int, 2> done{-1, -1};
        EXPECT_EQ(pipe(done.data()), 0);
        pid_ = fork();
        if (pid_ == 0) {
            const int own = open(device.c_str(), O_RDWR);
            sign_device(own);
            static_cast<void>(!write(done[1], "x", 1));
            for (;;) pause();
        }
        char byte = 0;
        EXPECT_EQ(read(done[0], &byte, 1), 1);
        for (const int end : done) close(end);
    }
    ~Signer() { end(); }
    Signer(const Signer&) = delete;
    Signer& operator=(const Signer&) = delete;
    void end() {
        if (pid_ > 0) kill(pid_, SIGKILL);
        if (pid_ > 0) waitpid(pid_, nullptr, 0);
        pid_ = -1;
    }
    pid_t pid() const { return pid_; }

private:
    pid_t pid_ = -1;
};

/// What another process reads that has the device open, too: as another user where we may become one.
std::string signer_seen_by_another(int descriptor) {
    std::array<int, 2> answer{-1, -1};
    EXPECT_EQ(pipe(answer.data()), 0);
    const pid_t other = fork();
    if (other == 0) {
        constexpr uid_t kNobody = 65534;
        if (geteuid() == 0 && (setgroups(0, nullptr) != 0 || setgid(kNobody) != 0 || setuid(kNobody) != 0))
            _exit(1);
        const std::string seen = signer_of(descriptor);
        static_cast<void>(!write(answer[1], seen.data(), seen.size()));
        _exit(0);
    }
    close(answer[1]);
    std::array<char, 256> text{};
    const ssize_t bytes = read(answer[0], text.data(), text.size());
    close(answer[0]);
    waitpid(other, nullptr, 0);
    return {text.data(), static_cast<std::size_t>(std::max<ssize_t>(bytes, 0))};
}

TEST(DeviceSignature, TellsAnotherUserWhoseItIsAndGoesWithThatProcess) {
    const test::TemporaryFolder folder;
    const std::string device = folder.path("parport0");
    std::ofstream{device};
    const int descriptor = open(device.c_str(), O_RDWR | O_CLOEXEC);
    EXPECT_EQ(signer_seen_by_another(descriptor), "");
    Signer signer{device};
    const std::string seen = signer_seen_by_another(descriptor);
    EXPECT_NE(seen.find("sim_port_test (pid " + std::to_string(signer.pid()) + ")"), std::string::npos)
        << seen;
    signer.end();
    EXPECT_EQ(signer_seen_by_another(descriptor), "");
    close(descriptor);
}

}  // namespace
}  // namespace psicarve::port
