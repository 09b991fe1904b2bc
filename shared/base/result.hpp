// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <variant>

#include "shared/message/message.hpp"

namespace psicarve {

/// Why something failed. Programs map these to the exit codes of the command line.
enum class ErrorCode {
    bad_usage,         ///< the caller asked for something that makes no sense (exit code 2)
    bad_input,         ///< a file, job or profile is wrong; nothing was changed (exit code 3)
    machine_refused,   ///< the core refused a command or raised an alarm (exit code 4)
    no_core,           ///< no core or no segment to talk to (exit code 5)
    difference_found,  ///< verification found a difference (exit code 6)
    out_of_room,       ///< memory, /dev/shm or a disk is full (exit code 3)
    timed_out,         ///< a wait with a time limit ended without what it waited for (exit code 5)
    cancelled,         ///< the user asked to end the work (exit code 4)
};

/// One clear line for a person: what is wrong, where, and what to do about it.
struct Error {
    ErrorCode code = ErrorCode::bad_input;
    std::string message;
    Message said{};  ///< the same as data, where it is (error_from in shared/wording)
};

/// Either a value or the error that kept it from being made. Not for the tick (its errors own strings).
template <typename T>
class [[nodiscard]] Result {
public:
    // NOLINTNEXTLINE(google-explicit-constructor): `return value;` and `return error;` are the point
    Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
    // NOLINTNEXTLINE(google-explicit-constructor)
    Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

    bool has_value() const noexcept { return content_.index() == 0; }
    explicit operator bool() const noexcept { return has_value(); }

    T& value() & { return std::get<0>(content_); }
    const T& value() const& { return std::get<0>(content_); }
    T&& value() && { return std::get<0>(std::move(content_)); }
    T* operator->() { return &std::get<0>(content_); }
    const T* operator->() const { return &std::get<0>(content_); }
    T& operator*() & { return std::get<0>(content_); }
    const T& operator*() const& { return std::get<0>(content_); }

    const Error& error() const { return std::get<1>(content_); }

private:
    std::variant<T, Error> content_;
};

/// Success without a value, or an error.
template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : failed_(true), error_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

    bool has_value() const noexcept { return !failed_; }
    explicit operator bool() const noexcept { return has_value(); }
    const Error& error() const { return error_; }

private:
    bool failed_ = false;
    Error error_;
};

inline Error bad_input(std::string message) {
    return Error{ErrorCode::bad_input, std::move(message)};
}

}  // namespace psicarve
