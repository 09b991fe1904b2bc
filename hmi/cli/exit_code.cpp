// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/exit_code.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "hmi/cli/progress_bar.hpp"
#include "shared/printable.hpp"

namespace psicarve::cli {
namespace {

void print_line(const char* prefix, const std::string& text) {
    clear_progress_line();
    std::fprintf(stderr, "%s%s\n", prefix, printable(text).c_str());
}

}  // namespace

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
