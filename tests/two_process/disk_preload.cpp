// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded into a program, it stands for the disk below the folder that PSICARVE_DISK names. It writes what was
// done there, a line each with its thread, to the file that PSICARVE_DISK_LOG names. The file that
// PSICARVE_DISK_RULES names describes the disk, in words, and may change at any time: "hangs": opening a file
// there waits as long as the word stands; "lists_one": a folder fails behind its first entry;
// "takes_nothing": nothing is written or gets a name; "keeps_names": no name is removed; "keeps_contents": no
// file is emptied; "forgets_names": a folder cannot be synced.
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

template <typename Function>
Function* next_of(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

int plain_open(const char* path, int flags) {
    return static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, flags | O_CLOEXEC, 0600));
}

bool is_there(const char* path) {
    const char* const folder = std::getenv("PSICARVE_DISK");
    return folder != nullptr && path != nullptr && std::strncmp(path, folder, std::strlen(folder)) == 0;
}

bool is_file_there(int file, char* path, size_t size) {
    char link[64];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    const ssize_t length = readlink(link, path, size - 1);
    path[length > 0 ? length : 0] = '\0';
    return is_there(path);
}

bool is_rule(const char* word) {
    const char* const rules = std::getenv("PSICARVE_DISK_RULES");
    const int file = rules == nullptr ? -1 : plain_open(rules, O_RDONLY);
    if (file < 0) return false;
    char text[256] = {};
    const auto got = syscall(SYS_read, file, text, sizeof text - 1);
    syscall(SYS_close, file);
    return got > 0 && std::strstr(text, word) != nullptr;
}

void note(const char* what, const char* path) {
    const char* const log = std::getenv("PSICARVE_DISK_LOG");
    const int file = log == nullptr ? -1 : plain_open(log, O_WRONLY | O_CREAT | O_APPEND);
    if (file < 0) return;
    char line[512];
    const int length = std::snprintf(line, sizeof line, "%ld %s %s\n", syscall(SYS_gettid), what, path);
    syscall(SYS_write, file, line, length);
    syscall(SYS_close, file);
}

int refuse(int error) {
    errno = error;
    return -1;
}

int opened(const char* name, const char* path, int flags, mode_t mode) {
    while (is_there(path) && is_rule("hangs")) usleep(10'000);
    const bool writes = (flags & (O_CREAT | O_TMPFILE)) != 0;
    if (is_there(path) && writes && is_rule("takes_nothing")) return refuse(EROFS);
    return next_of<int(const char*, int, ...)>(name)(path, flags, mode);
}

mode_t mode_of(int flags, va_list arguments) {
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
}

}  // namespace

extern "C" {
dirent* readdir(DIR* folder) {
    static thread_local DIR* begun = nullptr;
    char path[512];
    if (begun == folder && is_file_there(dirfd(folder), path, sizeof path) && is_rule("lists_one")) {
        note("list", path);
        begun = nullptr;
        errno = EIO;
        return nullptr;
    }
    dirent* const entry = next_of<dirent*(DIR*)>("readdir")(folder);
    if (entry != nullptr && entry->d_name[0] != '.') begun = folder;
    return entry;
}
int open(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_of(flags, arguments);
    va_end(arguments);
    return opened("open", path, flags, mode);
}
int open64(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_of(flags, arguments);
    va_end(arguments);
    return opened("open64", path, flags, mode);
}
ssize_t write(int file, const void* bytes, size_t count) {
    char path[512];
    if (is_file_there(file, path, sizeof path)) note("write", path);
    return syscall(SYS_write, file, bytes, count);
}
int fsync(int file) {
    char path[512];
    struct stat facts {};
    if (is_file_there(file, path, sizeof path) && fstat(file, &facts) == 0) {
        const bool is_folder = S_ISDIR(facts.st_mode);
        if (is_folder && is_rule("forgets_names")) return refuse(EIO);
        note(is_folder ? "fsync-folder" : "fsync-file", path);
    }
    return next_of<int(int)>("fsync")(file);
}
int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept {
    const int done = next_of<int(int, const char*, int, const char*, int)>("linkat")(from_folder, from,
                                                                                     to_folder, to, flags);
    if (done == 0 && is_there(to)) note("name", to);
    return done;
}
int rename(const char* from, const char* to) noexcept {
    const int done = next_of<int(const char*, const char*)>("rename")(from, to);
    if (done == 0 && is_there(to)) note("name", to);
    return done;
}
int unlink(const char* path) noexcept {
    if (is_there(path) && is_rule("keeps_names")) return refuse(EROFS);
    if (is_there(path)) note("unlink", path);
    return next_of<int(const char*)>("unlink")(path);
}
int ftruncate(int file, off_t length) noexcept {
    char path[512];
    if (is_file_there(file, path, sizeof path)) {
        if (is_rule("keeps_contents")) return refuse(EROFS);
        note("truncate", path);
    }
    return next_of<int(int, off_t)>("ftruncate")(file, length);
}
}
