// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/computer/kernel_ports.hpp"

#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace psicarve {
namespace {

namespace fs = std::filesystem;

std::string first_word_of(const fs::path& path) {
    std::ifstream file{path};
    std::string word;
    file >> word;
    return word;
}

bool is_number(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

bool has_open(const fs::path& process, const struct stat& wanted) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(process / "fd", ignored)) {
        struct stat opened {};
        if (::stat(entry.path().c_str(), &opened) != 0) continue;
        if (opened.st_dev == wanted.st_dev && opened.st_ino == wanted.st_ino) return true;
    }
    return false;
}

}  // namespace

std::vector<KernelPort> kernel_ports(const std::string& proc) {
    std::vector<KernelPort> ports;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(proc + "/sys/dev/parport", ignored)) {
        KernelPort port;
        port.name = entry.path().filename();
        if (!port.name.starts_with("parport")) continue;
        std::ifstream{entry.path() / "base-addr"} >> port.base >> port.extended_base;
        port.holder = first_word_of(entry.path() / "devices" / "active");
        if (port.holder == "none") port.holder.clear();
        ports.push_back(port);
    }
    std::sort(ports.begin(), ports.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return ports;
}

bool is_classic_base(std::uint16_t base) noexcept {
    return std::ranges::find(kClassicBases, base) != kClassicBases.end();
}

std::string hex_of(std::uint16_t base) {
    std::array<char, 8> text{};
    (void)std::snprintf(text.data(), text.size(), "0x%x", base);
    return text.data();
}

std::string base_lock_name(const std::string& dev, std::uint16_t base) {
    const std::string name = "psicarve-port-" + hex_of(base);
    struct stat place {};
    if (dev == "/dev" || ::stat(dev.c_str(), &place) != 0) return name;
    return name + "@" + std::to_string(place.st_dev) + ":" + std::to_string(place.st_ino);
}

bool is_lp_loaded(const std::string& proc) {
    std::ifstream modules{proc + "/modules"};
    for (std::string line; std::getline(modules, line);) {
        if (line.starts_with("lp ")) return true;
    }
    return false;
}

std::string group_of(const std::string& path) {
    struct stat facts {};
    if (::stat(path.c_str(), &facts) != 0) return {};
    std::array<char, 4096> strings{};
    struct group entry {};
    struct group* found = nullptr;
    ::getgrgid_r(facts.st_gid, &entry, strings.data(), strings.size(), &found);
    return found != nullptr ? entry.gr_name : std::to_string(facts.st_gid);
}

std::string process_text(int pid) {
    const std::string number = std::to_string(pid);
    const std::string name = first_word_of("/proc/" + number + "/comm");
    return name.empty() ? "pid " + number : name + " (pid " + number + ")";
}

std::string processes_with(const std::string& path) {
    struct stat wanted {};
    if (::stat(path.c_str(), &wanted) != 0) return {};
    std::string found;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator("/proc", ignored)) {
        const std::string pid = entry.path().filename();
        if (!is_number(pid) || pid == std::to_string(::getpid()) || !has_open(entry.path(), wanted)) continue;
        found += (found.empty() ? "" : ", ") + process_text(std::stoi(pid));
    }
    return found;
}

}  // namespace psicarve
