// SPDX-License-Identifier: GPL-3.0-or-later
// A core that root starts and that goes on as another user, on a port and in files that the user cannot get
// at.
#include <pwd.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>

#include "tests/two_process/kernel_facts.hpp"
#include "tests/two_process/port_rig.hpp"

namespace psicarve::two_process {
namespace {

constexpr const char* kUser = "nobody";

struct Ids {
    uid_t uid;
    gid_t gid;
};

/// This process looks at files as the user does, while it lives.
class AsUser {
public:
    explicit AsUser(const Ids& user) { EXPECT_EQ(::seteuid(user.uid), 0); }
    ~AsUser() { EXPECT_EQ(::seteuid(0), 0); }
    AsUser(const AsUser&) = delete;
    AsUser& operator=(const AsUser&) = delete;
};

/// While it lives, processes that this one starts see nothing of other users' processes in /proc, as where it
/// is mounted with hidepid.
class HiddenProcesses {
public:
    HiddenProcesses() : before_(::open("/proc/self/ns/mnt", O_RDONLY | O_CLOEXEC)) {
        are_hidden_ = before_ >= 0 && ::unshare(CLONE_NEWNS) == 0 &&
                      ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                      ::mount("proc", "/proc", "proc", 0, "hidepid=2") == 0;
    }
    ~HiddenProcesses() {
        if (before_ < 0) return;
        EXPECT_EQ(::setns(before_, CLONE_NEWNS), 0);
        ::close(before_);
    }
    HiddenProcesses(const HiddenProcesses&) = delete;
    HiddenProcesses& operator=(const HiddenProcesses&) = delete;
    /// False: this computer does not let us.
    bool are_hidden() const { return are_hidden_; }

private:
    int before_;
    bool are_hidden_ = false;
};

/// The kernel hides the memory of a process that has left root, which a search for leaks needs.
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
    CoreUser() {
        const passwd* const entry = ::getpwnam(kUser);
        EXPECT_NE(entry, nullptr);
        if (entry != nullptr) user_ = {entry->pw_uid, entry->pw_gid};
        home_by_one_sensor();
        // The folder of outputs is the user's; what else the test has made stays root's.
        std::filesystem::create_directory(file("out"));
        std::filesystem::permissions(file(""), std::filesystem::perms{0711});
        if (is_root()) {
            EXPECT_EQ(::chown(file("out").c_str(), user_.uid, user_.gid), 0);
        }
    }
    static bool is_root() { return ::geteuid() == 0; }
    void SetUp() override {
        if (!is_root()) GTEST_SKIP() << "needs root; BecomeUser.IsForRootAlone is what others see";
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
            ASSERT_EQ(::seteuid(user_.uid), 0);
        }
        attach();
        ASSERT_TRUE(eventually([&] {
            core_pid_ = static_cast<pid_t>(segment_->core_pid().value_or(0));
            return core_pid_ != 0 && status().tick > 10;
        })) << text_of(file("core.err"));
    }
    void expect_to_be_user(pid_t process) {
        const bool has_limits = text_of(file("core.err")).find(" stays: ") == std::string::npos;
        const unsigned long long allowed = has_limits ? 0 : kReplacedByLimits;
        const std::string user = std::to_string(user_.uid);
        const std::string group = std::to_string(user_.gid);
        for (const pid_t thread : threads_of(process)) {
            auto facts = kernel_facts(process, thread);
            EXPECT_EQ(facts["Uid"], user + "\t" + user + "\t" + user + "\t" + user) << facts["Name"];
            EXPECT_EQ(facts["Gid"], group + "\t" + group + "\t" + group + "\t" + group) << facts["Name"];
            EXPECT_EQ(facts["Groups"], group + " ") << facts["Name"];
            EXPECT_EQ(std::stoull(facts["CapEff"], nullptr, 16) & ~allowed, 0U) << facts["Name"];
            EXPECT_EQ(std::stoull(facts["CapPrm"], nullptr, 16) & ~allowed, 0U) << facts["Name"];
            EXPECT_EQ(facts["NoNewPrivs"], "1") << facts["Name"];
        }
    }
    struct stat facts_of(const std::string& path) {
        struct stat facts {};
        EXPECT_EQ(::stat(path.c_str(), &facts), 0) << path;
        return facts;
    }

    Ids user_{};
    const WithoutLeakSearch without_leak_search_;
};

TEST_F(CoreUser, IsThatOfCoreGuardSegmentAndOutputs) {
    start_as_user({"--trace", file("out/pins.trace")});
    expect_to_be_user(core_pid_);
    expect_to_be_user(core_->pid());
    for (const std::string& path : {"/dev/shm" + segment_name_, file("out/pins.trace")}) {
        EXPECT_EQ(facts_of(path).st_uid, user_.uid) << path;
        EXPECT_EQ(facts_of(path).st_gid, user_.gid) << path;
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
    start_as_user();
    home();
    ::kill(core_pid_, SIGKILL);
    EXPECT_EQ(core_->wait_for_exit(), 128 + SIGKILL);
    EXPECT_TRUE(is_safe());
    EXPECT_EQ(status().state, MachineState::alarm);
    EXPECT_EQ(status().alarm_cause, AlarmCause::core_lost);
}

// A guard that takes a pause for death switches off under a core that does not know, and stays homed.
TEST_F(CoreUser, WhoPausesUnseenIsNotTakenForDead) {
    const HiddenProcesses hidden;
    if (!hidden.are_hidden()) GTEST_SKIP() << "needs to mount /proc";
    start_as_user();
    for (int pause = 0; pause < 3; ++pause) {
        ::kill(core_pid_, SIGSTOP);
        std::this_thread::sleep_for(milliseconds{20});
        const std::uint64_t writes = port_.state().write_count.load();
        // Three looks of the guard's, of which it needs twenty-five in a row.
        std::this_thread::sleep_for(milliseconds{80});
        EXPECT_EQ(port_.state().write_count.load(), writes);
        ::kill(core_pid_, SIGCONT);
        const std::uint64_t tick = status().tick;
        ASSERT_TRUE(eventually([&] { return status().tick > tick; }));
    }
    ::kill(core_pid_, SIGKILL);
    EXPECT_EQ(core_->wait_for_exit(), 128 + SIGKILL);
    EXPECT_TRUE(is_safe());
}

TEST_F(CoreUser, TakesOrdersByItsGuard) {
    start_as_user();
    core_->send_signal(SIGTERM);
    EXPECT_EQ(core_->wait_for_exit(), 0) << text_of(file("core.err"));
    EXPECT_TRUE(is_safe());
}

TEST_F(CoreUser, WritesNothingThatIsRoots) {
    CoreProcess refused{
        {"--segment", segment_name_, "--clock", "virtual", "--user", kUser, "--trace", file("pins.trace")},
        file("core.err")};
    EXPECT_EQ(refused.wait_for_exit(), 3) << text_of(file("core.err"));
    EXPECT_NE(text_of(file("core.err")).find("pins.trace"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(file("pins.trace")));
}

TEST_F(CoreUser, ReadsNothingThatIsRoots) {
    EXPECT_EQ(::chmod(file("machine.toml").c_str(), 0600), 0);
    CoreProcess refused{{"--segment", segment_name_, "--clock", "virtual", "--user", kUser, "--profile",
                         file("machine.toml")},
                        file("core.err")};
    EXPECT_EQ(refused.wait_for_exit(), 3);
    EXPECT_NE(text_of(file("core.err")).find("Permission denied"), std::string::npos)
        << text_of(file("core.err"));
}

TEST_F(CoreUser, TakesOverWhatACoreOfRootsLeft) {
    start_core({"--profile", file("machine.toml")});
    EXPECT_EQ(publish(coarse_job(2)), "");
    {
        CoreProcess second{{"--segment", segment_name_, "--clock", "virtual", "--user", kUser},
                           file("second.err")};
        EXPECT_EQ(second.wait_for_exit(), 3) << "a living core has it";
        EXPECT_NE(text_of(file("second.err")).find("belongs to user root"), std::string::npos);
    }
    EXPECT_EQ(facts_of("/dev/shm" + segment_name_).st_uid, 0U);
    core_->send_signal(SIGKILL);
    core_->wait_for_exit();
    core_ = std::make_unique<CoreProcess>(
        std::vector<std::string>{"--segment", segment_name_, "--clock", "virtual", "--user", kUser},
        file("core.err"));
    ASSERT_TRUE(eventually([&] { return segment_->core_pid() == std::uint32_t(core_->pid()); }))
        << text_of(file("core.err"));
    EXPECT_EQ(facts_of("/dev/shm" + segment_name_).st_uid, user_.uid);
    EXPECT_EQ(facts_of("/dev/shm" + segment_name_).st_mode & 0777, 0600U);
    ASSERT_EQ(refusal_of(CommandKind::shutdown), "");
    EXPECT_EQ(core_->wait_for_exit(), 0);
}

TEST_F(CoreUser, HasToBeOfTheSegmentsGroup) {
    const auto expect_refusal = [this] {
        CoreProcess refused{
            {"--segment", segment_name_, "--clock", "virtual", "--user", kUser, "--group", "daemon"},
            file("refused.err")};
        EXPECT_EQ(refused.wait_for_exit(), 2);
        EXPECT_NE(text_of(file("refused.err")).find("adduser nobody daemon"), std::string::npos)
            << text_of(file("refused.err"));
    };
    expect_refusal();
    EXPECT_FALSE(std::filesystem::exists("/dev/shm" + segment_name_));
    // What a core of root's left is not the user's then.
    start_core({"--profile", file("machine.toml")});
    core_->send_signal(SIGKILL);
    core_->wait_for_exit();
    expect_refusal();
    EXPECT_EQ(facts_of("/dev/shm" + segment_name_).st_uid, 0U);
    EXPECT_EQ(facts_of("/dev/shm" + segment_name_).st_gid, 0U);
}

// The kernel forgets whose end is to end a process when that process changes its user.
TEST_F(CoreUser, EndsWithItsParentAllTheSame) {
    const pid_t parent = ::fork();
    if (parent == 0) {
        const CoreProcess core{{"--segment", segment_name_, "--clock", "virtual", "--capacity", "100x20",
                                "--user", kUser, "--exit-with-parent"},
                               file("core.err")};
        ::pause();
        ::_exit(0);
    }
    {
        const AsUser looking{user_};
        attach();
        EXPECT_TRUE(eventually([&] { return segment_->core_pid().value_or(0) != 0; }));
    }
    ::kill(parent, SIGKILL);
    ::waitpid(parent, nullptr, 0);
    EXPECT_TRUE(eventually([&] { return segment_->core_pid().value_or(0) == 0; }));
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
