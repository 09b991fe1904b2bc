// SPDX-License-Identifier: GPL-3.0-or-later
// Preloaded into a program (our core, or QEMU with its guest's port on it), makes one file answer like
// /dev/parportN. See fake_port.hpp.
#include <dlfcn.h>
#include <fcntl.h>
#include <linux/parport.h>
#include <linux/ppdev.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "tests/fake_port/fake_port.hpp"

namespace psicarve::fake_port {
namespace {

State* g_state = nullptr;
int g_descriptor = -1;

template <typename Function>
Function* real(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}
int real_open(const char* path, int flags, mode_t mode) {
    static auto* const function = real<int(const char*, int, ...)>("open");
    return function(path, flags, mode);
}
int real_ioctl(int descriptor, unsigned long request, void* argument) {
    static auto* const function = real<int(int, unsigned long, ...)>("ioctl");
    return function(descriptor, request, argument);
}
int real_close(int descriptor) {
    static auto* const function = real<int(int)>("close");
    return function(descriptor);
}

bool is_device(const char* path) {
    const char* const device = std::getenv(kDeviceVariable);
    return path != nullptr && device != nullptr && std::strcmp(path, device) == 0;
}

bool map_state() {
    if (g_state != nullptr) return true;
    const char* const path = std::getenv(kStateVariable);
    const int file = path == nullptr ? -1 : real_open(path, O_RDWR | O_CLOEXEC, 0);
    if (file < 0) return false;
    void* const address =
        mmap(nullptr, sizeof(State), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_POPULATE, file, 0);
    real_close(file);
    if (address == MAP_FAILED) return false;
    g_state = static_cast<State*>(address);
    return true;
}

int fail(int error) {
    errno = error;
    return -1;
}

int open_device(int flags) {
    if (!map_state()) return fail(EIO);
    if (const int error = g_state->open_errno.load(); error != 0) return fail(error);
    g_descriptor = real_open(std::getenv(kDeviceVariable), flags, 0);
    return g_descriptor;
}

bool is_other_alive(std::uint32_t pid) {
    return pid != 0 && pid != static_cast<std::uint32_t>(getpid()) && kill(static_cast<pid_t>(pid), 0) == 0;
}

int claim() {
    if (const int error = g_state->claim_errno.load(); error != 0) return fail(error);
    if (is_other_alive(g_state->excluded_by.load())) return fail(ENXIO);
    g_state->claimed_by.store(static_cast<std::uint32_t>(getpid()));
    constexpr std::uint32_t kAfterClaim = 0x0c;  // as parport_pc sets the control register
    g_state->control.store(kAfterClaim);
    return 0;
}

int set_direction() {
    const int error = g_state->direction_errno.load();
    return error == 0 ? 0 : fail(error);
}

bool level(const Wire& wire, std::uint32_t data, std::uint32_t control) {
    const std::uint32_t byte = wire.reg == Register::data ? data : control;
    return ((byte >> wire.bit & 1U) != 0) != (wire.is_inverted != 0);
}

void turn_axes(std::uint32_t old_data, std::uint32_t old_control) {
    const std::uint32_t data = g_state->data.load();
    const std::uint32_t control = g_state->control.load();
    for (FakeAxis& axis : g_state->axes) {
        const bool is_edge = level(axis.step, data, control) && !level(axis.step, old_data, old_control);
        if (!is_edge || !level(axis.enable, data, control)) continue;
        axis.position_pulses.fetch_add(level(axis.dir, data, control) ? 1 : -1);
        axis.pulses.fetch_add(1);
        if (g_state->pulse_count.fetch_add(1) + 1 == g_state->flip_at_pulse.load()) {
            g_state->status_flip.store(g_state->flip_to.load());
        }
    }
}

bool is_tripped(const FakeAxis& axis) {
    const std::int64_t at = axis.position_pulses.load();
    if (axis.sensor == Sensor::none) return false;
    if (axis.sensor == Sensor::above) return at > axis.edge_pulses;
    if (axis.sensor == Sensor::below) return at < axis.edge_pulses;
    const std::int64_t past = (at - axis.edge_pulses) % axis.pulses_per_rev;
    return (past < 0 ? past + axis.pulses_per_rev : past) < axis.index_pulses;
}

std::uint8_t status() {
    std::uint32_t byte = g_state->status_flip.load();
    for (const FakeAxis& axis : g_state->axes) {
        if (is_tripped(axis) != (axis.is_status_inverted != 0)) byte ^= 1U << axis.status_bit;
    }
    if (g_state->reads.fetch_add(1) % 2 == 1) byte ^= g_state->status_chatter.load();
    return static_cast<std::uint8_t>(byte);
}

bool fails_now() {
    if (g_state->accesses_to_fault.load() < 0) return false;
    if (g_state->accesses_to_fault.load() > 0) {
        g_state->accesses_to_fault.fetch_sub(1);
        return false;
    }
    const std::int64_t left = g_state->faults.load();
    if (left > 0) g_state->faults.fetch_sub(1);
    return left != 0;
}

void write_register(Register reg, std::uint8_t value) {
    const std::uint64_t number = g_state->write_count.load();
    const std::uint32_t delay_every = g_state->delay_every.load();
    if (delay_every != 0 && number % delay_every == 0) {
        const timespec delay{.tv_sec = 0, .tv_nsec = static_cast<long>(g_state->delay_ns.load())};
        nanosleep(&delay, nullptr);
    }
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    constexpr std::uint64_t kNsPerS = 1'000'000'000;
    if (number + 1 == g_state->flip_at_write.load()) g_state->status_flip.store(g_state->flip_to.load());
    Write& entry = g_state->writes[number % kMostWrites];
    entry.time_ns =
        static_cast<std::uint64_t>(now.tv_sec) * kNsPerS + static_cast<std::uint64_t>(now.tv_nsec);
    entry.reg = reg;
    entry.value = value;
    const std::uint32_t data = g_state->data.load();
    const std::uint32_t control = g_state->control.load();
    (reg == Register::data ? g_state->data : g_state->control).store(value);
    turn_axes(data, control);
    g_state->write_count.store(number + 1);
}

int access_register(unsigned long request, std::uint8_t* byte) {
    if (g_state->claimed_by.load() == 0) return fail(EPERM);
    if (fails_now()) return fail(g_state->fault_errno.load());
    switch (request) {
        case PPWDATA:
            write_register(Register::data, *byte);
            return 0;
        case PPWCONTROL:
            write_register(Register::control, *byte);
            return 0;
        case PPRDATA:
            *byte = static_cast<std::uint8_t>(g_state->data.load());
            return 0;
        case PPRCONTROL:
            *byte = static_cast<std::uint8_t>(g_state->control.load());
            return 0;
        case PPRSTATUS:
            *byte = status();
            return 0;
        default:
            return fail(ENOTTY);
    }
}

int answer(unsigned long request, void* argument) {
    switch (request) {
        case PPEXCL:
            if (is_other_alive(g_state->claimed_by.load())) return fail(ENXIO);
            g_state->excluded_by.store(static_cast<std::uint32_t>(getpid()));
            return 0;
        case PPCLAIM:
            return claim();
        case PPRELEASE:
            g_state->claimed_by.store(0);
            return 0;
        case PPGETMODES:
            std::memcpy(argument, &g_state->modes, sizeof(std::uint32_t));
            return 0;
        case PPDATADIR:
            return set_direction();
        case PPSETMODE:
        case PPNEGOT:
            return 0;
        default:
            return access_register(request, static_cast<std::uint8_t*>(argument));
    }
}

int close_device() {
    g_descriptor = -1;
    const auto pid = static_cast<std::uint32_t>(getpid());
    if (g_state->claimed_by.load() == pid) g_state->claimed_by.store(0);
    if (g_state->excluded_by.load() == pid) g_state->excluded_by.store(0);
    return 0;
}

mode_t mode_of(int flags, va_list arguments) {
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
}

}  // namespace
}  // namespace psicarve::fake_port

namespace fake = psicarve::fake_port;

extern "C" {

int open(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = fake::mode_of(flags, arguments);
    va_end(arguments);
    return fake::is_device(path) ? fake::open_device(flags) : fake::real_open(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = fake::mode_of(flags, arguments);
    va_end(arguments);
    return fake::is_device(path) ? fake::open_device(flags)
                                 : fake::real_open(path, flags | O_LARGEFILE, mode);
}

int __open_2(const char* path, int flags) {
    return open(path, flags);
}

int __open64_2(const char* path, int flags) {
    return open64(path, flags);
}

int ioctl(int descriptor, unsigned long request, ...) noexcept {
    va_list arguments;
    va_start(arguments, request);
    void* const argument = va_arg(arguments, void*);
    va_end(arguments);
    if (descriptor < 0 || descriptor != fake::g_descriptor) {
        return fake::real_ioctl(descriptor, request, argument);
    }
    return fake::answer(request, argument);
}

int close(int descriptor) {
    if (descriptor >= 0 && descriptor == fake::g_descriptor) fake::close_device();
    return fake::real_close(descriptor);
}

}  // extern "C"
