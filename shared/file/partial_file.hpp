// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>
#include <unistd.h>

#include <optional>
#include <string>
#include <utility>

namespace psicarve {

/// An open file that closes itself.
class OpenFile {
public:
    explicit OpenFile(int descriptor) noexcept : descriptor_(descriptor) {}
    ~OpenFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    OpenFile(OpenFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    OpenFile& operator=(OpenFile&&) = delete;
    int get() const noexcept { return descriptor_; }
    /// The error number, or 0. Some file systems tell of a full disk only here.
    int close() noexcept;

private:
    int descriptor_;
};

/// "./" without one.
std::string folder_of(const std::string& path);

/// A value, or the number of the error that kept it from being made.
template <typename T>
class OrErrno;

/// A file that is being written and has not got its name yet. Where the file system can, it has none at all,
/// and whatever ends the process ends the file; elsewhere it has a hidden one, which goes with this object,
/// with the signal that ends the process (`remove_partials_when_killed`), or when the next file is written in
/// that folder: a lock that dies with its process tells that nobody writes it any more.
class PartialFile {
public:
    static OrErrno<PartialFile> create(const std::string& folder, mode_t mode);
    /// With a hidden name, whatever the file system can.
    static OrErrno<PartialFile> create_hidden(const std::string& folder, mode_t mode);
    ~PartialFile();
    PartialFile(PartialFile&& other) noexcept;
    PartialFile& operator=(PartialFile&&) = delete;

    const OpenFile& file() const noexcept { return file_; }
    /// Gets its name, whether there was a file of that name or not; once. The error number, or 0. Where a
    /// file without a name must replace another it is hidden between two calls, but whole.
    int take_name(const std::string& path) noexcept;

private:
    PartialFile(std::string folder, OpenFile file, std::string hidden_path, int slot) noexcept
        : folder_(std::move(folder)),
          file_(std::move(file)),
          hidden_path_(std::move(hidden_path)),
          slot_(slot) {}
    int link_as(const std::string& path) const noexcept;
    int replace(const std::string& path) noexcept;
    void forget() noexcept;

    std::string folder_;
    OpenFile file_;
    std::string hidden_path_;  ///< empty: it has no name
    int slot_;                 ///< where a signal finds that name; -1: nowhere
};

template <typename T>
class OrErrno {
public:
    // NOLINTNEXTLINE(google-explicit-constructor): as Result
    OrErrno(T value) : value_(std::move(value)) {}
    static OrErrno failed(int error_number) { return OrErrno{error_number, 0}; }
    explicit operator bool() const noexcept { return value_.has_value(); }
    int error() const noexcept { return error_; }
    T* operator->() noexcept { return &*value_; }
    T& operator*() noexcept { return *value_; }

private:
    OrErrno(int error_number, int /*tag*/) : error_(error_number) {}
    std::optional<T> value_;
    int error_ = 0;
};

/// From now on SIGINT, SIGTERM and SIGHUP take away the hidden names of this process before they end it; for
/// programs that leave them to the system. A signal that is ignored or has a handler already is left alone.
void remove_partials_when_killed() noexcept;

}  // namespace psicarve
