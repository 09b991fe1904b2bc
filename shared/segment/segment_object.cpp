// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/segment_object.hpp"

#include <fcntl.h>
#include <grp.h>
#include <pwd.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/interprocess/exceptions.hpp>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

namespace psicarve {
namespace {

namespace bip = boost::interprocess;

constexpr std::size_t kLongestName = 200;
constexpr mode_t kOwnerMode = 0600;
constexpr mode_t kGroupMode = 0660;
constexpr std::uint64_t kBytesPerMb = 1'000'000;

std::string error_text_of(int error_number) {
    return std::generic_category().message(error_number);
}

Error object_error(const std::string& name, const std::string& what, int error_number) {
    return bad_input("segment " + name + ": " + what + ": " + error_text_of(error_number));
}

struct flock lock_request(LockByte byte, short type) noexcept {
    struct flock request {};
    request.l_type = type;
    request.l_whence = SEEK_SET;
    request.l_start = static_cast<off_t>(byte);
    request.l_len = 1;
    return request;
}

std::string user_name(uid_t user) {
    const passwd* const entry = ::getpwuid(user);
    return (entry != nullptr ? "user " + std::string{entry->pw_name} : "a user") + " (uid " +
           std::to_string(user) + ")";
}

/// The service user of a group is the user that bears the group's name.
std::optional<uid_t> service_user(const std::string& group) {
    const passwd* const entry = ::getpwnam(group.c_str());
    if (entry == nullptr) return std::nullopt;
    return entry->pw_uid;
}

/// By the user's main group or a supplementary one.
bool is_member(uid_t user, gid_t group) {
    const passwd* const entry = ::getpwuid(user);
    if (entry == nullptr) return false;
    if (entry->pw_gid == group) return true;
    const std::string name = entry->pw_name;
    const ::group* const members = ::getgrgid(group);
    if (members == nullptr) return false;
    for (char** member = members->gr_mem; *member != nullptr; ++member) {
        if (name == *member) return true;
    }
    return false;
}

std::string mode_text(mode_t mode) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "%04o", static_cast<unsigned>(mode & 07777));
    return text.data();
}

std::string free_room() {
    const auto free_bytes = free_shared_memory_bytes();
    return free_bytes ? std::to_string(*free_bytes / kBytesPerMb) + " MB free, " : "";
}

Error no_room(const std::string& name, std::uint64_t bytes) {
    return Error{ErrorCode::out_of_room,
                 "segment " + name + ": /dev/shm is full (" + free_room() +
                     std::to_string(bytes / kBytesPerMb + 1) +
                     " MB wanted): remove what nobody uses there, or enlarge it: mount -o remount,size=1G "
                     "/dev/shm"};
}

/// Whether another user's object is one that this group shares.
Result<void> check_group(const std::string& name, const struct stat& facts, const std::string& group) {
    const Result<gid_t> wanted = group_id(group);
    if (!wanted) return wanted.error();
    if (*wanted != facts.st_gid) {
        return bad_input("segment " + name + ": belongs to " + user_name(facts.st_uid) +
                         " and is not of group " + group +
                         ": choose another name with --segment, or let its owner remove it");
    }
    if (service_user(group) != std::optional{facts.st_uid} && !is_member(facts.st_uid, *wanted)) {
        return bad_input("segment " + name + ": belongs to " + user_name(facts.st_uid) +
                         ", who is no member of group " + group + ": choose another name with --segment");
    }
    if ((facts.st_mode & 0777) == kGroupMode) return {};
    return bad_input("segment " + name + ": has mode " + mode_text(facts.st_mode) + ", not 0660: let " +
                     user_name(facts.st_uid) + " start the core with --group " + group);
}

}  // namespace

Result<gid_t> group_id(const std::string& group) {
    const ::group* const entry = ::getgrnam(group.c_str());
    if (entry == nullptr) return Error{ErrorCode::bad_usage, "--group " + group + ": there is no such group"};
    return entry->gr_gid;
}

std::optional<std::uint64_t> free_shared_memory_bytes() noexcept {
    struct statvfs facts {};
    if (::statvfs("/dev/shm", &facts) != 0) return std::nullopt;
    return std::uint64_t{facts.f_bavail} * facts.f_frsize;
}

Result<void> check_segment_owner(const std::string& name, const struct stat& facts,
                                 const std::string& group) {
    if (!S_ISREG(facts.st_mode)) return bad_input("segment " + name + ": is no shared-memory object");
    const bool is_own = facts.st_uid == ::geteuid();
    if (!is_own && group.empty()) {
        return bad_input("segment " + name + ": belongs to " + user_name(facts.st_uid) +
                         ", not to us: choose another name with --segment, or share it with --group");
    }
    if ((facts.st_mode & (S_IROTH | S_IWOTH)) != 0) {
        return bad_input("segment " + name + ": every user may read or write it: close it with chmod 600 " +
                         "/dev/shm" + name + ", or choose another name with --segment");
    }
    return is_own ? Result<void>{} : check_group(name, facts, group);
}

Result<std::string> SegmentObject::checked_name(const std::string& name) {
    const std::string bare = !name.empty() && name.front() == '/' ? name.substr(1) : name;
    const bool has_good_characters = std::all_of(bare.begin(), bare.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_' || c == '.';
    });
    if (bare.empty() || bare.front() == '.' || bare.size() > kLongestName || !has_good_characters) {
        return Error{ErrorCode::bad_usage, "--segment " + name +
                                               ": a segment's name is made of letters, digits, '-', '_' and "
                                               "'.', at most 200 of them, as in /psicarve"};
    }
    return "/" + bare;
}

Result<std::optional<SegmentObject>> SegmentObject::open(const std::string& name, const std::string& group) {
    if (!group.empty()) {
        if (const auto known = group_id(group); !known) return known.error();
    }
    return open_checked(name, group);
}

Result<std::optional<SegmentObject>> SegmentObject::open_whosoever(const std::string& name) {
    return open_checked(name, std::nullopt);
}

Result<std::optional<SegmentObject>> SegmentObject::open_checked(const std::string& name,
                                                                 const std::optional<std::string>& group) {
    try {
        SegmentObject object{bip::shared_memory_object{bip::open_only, name.c_str(), bip::read_write}};
        struct stat facts {};
        if (::fstat(object.descriptor(), &facts) != 0) return object_error(name, "cannot look at it", errno);
        if (!S_ISREG(facts.st_mode)) return bad_input("segment " + name + ": is no shared-memory object");
        if (group) {
            if (auto owner = check_segment_owner(name, facts, *group); !owner) return owner.error();
        }
        return std::optional{std::move(object)};
    } catch (const bip::interprocess_exception& failure) {
        const int cause = failure.get_native_error();
        if (cause == ENOENT) return std::optional<SegmentObject>{};
        if (cause != EACCES) return object_error(name, "cannot be opened", cause);
        return bad_input("segment " + name +
                         ": belongs to another user: choose another name with --segment, or let that user "
                         "share it with --group");
    }
}

Result<std::optional<SegmentObject>> SegmentObject::create(const std::string& name,
                                                           const std::string& group) {
    try {
        SegmentObject object{bip::shared_memory_object{bip::create_only, name.c_str(), bip::read_write,
                                                       bip::permissions{0600}}};
        if (!group.empty()) {
            if (auto given = object.give_to_group(name, group); !given) {
                ::shm_unlink(name.c_str());
                return given.error();
            }
        }
        return std::optional{std::move(object)};
    } catch (const bip::interprocess_exception& failure) {
        const int cause = failure.get_native_error();
        if (cause == EEXIST) return std::optional<SegmentObject>{};
        if (cause == ENOSPC) return no_room(name, 0);
        return object_error(name, "cannot be made", cause);
    }
}

Result<void> SegmentObject::give_to_group(const std::string& name, const std::string& group) {
    const Result<gid_t> id = group_id(group);
    if (!id) return id.error();
    // First the group, then its rights: at no instant may a wrong group use it.
    if (::fchown(descriptor(), static_cast<uid_t>(-1), *id) != 0 || ::fchmod(descriptor(), kGroupMode) != 0) {
        return object_error(name, "cannot be given to group " + group, errno);
    }
    return {};
}

Result<void> SegmentObject::give_to_user(const std::string& name, uid_t user, gid_t group) {
    struct stat facts {};
    if (::fstat(descriptor(), &facts) != 0) return object_error(name, "cannot look at it", errno);
    if (facts.st_uid != ::geteuid() || facts.st_nlink != 1) return {};
    // First the rights of others: at no instant may the user's group have more than it should.
    if (::fchmod(descriptor(), kOwnerMode) == 0 && ::fchown(descriptor(), user, group) == 0) return {};
    return object_error(name, "cannot be given to another user", errno);
}

Result<void> SegmentObject::fit_rights(const std::string& name, const std::string& group) {
    struct stat facts {};
    if (::fstat(descriptor(), &facts) != 0) return object_error(name, "cannot look at it", errno);
    const mode_t mode = facts.st_mode & 0777;
    if (facts.st_uid != ::geteuid()) return check_segment_owner(name, facts, group);
    if (!group.empty()) {
        const Result<gid_t> wanted = group_id(group);
        if (!wanted) return wanted.error();
        return mode == kGroupMode && facts.st_gid == *wanted ? Result<void>{} : give_to_group(name, group);
    }
    if (mode == kOwnerMode || ::fchmod(descriptor(), kOwnerMode) == 0) return {};
    return object_error(name, "cannot be kept from others", errno);
}

Result<void> SegmentObject::unlink(const std::string& name) {
    if (::shm_unlink(name.c_str()) != 0 && errno != ENOENT)
        return object_error(name, "cannot be removed", errno);
    return {};
}

bool SegmentObject::try_lock(LockByte byte) noexcept {
    struct flock request = lock_request(byte, F_WRLCK);
    return ::fcntl(descriptor(), F_OFD_SETLK, &request) == 0;
}

void SegmentObject::unlock(LockByte byte) noexcept {
    struct flock request = lock_request(byte, F_UNLCK);
    ::fcntl(descriptor(), F_OFD_SETLK, &request);
}

bool SegmentObject::is_locked_by_another(LockByte byte) const noexcept {
    struct flock request = lock_request(byte, F_WRLCK);
    return ::fcntl(descriptor(), F_OFD_GETLK, &request) == 0 && request.l_type != F_UNLCK;
}

bool SegmentObject::is_named(const std::string& name) const noexcept {
    struct stat ours {};
    struct stat named {};
    if (::fstat(descriptor(), &ours) != 0 || ours.st_nlink == 0) return false;
    const int file = ::shm_open(name.c_str(), O_RDONLY, 0);
    if (file < 0) return false;
    const bool is_known = ::fstat(file, &named) == 0;
    ::close(file);
    return is_known && ours.st_dev == named.st_dev && ours.st_ino == named.st_ino;
}

std::int64_t SegmentObject::size_bytes() const noexcept {
    struct stat facts {};
    return ::fstat(descriptor(), &facts) == 0 ? facts.st_size : -1;
}

Result<void> SegmentObject::resize(const std::string& name, std::uint64_t bytes) {
    try {
        shm_.truncate(static_cast<bip::offset_t>(bytes));
        return {};
    } catch (const bip::interprocess_exception& failure) {
        return object_error(name, "cannot be given its size", failure.get_native_error());
    }
}

Result<void> SegmentObject::reserve(const std::string& name, std::uint64_t offset, std::uint64_t bytes) {
    int failed = EINTR;
    while (failed == EINTR) {
        failed = ::posix_fallocate(descriptor(), static_cast<off_t>(offset), static_cast<off_t>(bytes));
    }
    if (failed == ENOSPC) return no_room(name, bytes);
    if (failed != 0) return object_error(name, "cannot be given memory", failed);
    return {};
}

}  // namespace psicarve
