// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/gl_trial.hpp"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace psicarve::ui {

GlTrial::GlTrial(const std::string& folder) : path_(folder.empty() ? "" : folder + "/opengl-is-tried") {}

bool GlTrial::has_crashed_before() const {
    long pid = 0;
    if (path_.empty() || !(std::ifstream{path_} >> pid)) return false;
    return pid > 0 && ::kill(static_cast<pid_t>(pid), 0) != 0 && errno == ESRCH;
}

void GlTrial::begin() const {
    if (path_.empty()) return;
    std::error_code ignored;
    std::filesystem::create_directories(std::filesystem::path{path_}.parent_path(), ignored);
    std::ofstream{path_} << ::getpid() << '\n';
}

void GlTrial::end() const {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove(path_, ignored);
}

}  // namespace psicarve::ui
