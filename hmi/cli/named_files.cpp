// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/named_files.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "hmi/cli/command_set.hpp"
#include "hmi/model/source_name.hpp"
#include "hmi/offsets/offsets_file.hpp"
#include "shared/profile/profile_place.hpp"

namespace psicarve::cli {
namespace {

constexpr std::array<std::string_view, 7> kWritten{"--output", "--trace",     "--picture", "--preview",
                                                   "--piece",  "--deviation", "--csv"};
constexpr std::array<std::string_view, 13> kRead{"--profile", "--offsets", "--model", "MODEL", "MODEL|JOB",
                                                 "JOB|TRACE", "JOB_A",     "JOB_B",   "FILE",  "--program",
                                                 "A",         "B",         "TRACE"};

template <typename Names>
bool is_among(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void add_files_of(const CLI::App& app, std::vector<NamedFile>& files) {
    const std::string standard_input = std::string{model::kDescriptorFolder} + "0";
    for (const CLI::Option* option : app.get_options()) {
        const std::string name = option->get_name();
        // `snapshot save FILE` makes the file that it names.
        const bool is_saved = app.get_name() == "save" && name == "FILE";
        const bool is_written = is_saved || is_among(kWritten, name);
        if (!is_written && !is_among(kRead, name)) continue;
        // Standard input may be a file.
        const bool may_be_standard = reads_standard_input(*option);
        for (const std::string& path : option->results()) {
            files.push_back({name, may_be_standard && path == "-" ? standard_input : path, is_written});
            if (app.get_name() == "run" && name == "--trace")
                files.push_back({"--trace (its offsets)", offsets::path_beside_trace(path), true});
        }
    }
}

}  // namespace

Result<void> check_no_stream(const std::vector<NamedFile>& files) {
    for (const NamedFile& file : files) {
        if (file.path != "-") continue;
        // slice's, and that of snapshot save.
        if (file.is_written && (file.name == "--output" || file.name == "FILE")) continue;
        return Error{ErrorCode::bad_usage,
                     file.name + " -: a file's name is meant; standard " +
                         (file.is_written ? "output takes none of it" : "input is not read for it")};
    }
    return {};
}

std::vector<NamedFile> named_files(const CLI::App& command) {
    std::vector<NamedFile> files;
    for (const CLI::App* app = &command; app != nullptr; app = app->get_parent()) add_files_of(*app, files);
    const auto is_profile = [](const NamedFile& file) { return file.name == "--profile"; };
    if (std::none_of(files.begin(), files.end(), is_profile))
        files.push_back({"profile", default_profile_path(), false});
    return files;
}

}  // namespace psicarve::cli
