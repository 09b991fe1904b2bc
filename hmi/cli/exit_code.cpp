// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/exit_code.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "hmi/cli/progress_bar.hpp"
#include "hmi/model/source_name.hpp"
#include "shared/base/printable.hpp"

namespace psicarve::cli {
namespace {

/// Names standard input so, wherever it is read.
std::string in_words(std::string text) {
    for (std::size_t at = text.find(model::kDescriptorFolder); at != std::string::npos;
         at = text.find(model::kDescriptorFolder, at)) {
        std::size_t end = at + model::kDescriptorFolder.size();
        while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
        text.replace(at, end - at, "standard input");
    }
    return text;
}

void print_line(const char* prefix, const std::string& text) {
    clear_progress_line();
    std::fprintf(stderr, "%s%s\n", prefix, printable(in_words(text)).c_str());
}

}  // namespace

int report_error(const Error& error, bool as_json) {
    print_error(error);
    if (as_json)
        std::printf("{\"error\":%s}\n",
                    error_json(Error{error.code, in_words(error.message), error.said}).c_str());
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

void print_question(const std::string& text) {
    clear_progress_line();
    std::fprintf(stderr, "psicarve: %s", printable(in_words(text)).c_str());
}

Result<void> flush_output() {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return {};
    return Error{ErrorCode::out_of_room, std::string{"standard output: "} + std::strerror(errno)};
}

}  // namespace psicarve::cli
