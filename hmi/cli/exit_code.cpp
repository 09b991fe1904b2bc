// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/exit_code.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

#include "hmi/cli/progress_bar.hpp"

namespace psicarve::cli {
namespace {

constexpr int kExitNoCore = 5;

const char* name_of(ErrorCode code) noexcept {
    switch (code) {
        case ErrorCode::bad_usage:
            return "bad_usage";
        case ErrorCode::bad_input:
            return "bad_input";
        case ErrorCode::machine_refused:
            return "machine_refused";
        case ErrorCode::no_core:
            return "no_core";
        case ErrorCode::difference_found:
            return "difference_found";
        case ErrorCode::out_of_room:
            return "out_of_room";
        case ErrorCode::timed_out:
            return "timed_out";
        case ErrorCode::cancelled:
            return "cancelled";
    }
    return "unknown";
}

void print_line(const char* prefix, const std::string& text) {
    clear_progress_line();
    std::fprintf(stderr, "%s%s\n", prefix, text.c_str());
}

}  // namespace

int exit_code_of(ErrorCode code) noexcept {
    switch (code) {
        case ErrorCode::bad_usage:
            return kExitUsage;
        case ErrorCode::bad_input:
        case ErrorCode::out_of_room:
            return kExitBadInput;
        case ErrorCode::machine_refused:
        case ErrorCode::cancelled:
            return kExitMachine;
        case ErrorCode::no_core:
        case ErrorCode::timed_out:
            return kExitNoCore;
        case ErrorCode::difference_found:
            return kExitDifference;
    }
    return kExitUsage;
}

std::string error_json(const Error& error) {
    return error_json(error, exit_code_of(error.code));
}

std::string error_json(const Error& error, int exit_code) {
    // Messages quote file names, which need not be UTF-8: replace what is not, rather than throw.
    return nlohmann::ordered_json{
        {"code", name_of(error.code)}, {"exit_code", exit_code}, {"message", error.message}}
        .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

int report_error(const Error& error, bool as_json) {
    print_error(error);
    if (as_json) std::printf("{\"error\":%s}\n", error_json(error).c_str());
    return exit_code_of(error.code);
}

void print_error(const Error& error) {
    print_line("psicarve: ", error.message);
}

void print_warning(const std::string& text) {
    print_line("psicarve: warning: ", text);
}

void print_note(const std::string& text) {
    print_line("psicarve: ", text);
}

Result<void> flush_output() {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return {};
    return Error{ErrorCode::out_of_room, std::string{"standard output: "} + std::strerror(errno)};
}

}  // namespace psicarve::cli
