// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hardware/lab.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <thread>

#include "tests/places.hpp"
#include "tests/two_process/core_process.hpp"

namespace psicarve::hardware {
namespace {

/// Starts a program with its output, both kinds, in a file.
pid_t start(std::vector<std::string> words, const std::string& output) {
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    pid_t pid = -1;
    if (posix_spawnp(&pid, pointers[0], &actions, nullptr, pointers.data(), environ) != 0) pid = -1;
    posix_spawn_file_actions_destroy(&actions);
    return pid;
}

/// The folder for the guest's kernel: for all builds of the user, or for this one.
std::string kernel_folder() {
    const auto set = [](const char* name) {
        const char* const value = std::getenv(name);
        return std::string{value != nullptr ? value : ""};
    };
    const std::string home = set("HOME");
    std::string cache = set("XDG_CACHE_HOME");
    if (cache.empty() && !home.empty()) cache = home + "/.cache";
    const std::string folder = cache + "/psicarve/hardware";
    std::error_code error;
    if (!cache.empty()) std::filesystem::create_directories(folder, error);
    if (cache.empty() || error || access(folder.c_str(), W_OK) != 0) return in_build("hardware");
    return folder;
}

}  // namespace

std::string Lab::prepare(const std::string& folder, const std::vector<std::string>& files,
                         const std::string& init, const std::vector<std::string>& programs) {
    folder_ = folder;
    const std::string source = in_source("tests/hardware");
    std::vector<std::string> words{source + "/prepare.sh", kernel_folder(), folder + "/lab",
                                   source + "/" + init};
    words.insert(words.end(), files.begin(), files.end());
    words.insert(words.end(), {"--", in_build("bin/psicarve-rtcore"), in_build("bin/psicarve")});
    words.insert(words.end(), programs.begin(), programs.end());
    const std::string log = folder + "/prepare.log";
    const pid_t script = start(words, log);
    int status = -1;
    if (script < 0 || ::waitpid(script, &status, 0) != script) return "prepare.sh cannot be started";
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? std::string{} : two_process::text_of(log);
}

void Lab::boot(const fake_port::FakePortFile& port) {
    const fake_port::FakePortFile::Preload preload{port};
    qemu_ = start({"qemu-system-x86_64",
                   "-M",
                   "pc",
                   "-accel",
                   "tcg",
                   "-cpu",
                   "max",
                   "-smp",
                   "1",
                   "-m",
                   "512",
                   "-icount",
                   "shift=0,sleep=off",
                   "-nodefaults",
                   "-no-user-config",
                   "-display",
                   "none",
                   "-no-reboot",
                   "-kernel",
                   folder_ + "/lab/vmlinuz",
                   "-initrd",
                   folder_ + "/lab/initramfs",
                   "-append",
                   "console=ttyS0 quiet loglevel=3 panic=-1 tsc=reliable",
                   "-serial",
                   "stdio",
                   "-chardev",
                   "parallel,id=port,path=" + port.device(),
                   "-device",
                   "isa-parallel,chardev=port,iobase=0x378,irq=7"},
                  folder_ + "/console.log");
}

Lab::~Lab() {
    if (is_over()) return;
    ::kill(qemu_, SIGKILL);
    ::waitpid(qemu_, nullptr, 0);
}

std::string Lab::console() const {
    return two_process::text_of(folder_ + "/console.log");
}

bool Lab::is_over() {
    if (qemu_ > 0 && ::waitpid(qemu_, nullptr, WNOHANG) == qemu_) qemu_ = -1;
    return qemu_ < 0;
}

bool Lab::wait_for(const std::string& words, std::chrono::seconds limit) {
    const auto end = std::chrono::steady_clock::now() + limit;
    for (;;) {
        const bool was_over = is_over();
        if (console().find(words) != std::string::npos) return true;
        if (was_over || std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds{5});
    }
}

bool Lab::wait_for_end(std::chrono::seconds limit) {
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!is_over()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds{20});
    }
    return true;
}

}  // namespace psicarve::hardware
