// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/process/privileges.hpp"

#include <grp.h>
#include <limits.h>
#include <linux/capability.h>
#include <pwd.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <system_error>

namespace psicarve::rtcore {
namespace {

/// A set of capabilities; bit: the capability's number.
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

/// None is inherited.
bool set_capabilities(Capabilities permitted, Capabilities effective) noexcept {
    __user_cap_header_struct header{.version = _LINUX_CAPABILITY_VERSION_3, .pid = 0};
    std::array<__user_cap_data_struct, 2> words{};
    for (unsigned i = 0; i < words.size(); ++i) {
        words[i] = {.effective = static_cast<std::uint32_t>(effective >> (i * kBitsPerWord)),
                    .permitted = static_cast<std::uint32_t>(permitted >> (i * kBitsPerWord)),
                    .inheritable = 0};
    }
    return syscall(SYS_capset, &header, words.data()) == 0;
}

bool keep_only(Capabilities kept) noexcept {
    // The bounding set first: it takes a capability to make it smaller.
    for (int capability = 0; capability < kMostCapabilities; ++capability) {
        if ((kept & bit(capability)) == 0) static_cast<void>(prctl(PR_CAPBSET_DROP, capability, 0, 0, 0));
    }
    static_cast<void>(prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0));
    static_cast<void>(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0));
    return set_capabilities(kept, kept);
}

/// Lets the process have up to this much of a resource without a capability from here on.
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

Error wrong_user(const std::string& name, const std::string& why) {
    return Error{ErrorCode::bad_usage, "--user " + name + ": " + why};
}

bool is_already(const UserAccount& account) noexcept {
    uid_t users[3];
    gid_t groups[3];
    ::getresuid(&users[0], &users[1], &users[2]);
    ::getresgid(&groups[0], &groups[1], &groups[2]);
    return std::all_of(users, users + 3, [&](uid_t user) { return user == account.user; }) &&
           std::all_of(groups, groups + 3, [&](gid_t group) { return group == account.group; });
}

}  // namespace

Result<UserAccount> account_of(const std::string& name) {
    const ::passwd* const entry = ::getpwnam(name.c_str());
    if (entry == nullptr) return wrong_user(name, "there is no such user");
    if (entry->pw_uid == 0) return wrong_user(name, "the core is to go on as another user than root");
    return UserAccount{name, entry->pw_uid, entry->pw_gid};
}

Result<void> become_user(const UserAccount& account) {
    if (is_already(account)) return {};
    const Capabilities before = permitted();
    // The kernel drops the capabilities of a process that leaves root, unless PR_SET_KEEPCAPS is set.
    const bool is_user = ::initgroups(account.name.c_str(), account.group) == 0 &&
                         ::setresgid(account.group, account.group, account.group) == 0 &&
                         prctl(PR_SET_KEEPCAPS, 1, 0, 0, 0) == 0 &&
                         ::setresuid(account.user, account.user, account.user) == 0;
    if (!is_user && errno == EPERM) {
        return wrong_user(account.name,
                          "only root, with CAP_SETUID and CAP_SETGID, can start a core for another user; or "
                          "start it as " +
                              account.name);
    }
    // Otherwise fs.suid_dumpable decides what the kernel makes of it.
    if (!is_user || prctl(PR_SET_KEEPCAPS, 0, 0, 0, 0) != 0 || !set_capabilities(before, 0) ||
        prctl(PR_SET_DUMPABLE, 0, 0, 0, 0) != 0) {
        return Error{ErrorCode::machine_refused,
                     "cannot become user " + account.name + ": " + std::generic_category().message(errno)};
    }
    return {};
}

void raise_privileges() noexcept {
    const Capabilities all = permitted();
    static_cast<void>(set_capabilities(all, all));
}

bool is_in_group(gid_t group) {
    if (::getegid() == group) return true;
    const int count = getgroups(0, nullptr);
    std::vector<gid_t> groups(static_cast<std::size_t>(std::max(count, 0)));
    return getgroups(static_cast<int>(groups.size()), groups.data()) == count &&
           std::find(groups.begin(), groups.end(), group) != groups.end();
}

bool will_be_in_group(const UserAccount& account, gid_t group) {
    if (is_already(account)) return is_in_group(group);
    std::vector<gid_t> groups(1);
    int count = 1;
    while (::getgrouplist(account.name.c_str(), account.group, groups.data(), &count) < 0) {
        // Where getgrouplist does not say how many there are, try twice as many.
        count = std::max(count, 2 * static_cast<int>(groups.size()));
        if (count > NGROUPS_MAX) return false;
        groups.resize(static_cast<std::size_t>(count));
    }
    return std::find(groups.begin(), groups.begin() + count, group) != groups.begin() + count;
}

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
    // Every page that is mapped from here on counts against the limit.
    if (needed.locks_memory) {
        keep_unless(raise_limit(RLIMIT_MEMLOCK, RLIM_INFINITY), CAP_IPC_LOCK, "CAP_IPC_LOCK");
    }
    if (!keep_only(kept)) stayed.emplace_back("all");
    return stayed;
}

}  // namespace psicarve::rtcore
