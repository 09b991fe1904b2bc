// SPDX-License-Identifier: GPL-3.0-or-later
// Tells which code of the product a process has reached; scripts/asan_cover.py links it into programs that
// are compiled with -fsanitize-coverage=trace-pc-guard. Where PSICARVE_REACHED names a folder, each process
// has a file PROGRAM.PID there: for each of its blocks zero, or the address behind the first call from it, in
// bytes from the program's begin. The file is mapped, so that a process that is killed has told, too.
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" const char __ehdr_start;  // by the linker: where the program begins

namespace {

std::uint64_t* g_told = nullptr;

bool open_told(std::size_t blocks) {
    const char* const folder = std::getenv("PSICARVE_REACHED");
    char program[512] = "";
    if (folder == nullptr || readlink("/proc/self/exe", program, sizeof program - 1) <= 0) return false;
    char path[1024];
    std::snprintf(path, sizeof path, "%s/%s.%d", folder, std::strrchr(program, '/') + 1, int(getpid()));
    const int file = open(path, O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (file < 0) return false;
    const std::size_t size = blocks * sizeof(std::uint64_t);
    void* at = MAP_FAILED;
    if (ftruncate(file, static_cast<off_t>(size)) == 0)
        at = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    close(file);
    if (at == MAP_FAILED) return false;
    g_told = static_cast<std::uint64_t*>(at);
    return true;
}

}  // namespace

// Names of the compiler's.
extern "C" {

void __sanitizer_cov_trace_pc_guard_init(std::uint32_t* begin, std::uint32_t* end) {
    if (begin == end || g_told != nullptr) return;
    const auto blocks = static_cast<std::size_t>(end - begin);
    if (!open_told(blocks + 1)) return;
    for (std::uint32_t i = 0; i < blocks; ++i) begin[i] = i + 1;
}

void __sanitizer_cov_trace_pc_guard(std::uint32_t* block) {
    const std::uint32_t number = *block;
    if (number == 0) return;  // told, or nobody asks
    g_told[number] =
        static_cast<std::uint64_t>(static_cast<const char*>(__builtin_return_address(0)) - &__ehdr_start);
    *block = 0;
}

}  // extern "C"
