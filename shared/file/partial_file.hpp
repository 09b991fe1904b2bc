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

/// A file that is being written and has not got its name yet. Where the file system can, it has no name at
/// all, and whatever ends the process ends the file. Elsewhere it has a hidden name, which is removed by this
/// object, by the signal that ends the process (`remove_partials_when_killed`), or by the next write in that
/// folder: a lock that dies with its process shows that the file has no writer any more.
class PartialFile {
public:
    static OrErrno<PartialFile> create(const std::string& folder, mode_t mode);
    /// Uses a hidden name even where the file system needs none.
    static OrErrno<PartialFile> create_hidden(const std::string& folder, mode_t mode);
    ~PartialFile();
    PartialFile(PartialFile&& other) noexcept;
    PartialFile& operator=(PartialFile&&) = delete;

    const OpenFile& file() const noexcept { return file_; }
    /// Gives the file its name, and replaces a file of that name; once. Returns the error number, or 0. Where
    /// a file without a name must replace another it has a hidden name between two calls, but is whole.
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
    std::string hidden_path_;  ///< empty: the file has no name
    int slot_;                 ///< where a signal handler finds that name; -1: nowhere
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

/// From now on SIGINT, SIGTERM and SIGHUP remove this process's hidden files before they end it; for programs
/// that do not handle these signals. A signal that is ignored or has a handler already is left alone.
void remove_partials_when_killed() noexcept;

}  // namespace psicarve
