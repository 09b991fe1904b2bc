// SPDX-License-Identifier: GPL-3.0-or-later
// A disk that is full tells so at whichever call it likes: all of them are answered here before the kernel is
// asked.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <string>
#include <vector>

#include "shared/file/atomic_file.hpp"
#include "shared/record/snapshot_file.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace {

enum class Call { none, create, write, sync, close, rename };
Call g_failing = Call::none;
int g_calls_before = 0;  ///< so many of these still succeed
int g_failed = 0;

/// Whether this one finds the disk full.
bool finds_it_full(Call call) {
    if (call != g_failing || g_calls_before-- > 0) return false;
    ++g_failed;
    errno = ENOSPC;
    return true;
}

}  // namespace

extern "C" {
int open(const char* path, int flags, ...) {
    mode_t mode = 0;
    if ((flags & (O_CREAT | O_TMPFILE)) != 0) {
        va_list list;
        va_start(list, flags);
        mode = va_arg(list, mode_t);
        va_end(list);
        if (finds_it_full(Call::create)) return -1;
    }
    return static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}
ssize_t write(int file, const void* bytes, size_t count) {
    if (finds_it_full(Call::write)) return -1;
    // As long as there is room: a part of it, as at the end of a disk.
    const size_t put = g_failing == Call::write && count > 4096 ? 4096 : count;
    return syscall(SYS_write, file, bytes, put);
}
int fsync(int file) {
    if (finds_it_full(Call::sync)) return -1;
    return static_cast<int>(syscall(SYS_fsync, file));
}
int close(int file) {
    const auto answer = static_cast<int>(syscall(SYS_close, file));
    return finds_it_full(Call::close) ? -1 : answer;
}
int rename(const char* from, const char* to) noexcept {
    if (finds_it_full(Call::rename)) return -1;
    return static_cast<int>(syscall(SYS_rename, from, to));
}
}

namespace psicarve {
namespace {

/// For as long as it lives, the so-manyth of these calls and all after it find the disk full.
class FullDisk {
public:
    FullDisk(Call call, int calls_before) {
        g_failed = 0;
        g_calls_before = calls_before;
        g_failing = call;
    }
    ~FullDisk() { g_failing = Call::none; }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;
};

class FullDiskTest : public testing::TestWithParam<std::pair<Call, int>> {
protected:
    const test::TemporaryFolder folder_;
    const std::string file_ = folder_.path("file");
};

TEST_P(FullDiskTest, LeavesTheOldSnapshotWholeAndNothingElse) {
    Snapshot old;
    old.job_blob.resize(1000, std::byte{1});
    ASSERT_TRUE(save_snapshot(old, file_));
    const auto before = read_whole_file(file_).value();
    Snapshot fresh;
    fresh.job_blob.resize(100'000, std::byte{2});

    std::string said;
    {
        const FullDisk full{GetParam().first, GetParam().second};
        const auto saved = save_snapshot(fresh, file_);
        ASSERT_FALSE(saved.has_value());
        EXPECT_EQ(saved.error().code, ErrorCode::out_of_room);
        said = saved.error().message;
        EXPECT_GT(g_failed, 0);
    }
    EXPECT_THAT(said, testing::HasSubstr(file_));
    EXPECT_THAT(said, testing::HasSubstr("No space left on device"));
    EXPECT_TRUE(read_whole_file(file_).value() == before);
    EXPECT_EQ(folder_.file_count(), 1U);
    ASSERT_TRUE(save_snapshot(fresh, file_)) << "once there is room";
}

std::string name_of_case(const testing::TestParamInfo<std::pair<Call, int>>& tried) {
    constexpr const char* kNames[] = {"None", "Create", "Write", "Sync", "Close", "Rename"};
    return kNames[static_cast<int>(tried.param.first)] + ("After" + std::to_string(tried.param.second));
}

INSTANTIATE_TEST_SUITE_P(AtEachCall, FullDiskTest,
                         testing::Values(std::pair{Call::create, 0}, std::pair{Call::write, 0},
                                         std::pair{Call::write, 1}, std::pair{Call::write, 20},
                                         std::pair{Call::sync, 0}, std::pair{Call::close, 0},
                                         std::pair{Call::rename, 0}),
                         name_of_case);

}  // namespace
}  // namespace psicarve
