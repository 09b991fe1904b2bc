// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system_calls/call_filter.hpp"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iterator>

// Makes a system call from an address of its own: the filter lets through what comes from there.
asm(R"(
    .text
    .hidden psicarve_watched_call
    .hidden psicarve_watched_call_made
    .globl psicarve_watched_call
    .globl psicarve_watched_call_made
    .type psicarve_watched_call, @function
psicarve_watched_call:
    movq %rdi, %rax
    movq %rsi, %rdi
    movq %rdx, %rsi
    movq %rcx, %rdx
    movq %r8, %r10
    movq %r9, %r8
    movq 8(%rsp), %r9
    syscall
psicarve_watched_call_made:
    ret
    .size psicarve_watched_call, . - psicarve_watched_call
)");

extern "C" {
long psicarve_watched_call(long number, long a, long b, long c, long d, long e, long f);
extern const char psicarve_watched_call_made[];
}

namespace psicarve::system_calls {
namespace {

std::atomic<Watcher> g_watcher{nullptr};

void watch_and_make(int /*signal*/, siginfo_t* /*info*/, void* context) {
    greg_t* const registers = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
    g_watcher.load()(registers[REG_RAX]);
    registers[REG_RAX] =
        psicarve_watched_call(registers[REG_RAX], registers[REG_RDI], registers[REG_RSI], registers[REG_RDX],
                              registers[REG_R10], registers[REG_R8], registers[REG_R9]);
}

bool set_filter() noexcept {
    const auto made = reinterpret_cast<std::uintptr_t>(psicarve_watched_call_made);
    constexpr std::uint32_t kAddress = offsetof(seccomp_data, instruction_pointer);
    constexpr std::uint32_t kHalf = sizeof(std::uint32_t);
    sock_filter steps[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kAddress),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(made), 0, 2),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kAddress + kHalf),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(made >> 32U), 5, 0),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        // The way out of our own handler, and the thread's end.
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_rt_sigreturn, 3, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit, 2, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit_group, 1, 0),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    const sock_fprog program{.len = static_cast<unsigned short>(std::size(steps)), .filter = steps};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

}  // namespace

bool watch_this_thread(Watcher watcher) noexcept {
    g_watcher.store(watcher);
    struct sigaction action {};
    action.sa_sigaction = watch_and_make;
    action.sa_flags = SA_SIGINFO;
    if (sigaction(SIGSYS, &action, nullptr) != 0) return false;
    sigset_t trap;
    sigemptyset(&trap);
    sigaddset(&trap, SIGSYS);
    return pthread_sigmask(SIG_UNBLOCK, &trap, nullptr) == 0 && set_filter();
}

}  // namespace psicarve::system_calls
