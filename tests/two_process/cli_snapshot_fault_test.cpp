// SPDX-License-Identifier: GPL-3.0-or-later
// A full disk and a kill while `psicarve snapshot save` replaces a snapshot: the old one stays whole.
#include <sys/resource.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <random>

#include "tests/places.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::two_process {
namespace {

class SnapshotFault : public CoreRig {
protected:
    void start_with_a_job() {
        start_core();
        ASSERT_EQ(publish(lobed_job(200, 301)), "");
        ASSERT_EQ(save().wait(), 0);
        before_ = text_of(file("run.psi"));
        ASSERT_GT(before_.size(), 100'000U);
    }

    class Save {
    public:
        explicit Save(pid_t pid) : pid_(pid) {}
        void kill() const { ::kill(pid_, SIGKILL); }
        int wait() const {
            int status = 0;
            waitpid(pid_, &status, 0);
            return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        }

    private:
        pid_t pid_;
    };
    /// Files may grow to so many bytes; 0: to any size.
    Save save(rlim_t most_bytes = 0) const {
        const std::string program = in_build("bin/psicarve");
        const std::string path = file("run.psi");
        const std::string errors = file("save.err");
        const pid_t pid = ::fork();
        if (pid != 0) return Save{pid};
        const rlimit limit{most_bytes, most_bytes};
        if (most_bytes > 0) setrlimit(RLIMIT_FSIZE, &limit);
        signal(SIGXFSZ, SIG_IGN);
        if (::freopen(errors.c_str(), "w", stderr) == nullptr ||
            ::freopen("/dev/null", "w", stdout) == nullptr)
            ::_exit(125);
        ::execl(program.c_str(), "psicarve", "snapshot", "save", path.c_str(), "--segment",
                segment_name_.c_str(), nullptr);
        ::_exit(126);
    }
    std::size_t files() const {
        const auto entries = std::filesystem::directory_iterator(file(""));
        return static_cast<std::size_t>(std::count_if(begin(entries), end(entries), [](const auto& entry) {
            return entry.path().filename().string().find("run.psi") != std::string::npos;
        }));
    }

    std::string before_;
};

TEST_F(SnapshotFault, AFullDiskLeavesTheOldOneAndSaysSo) {
    ASSERT_NO_FATAL_FAILURE(start_with_a_job());
    home();
    for (const rlim_t room : {rlim_t{1}, rlim_t{4096}, static_cast<rlim_t>(before_.size() - 1)}) {
        EXPECT_NE(save(room).wait(), 0);
        EXPECT_TRUE(text_of(file("run.psi")) == before_) << "with room for " << room;
        // What it says is a file, too.
        if (room > 1) {
            EXPECT_NE(text_of(file("save.err")).find("run.psi"), std::string::npos);
        }
        EXPECT_EQ(files(), 1U) << "no half file stays";
    }
    EXPECT_TRUE(load_snapshot(file("run.psi")));
}

TEST_F(SnapshotFault, AKillAtAnyInstantLeavesTheOldOneOrTheNewOneWhole) {
    ASSERT_NO_FATAL_FAILURE(start_with_a_job());
    std::mt19937 random{7};
    int killed = 0;
    for (int round = 0; round < 100; ++round) {
        const Save saving = save();
        std::this_thread::sleep_for(std::chrono::microseconds{static_cast<int>(random() % 30'000)});
        saving.kill();
        killed += saving.wait() == 128 + SIGKILL ? 1 : 0;
        const auto loaded = load_snapshot(file("run.psi"));
        ASSERT_TRUE(loaded) << "round " << round << ": " << loaded.error().message;
        ASSERT_FALSE(loaded->job_blob.empty());
    }
    EXPECT_GT(killed, 10);
    EXPECT_EQ(save().wait(), 0) << "what killed ones left is in nobody's way";
    EXPECT_TRUE(load_snapshot(file("run.psi")));
}

}  // namespace
}  // namespace psicarve::two_process
