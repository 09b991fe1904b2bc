// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/gl_trial.hpp"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <system_error>
#include <utility>

namespace psicarve::ui {
namespace {

using session::BackgroundQueue;

std::shared_future<bool> asked(BackgroundQueue& queue, std::function<bool()> question) {
    const auto answer = std::make_shared<std::promise<bool>>();
    queue.post([answer, question = std::move(question)]() -> BackgroundQueue::Finish {
        answer->set_value(question());
        return {};
    });
    return answer->get_future().share();
}

bool is_there(const std::shared_future<bool>& answer, std::chrono::milliseconds limit) {
    return answer.wait_for(limit) == std::future_status::ready;
}

bool names_a_program_that_is_gone(const std::string& path) {
    long pid = 0;
    if (!(std::ifstream{path} >> pid)) return false;
    return pid > 0 && ::kill(static_cast<pid_t>(pid), 0) != 0 && errno == ESRCH;
}

bool keep_own_number(const std::string& path) {
    std::error_code ignored;
    std::filesystem::create_directories(std::filesystem::path{path}.parent_path(), ignored);
    std::ofstream file{path};
    file << ::getpid() << '\n';
    file.close();
    return !file.fail();
}

}  // namespace

GlTrial::GlTrial(const std::string& folder) : path_(folder.empty() ? "" : folder + "/opengl-is-tried") {}

GlTrial::~GlTrial() {
    queue_.finish();
}

std::optional<bool> GlTrial::has_crashed_before(std::chrono::milliseconds limit) {
    if (path_.empty()) return false;
    if (!crash_.valid())
        crash_ = asked(queue_, [path = path_] { return names_a_program_that_is_gone(path); });
    return is_there(crash_, limit) ? std::optional{crash_.get()} : std::nullopt;
}

bool GlTrial::begin(std::chrono::milliseconds limit) {
    if (path_.empty()) return true;
    const auto kept = asked(queue_, [path = path_] { return keep_own_number(path); });
    if (is_there(kept, limit) && kept.get()) return true;
    end();  // whenever it comes there
    return false;
}

void GlTrial::end() {
    if (path_.empty()) return;
    queue_.post([path = path_]() -> BackgroundQueue::Finish {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
        return {};
    });
}

}  // namespace psicarve::ui
