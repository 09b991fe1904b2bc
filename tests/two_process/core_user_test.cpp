// SPDX-License-Identifier: GPL-3.0-or-later
// A core that root starts and that goes on as another user, on a port and in files that the user cannot get
// at.
#include <pwd.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>

#include "tests/two_process/kernel_facts.hpp"
#include "tests/two_process/port_rig.hpp"

namespace psicarve::two_process {
namespace {

constexpr const char* kUser = "nobody";

/// This process looks at files as the user does, while it lives.
class AsUser {
public:
    explicit AsUser(const passwd& user) { EXPECT_EQ(::seteuid(user.pw_uid), 0); }
    ~AsUser() { EXPECT_EQ(::seteuid(0), 0); }
    AsUser(const AsUser&) = delete;
    AsUser& operator=(const AsUser&) = delete;
};

/// The kernel shows nobody the memory of a process that has left root, which a search for leaks needs.
class WithoutLeakSearch {
public:
    WithoutLeakSearch() {
        if (const char* const options = std::getenv("ASAN_OPTIONS")) before_ = options;
        ::setenv("ASAN_OPTIONS", (before_.value_or("") + ":detect_leaks=0").c_str(), 1);
    }
    ~WithoutLeakSearch() {
        before_ ? ::setenv("ASAN_OPTIONS", before_->c_str(), 1) : ::unsetenv("ASAN_OPTIONS");
    }
    WithoutLeakSearch(const WithoutLeakSearch&) = delete;
    WithoutLeakSearch& operator=(const WithoutLeakSearch&) = delete;

private:
    std::optional<std::string> before_;
};

class CoreUser : public PortRig {
protected:
    CoreUser() : user_(*::getpwnam(kUser)) {
        home_by_one_sensor();
        // The folder of outputs is the user's; what else the test has made stays root's.
        std::filesystem::create_directory(file("out"));
        std::filesystem::permissions(file(""), std::filesystem::perms{0711});
        if (is_root()) {
            EXPECT_EQ(::chown(file("out").c_str(), user_.pw_uid, user_.pw_gid), 0);
        }
    }
    static bool is_root() { return ::geteuid() == 0; }

    /// What a tester who is not root sees of it: nobody may be somebody else.
    void expect_refused_but_by_root() {
        CoreProcess refused{{"--segment", segment_name_, "--user", kUser}, file("core.err")};
        EXPECT_EQ(refused.wait_for_exit(), 2);
        EXPECT_NE(text_of(file("core.err")).find("only root"), std::string::npos);
    }
    void start_as_user(std::vector<std::string> more = {}) {
        more.insert(more.begin(), {"--user", kUser});
        const AsUser looking{user_};
        std::vector<std::string> arguments = port_arguments(segment_name_);
        arguments.insert(arguments.end(), more.begin(), more.end());
        {
            // Started by root.
            ASSERT_EQ(::seteuid(0), 0);
            const fake_port::FakePortFile::Preload preload{port_};
            core_ = std::make_unique<CoreProcess>(arguments, file("core.err"));
            ASSERT_EQ(::seteuid(user_.pw_uid), 0);
        }
        attach();
        ASSERT_TRUE(eventually([&] {
            core_pid_ = static_cast<pid_t>(segment_->core_pid().value_or(0));
            return core_pid_ != 0 && status().tick > 10;
        })) << text_of(file("core.err"));
    }
    void expect_to_be_user(pid_t process) {
        const std::string user = std::to_string(user_.pw_uid);
        const std::string group = std::to_string(user_.pw_gid);
        for (const pid_t thread : threads_of(process)) {
            auto facts = kernel_facts(process, thread);
            EXPECT_EQ(facts["Uid"], user + "\t" + user + "\t" + user + "\t" + user) << facts["Name"];
            EXPECT_EQ(facts["Gid"], group + "\t" + group + "\t" + group + "\t" + group) << facts["Name"];
            EXPECT_EQ(facts["Groups"], group + " ") << facts["Name"];
            EXPECT_EQ(std::stoull(facts["CapEff"], nullptr, 16) & ~kReplacedByLimits, 0U) << facts["Name"];
            EXPECT_EQ(std::stoull(facts["CapPrm"], nullptr, 16) & ~kReplacedByLimits, 0U) << facts["Name"];
            EXPECT_EQ(facts["NoNewPrivs"], "1") << facts["Name"];
        }
    }
    struct stat facts_of(const std::string& path) {
        struct stat facts {};
        EXPECT_EQ(::stat(path.c_str(), &facts), 0) << path;
        return facts;
    }

    const passwd user_;
    const WithoutLeakSearch without_leak_search_;
};

TEST_F(CoreUser, IsThatOfCoreGuardSegmentAndOutputs) {
    if (!is_root()) return expect_refused_but_by_root();
    start_as_user({"--trace", file("out/pins.trace")});
    expect_to_be_user(core_pid_);
    expect_to_be_user(core_->pid());
    for (const std::string& path : {"/dev/shm" + segment_name_, file("out/pins.trace")}) {
        EXPECT_EQ(facts_of(path).st_uid, user_.pw_uid) << path;
        EXPECT_EQ(facts_of(path).st_gid, user_.pw_gid) << path;
    }
    EXPECT_EQ(facts_of("/dev/shm" + segment_name_).st_mode & 0777, 0600U);
    {
        const AsUser looking{user_};
        EXPECT_FALSE(std::ifstream{"/proc/" + std::to_string(core_pid_) + "/environ"})
            << "by the core the user's other programs would have the port";
    }
    home();
    EXPECT_GT(pulses_on_the_cable(), 0U);
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0) << text_of(file("core.err"));
    EXPECT_TRUE(is_safe());
    EXPECT_GT(std::filesystem::file_size(file("out/pins.trace")), 0U);
}

TEST_F(CoreUser, WhoIsKilledIsBuriedByAGuardOfTheSameUser) {
    if (!is_root()) return expect_refused_but_by_root();
    start_as_user();
    home();
    ::kill(core_pid_, SIGKILL);
    EXPECT_EQ(core_->wait_for_exit(), 128 + SIGKILL);
    EXPECT_TRUE(is_safe());
    EXPECT_EQ(status().state, MachineState::alarm);
    EXPECT_EQ(status().alarm_cause, AlarmCause::core_lost);
}

TEST_F(CoreUser, TakesOrdersByItsGuard) {
    if (!is_root()) return expect_refused_but_by_root();
    start_as_user();
    core_->send_signal(SIGTERM);
    EXPECT_EQ(core_->wait_for_exit(), 0) << text_of(file("core.err"));
    EXPECT_TRUE(is_safe());
}

TEST_F(CoreUser, WritesNothingThatIsRoots) {
    if (!is_root()) return expect_refused_but_by_root();
    CoreProcess refused{
        {"--segment", segment_name_, "--clock", "virtual", "--user", kUser, "--trace", file("pins.trace")},
        file("core.err")};
    EXPECT_EQ(refused.wait_for_exit(), 3) << text_of(file("core.err"));
    EXPECT_NE(text_of(file("core.err")).find("pins.trace"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(file("pins.trace")));
}

TEST_F(CoreUser, IsAnotherThanRootAndOneThatThereIs) {
    for (const char* wrong : {"root", "no-such-user", ""}) {
        CoreProcess refused{{"--segment", segment_name_, "--user", wrong}, file("core.err")};
        EXPECT_EQ(refused.wait_for_exit(), 2) << wrong;
        EXPECT_NE(text_of(file("core.err")).find("--user"), std::string::npos) << wrong;
    }
    EXPECT_FALSE(std::filesystem::exists("/dev/shm" + segment_name_)) << "refused before anything is made";
}

}  // namespace
}  // namespace psicarve::two_process
