// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/privileges.hpp"

#include <grp.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cstdint>

namespace psicarve::rtcore {
namespace {

/// By capability's number.
using Capabilities = std::uint64_t;
constexpr unsigned kBitsPerWord = 32;
constexpr int kMostCapabilities = 64;

constexpr Capabilities bit(int capability) noexcept {
    return Capabilities{1} << static_cast<unsigned>(capability);
}

Capabilities permitted() noexcept {
    __user_cap_header_struct header{.version = _LINUX_CAPABILITY_VERSION_3, .pid = 0};
    std::array<__user_cap_data_struct, 2> words{};
    if (syscall(SYS_capget, &header, words.data()) != 0) return 0;
    return words[0].permitted | Capabilities{words[1].permitted} << kBitsPerWord;
}

bool keep_only(Capabilities kept) noexcept {
    // The bounding set first: it takes a capability to make it smaller.
    for (int capability = 0; capability < kMostCapabilities; ++capability) {
        if ((kept & bit(capability)) == 0) static_cast<void>(prctl(PR_CAPBSET_DROP, capability, 0, 0, 0));
    }
    static_cast<void>(prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0));
    static_cast<void>(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0));
    __user_cap_header_struct header{.version = _LINUX_CAPABILITY_VERSION_3, .pid = 0};
    std::array<__user_cap_data_struct, 2> words{};
    for (unsigned i = 0; i < words.size(); ++i) {
        const auto word = static_cast<std::uint32_t>(kept >> (i * kBitsPerWord));
        words[i] = {.effective = word, .permitted = word, .inheritable = 0};
    }
    return syscall(SYS_capset, &header, words.data()) == 0;
}

/// Up to so much of it may be had without a capability from here on.
bool raise_limit(int resource, rlim_t least) noexcept {
    rlimit limit{};
    // The calls want the enumeration's own type in C++.
    const auto which = static_cast<__rlimit_resource>(resource);
    if (getrlimit(which, &limit) == 0 && limit.rlim_cur >= least) return true;
    const rlimit wanted{.rlim_cur = least, .rlim_max = least > limit.rlim_max ? least : limit.rlim_max};
    return setrlimit(which, &wanted) == 0;
}

void join_group(const std::string& name) {
    const ::group* const entry = name.empty() ? nullptr : ::getgrnam(name.c_str());
    if (entry == nullptr) return;
    const int count = getgroups(0, nullptr);
    if (count < 0) return;
    std::vector<gid_t> groups(static_cast<std::size_t>(count) + 1);
    if (getgroups(count, groups.data()) != count) return;
    groups.back() = entry->gr_gid;
    static_cast<void>(setgroups(groups.size(), groups.data()));
}

}  // namespace

std::vector<std::string> drop_privileges(const StillNeeded& needed) {
    const Capabilities before = permitted();
    if (before == 0) return {};
    join_group(needed.group);
    std::vector<std::string> stayed;
    Capabilities kept = 0;
    const auto keep_unless = [&](bool has_limit, int capability, const char* name) {
        if (has_limit || (before & bit(capability)) == 0) return;
        kept |= bit(capability);
        stayed.emplace_back(name);
    };
    if (needed.priority > 0) {
        keep_unless(raise_limit(RLIMIT_RTPRIO, static_cast<rlim_t>(needed.priority)), CAP_SYS_NICE,
                    "CAP_SYS_NICE");
    }
    // Every page that is mapped from here on counts against it.
    if (needed.locks_memory) {
        keep_unless(raise_limit(RLIMIT_MEMLOCK, RLIM_INFINITY), CAP_IPC_LOCK, "CAP_IPC_LOCK");
    }
    if (!keep_only(kept)) stayed.emplace_back("all");
    return stayed;
}

}  // namespace psicarve::rtcore
