// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/stat.h>

#include <boost/interprocess/shared_memory_object.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "shared/base/result.hpp"

namespace psicarve {

/// The bytes of the object that are locked: open-file-description locks, which the kernel releases however
/// their holder dies.
enum class LockByte : std::int64_t {
    creator = 0,  ///< held while the object is being made, or taken away
    core = 1,     ///< held by the core as long as it serves the segment
};

/// The number of --group NAME; refused when there is no such group.
Result<gid_t> group_id(const std::string& group);

/// Whether we may use an object with these facts: it is ours, or, with --group, it is of this group, for it
/// alone (0660), and was made by its service user or a member of it; and no other user may read or write it.
Result<void> check_segment_owner(const std::string& name, const struct ::stat& facts,
                                 const std::string& group);

/// What /dev/shm has free; nothing when the system does not say.
std::optional<std::uint64_t> free_shared_memory_bytes() noexcept;

/// The shared-memory object as a file: opening, rights, locks, its name. Knows nothing of what is inside.
/// Exceptions of Boost end here.
class SegmentObject {
public:
    /// "/psicarve" from "psicarve" or "/psicarve"; refuses what is no name of a shared-memory object.
    static Result<std::string> checked_name(const std::string& name);
    /// Nothing when the name is free; refuses an object that is neither ours nor the group's.
    static Result<std::optional<SegmentObject>> open(const std::string& name, const std::string& group);
    /// The same for any object that the kernel lets us write: for orders to stop.
    static Result<std::optional<SegmentObject>> open_whosoever(const std::string& name);
    /// Nothing when another process was first.
    static Result<std::optional<SegmentObject>> create(const std::string& name, const std::string& group);
    static Result<void> unlink(const std::string& name);

    int descriptor() const noexcept { return shm_.get_mapping_handle().handle; }
    const boost::interprocess::shared_memory_object& shm() const noexcept { return shm_; }

    bool try_lock(LockByte byte) noexcept;
    void unlock(LockByte byte) noexcept;
    /// A process that opened the object apart from us holds the lock.
    bool is_locked_by_another(LockByte byte) const noexcept;

    /// The name still leads to this object.
    bool is_named(const std::string& name) const noexcept;
    /// Negative when the kernel does not say.
    std::int64_t size_bytes() const noexcept;
    Result<void> resize(const std::string& name, std::uint64_t bytes);
    /// Makes these bytes exist as memory: an error instead of a SIGBUS when /dev/shm is full.
    Result<void> reserve(const std::string& name, std::uint64_t offset, std::uint64_t bytes);

    /// Sets 0600, or 0660 and the group, whatever it was before. Refused when the object is another user's
    /// and has other rights.
    Result<void> fit_rights(const std::string& name, const std::string& group);
    /// Gives the object to that user alone (0600), when it is ours; another's stays as it is.
    Result<void> give_to_user(const std::string& name, uid_t user, gid_t group);

private:
    static Result<std::optional<SegmentObject>> open_checked(const std::string& name,
                                                             const std::optional<std::string>& group);
    explicit SegmentObject(boost::interprocess::shared_memory_object shm) noexcept : shm_(std::move(shm)) {}
    Result<void> give_to_group(const std::string& name, const std::string& group);

    boost::interprocess::shared_memory_object shm_;
};

}  // namespace psicarve
