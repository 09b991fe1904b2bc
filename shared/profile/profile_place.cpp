// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/profile/profile_place.hpp"

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace psicarve {
namespace {

std::string variable(const char* name) {
    const char* value =
        std::getenv(name);  // NOLINT(concurrency-mt-unsafe): no thread changes the environment
    return value == nullptr ? std::string{} : std::string{value};
}

}  // namespace

std::vector<std::string> profile_places() {
    if (std::getenv("PSICARVE_PROFILE") != nullptr) {  // NOLINT(concurrency-mt-unsafe)
        const std::string named = variable("PSICARVE_PROFILE");
        return named.empty() ? std::vector<std::string>{} : std::vector<std::string>{named};
    }
    std::vector<std::string> places;
    // The XDG base directory specification says to ignore a path that is not absolute.
    const std::string config = variable("XDG_CONFIG_HOME");
    const std::string home = variable("HOME");
    if (config.starts_with("/")) {
        places.push_back(config + "/psicarve/machine.toml");
    } else if (home.starts_with("/")) {
        places.push_back(home + "/.config/psicarve/machine.toml");
    }
    places.emplace_back("/etc/psicarve/machine.toml");
    return places;
}

std::string default_profile_path() {
    // A named profile that does not exist is a mistake; reading it reports that.
    if (!variable("PSICARVE_PROFILE").empty()) return variable("PSICARVE_PROFILE");
    for (const std::string& place : profile_places()) {
        std::error_code error;
        const auto status = std::filesystem::symlink_status(place, error);
        // A file that cannot be examined (in a folder without access) counts: reading it reports that.
        if (status.type() != std::filesystem::file_type::not_found) return place;
    }
    return {};
}

}  // namespace psicarve
