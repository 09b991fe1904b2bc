// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/window_options.hpp"

#include <utility>

#include "hmi/manual/window_table.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::ui {
namespace {

constexpr int kExitDone = 0;
constexpr int kExitUsage = 2;

WindowOptions ended(int exit_code, std::string text) {
    WindowOptions options;
    options.exit_code = exit_code;
    options.text = std::move(text);
    return options;
}

WindowOptions misused(const std::string& what) {
    return ended(kExitUsage, "psicarve-hmi: " + what + "; see psicarve-hmi --help\n");
}

/// Where the value of an option goes; null: no such option. What --help does not tell of is none.
std::string* target_of(const std::string& name, WindowOptions& options) {
    if (manual::window_option(name) == nullptr) return nullptr;
    if (name == "--segment") return &options.segment_name;
    if (name == "--profile") return &options.profile_path;
    if (name == "--group") return &options.group;
    if (name == "--state") return &options.state_folder;
    if (name == "--language") return &options.language;
    return nullptr;
}

/// As the command line has it.
bool is_segment_name(const std::string& name) {
    constexpr std::size_t kMost = 200;
    return name.size() >= 2 && name.size() <= kMost && name.front() == '/' &&
           name.find('/', 1) == std::string::npos;
}

}  // namespace

WindowOptions parse_window_options(const std::vector<std::string>& arguments) {
    WindowOptions options;
    options.segment_name = kDefaultSegmentName;
    bool only_files = false;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& word = arguments[i];
        if (!only_files && word == "--") {
            only_files = true;
        } else if (!only_files && (word == "--help" || word == "-h")) {
            return ended(kExitDone, manual::window_help());
        } else if (!only_files && word == "--version") {
            return ended(kExitDone, "psicarve-hmi " PSICARVE_VERSION "\n");
        } else if (!only_files && (word == "--opengl" || word == "--no-opengl")) {
            options.opengl = word == "--opengl" ? OpenGl::always : OpenGl::never;
        } else if (!only_files && word.size() > 1 && word.front() == '-') {
            const std::size_t equals = word.find('=');
            const std::string name = word.substr(0, equals);
            std::string* const target = target_of(name, options);
            if (target == nullptr) return misused("unknown option '" + name + "'");
            const bool has_next = equals != std::string::npos || ++i < arguments.size();
            if (has_next) *target = equals != std::string::npos ? word.substr(equals + 1) : arguments[i];
            if (!has_next || target->empty()) return misused(name + " wants a value");
        } else if (word.empty()) {
            return misused("an empty file name");
        } else if (options.path.empty()) {
            options.path = word;
        } else {
            return misused("one file at a time: '" + options.path + "' and '" + word + "'");
        }
    }
    if (!is_segment_name(options.segment_name))
        return misused("--segment: a segment's name begins with / and has no other, as in /psicarve");
    if (!options.language.empty() && !language_of(QString::fromStdString(options.language)))
        return misused("--language: there are en, zh_CN and ru, not '" + options.language + "'");
    return options;
}

}  // namespace psicarve::ui
