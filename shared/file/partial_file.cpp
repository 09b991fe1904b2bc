// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/file/partial_file.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>

namespace psicarve {
namespace {

constexpr int kNameAttempts = 100;
constexpr std::string_view kPrefix = ".psicarve-";
constexpr std::string_view kEnding = ".part";

/// Hidden names that a signal handler removes. More at a time than there are threads that write.
struct HiddenName {
    std::atomic<bool> is_taken{false};
    std::atomic<bool> is_whole{false};
    std::array<char, PATH_MAX> path{};
};
std::array<HiddenName, 16> hidden_names;
static_assert(std::atomic<bool>::is_always_lock_free);

/// -1 where there is no room.
int remember(const std::string& path) noexcept {
    if (path.size() >= PATH_MAX) return -1;
    for (std::size_t i = 0; i < hidden_names.size(); ++i) {
        if (hidden_names[i].is_taken.exchange(true)) continue;
        std::memcpy(hidden_names[i].path.data(), path.c_str(), path.size() + 1);
        hidden_names[i].is_whole = true;
        return static_cast<int>(i);
    }
    return -1;
}

void release(int slot) noexcept {
    if (slot < 0) return;
    hidden_names[static_cast<std::size_t>(slot)].is_whole = false;
    hidden_names[static_cast<std::size_t>(slot)].is_taken = false;
}

extern "C" void unlink_and_die(int number) {
    for (const HiddenName& name : hidden_names) {
        if (name.is_whole.load()) ::unlink(name.path.data());
    }
    // Delivered as soon as this returns.
    ::signal(number, SIG_DFL);
    ::raise(number);
}

/// A name that no other process and no other thread of ours uses; short, so that it fits where the real one
/// does.
std::string hidden_path_in(const std::string& folder) {
    static std::atomic<unsigned> s_counter{0};
    std::array<char, 64> name{};
    std::snprintf(name.data(), name.size(), "%s%x-%x%s", kPrefix.data(), static_cast<unsigned>(::getpid()),
                  s_counter.fetch_add(1), kEnding.data());
    return folder + name.data();
}

bool is_hidden_name(std::string_view name) noexcept {
    if (!name.starts_with(kPrefix) || !name.ends_with(kEnding)) return false;
    const std::string_view middle =
        name.substr(kPrefix.size(), name.size() - kPrefix.size() - kEnding.size());
    return !middle.empty() && middle.find_first_not_of("0123456789abcdef-") == std::string_view::npos;
}

/// The writer of a hidden file holds its lock: a lock that can be had, on a file of this user, belongs to a
/// process that has ended.
void remove_if_left(int folder, const char* name) noexcept {
    const OpenFile file{::openat(folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)};
    struct stat facts {};
    if (file.get() < 0 || ::fstat(file.get(), &facts) != 0) return;
    if (!S_ISREG(facts.st_mode) || facts.st_uid != ::geteuid()) return;
    if (::flock(file.get(), LOCK_EX | LOCK_NB) != 0) return;
    struct stat named {};
    if (::fstatat(folder, name, &named, AT_SYMLINK_NOFOLLOW) != 0) return;
    if (named.st_dev == facts.st_dev && named.st_ino == facts.st_ino) ::unlinkat(folder, name, 0);
}

void sweep(const std::string& folder) {
    const std::unique_ptr<DIR, int (*)(DIR*)> entries{::opendir(folder.c_str()), ::closedir};
    if (!entries) return;
    while (const dirent* entry = ::readdir(entries.get())) {
        if (is_hidden_name(entry->d_name)) remove_if_left(::dirfd(entries.get()), entry->d_name);
    }
}

/// Whether the lock protects the file while it is written: another process's clean-up may have been quicker
/// than the lock. Where nothing can be locked nothing is ever removed either.
bool is_held(int file) noexcept {
    if (::flock(file, LOCK_EX | LOCK_NB) != 0) return errno != EWOULDBLOCK;
    struct stat facts {};
    return ::fstat(file, &facts) == 0 && facts.st_nlink > 0;
}

}  // namespace

int OpenFile::close() noexcept {
    const int failed = ::close(descriptor_) == 0 ? 0 : errno;
    descriptor_ = -1;
    return failed;
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos) return "./";
    return path.substr(0, slash + 1);
}

OrErrno<PartialFile> PartialFile::create_hidden(const std::string& folder, mode_t mode) {
    for (int attempt = 0; attempt < kNameAttempts; ++attempt) {
        std::string path = hidden_path_in(folder);
        // Before the file exists: a signal may remove a missing name without harm.
        const int slot = remember(path);
        OpenFile file{::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode)};
        const int failed = file.get() < 0 ? errno : 0;
        if (failed == 0) {
            PartialFile part{folder, std::move(file), std::move(path), slot};
            if (is_held(part.file_.get())) return part;
            continue;
        }
        release(slot);
        // A killed process that had our pid may have left one.
        if (failed != EEXIST) return OrErrno<PartialFile>::failed(failed);
    }
    return OrErrno<PartialFile>::failed(EEXIST);
}

OrErrno<PartialFile> PartialFile::create(const std::string& folder, mode_t mode) {
    sweep(folder);
    // The file gets its name through /proc.
    if (::access("/proc/self/fd", X_OK) == 0) {
        OpenFile file{::open(folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, mode)};
        if (file.get() >= 0) {
            (void)::flock(file.get(), LOCK_EX | LOCK_NB);
            return PartialFile{folder, std::move(file), {}, -1};
        }
    }
    return create_hidden(folder, mode);
}

PartialFile::PartialFile(PartialFile&& other) noexcept
    : folder_(std::move(other.folder_)),
      file_(std::move(other.file_)),
      hidden_path_(std::exchange(other.hidden_path_, {})),
      slot_(std::exchange(other.slot_, -1)) {}

PartialFile::~PartialFile() {
    if (!hidden_path_.empty()) ::unlink(hidden_path_.c_str());
    forget();
}

void PartialFile::forget() noexcept {
    hidden_path_.clear();
    release(std::exchange(slot_, -1));
}

int PartialFile::link_as(const std::string& path) const noexcept {
    std::array<char, 64> open_file{};
    std::snprintf(open_file.data(), open_file.size(), "/proc/self/fd/%d", file_.get());
    return ::linkat(AT_FDCWD, open_file.data(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
}

int PartialFile::replace(const std::string& path) noexcept {
    if (::rename(hidden_path_.c_str(), path.c_str()) != 0) return errno;
    forget();
    return 0;
}

int PartialFile::take_name(const std::string& path) noexcept {
    // Some disks report that they are full only when a descriptor is closed: so closes another one, before
    // the file has its name. Closing the file itself would release the lock, and any process could remove the
    // hidden name.
    int failed = OpenFile{::fcntl(file_.get(), F_DUPFD_CLOEXEC, 0)}.close();
    if (failed != 0) return failed;
    if (!hidden_path_.empty()) return replace(path);
    // A file that replaces nothing gets its name in one call; linking cannot replace a file.
    failed = link_as(path);
    for (int attempt = 0; failed == EEXIST && attempt < kNameAttempts; ++attempt) {
        hidden_path_ = hidden_path_in(folder_);
        slot_ = remember(hidden_path_);
        failed = link_as(hidden_path_);
        if (failed == 0) return replace(path);
        forget();
    }
    return failed;
}

void remove_partials_when_killed() noexcept {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction now {};
        if (::sigaction(number, nullptr, &now) != 0 || now.sa_handler != SIG_DFL) continue;
        struct sigaction action {};
        action.sa_handler = unlink_and_die;
        sigfillset(&action.sa_mask);
        ::sigaction(number, &action, nullptr);
    }
}

}  // namespace psicarve
