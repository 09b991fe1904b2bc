// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/doctor/base_holder.hpp"

#include <fcntl.h>
#include <unistd.h>

#include "shared/computer/abstract_name.hpp"
#include "shared/computer/kernel_ports.hpp"

namespace psicarve::doctor {
namespace {

constexpr const char* kUnknownHolder = "another program";

/// Whether a process has a lock on the base's bytes of the device; nothing: this user may not open it.
std::optional<bool> is_range_locked(const std::string& device, std::uint16_t base) {
    const int descriptor = ::open(device.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0) return std::nullopt;
    struct flock question {};
    question.l_type = F_WRLCK;
    question.l_whence = SEEK_SET;
    question.l_start = base;
    question.l_len = kPortRegisters;
    const bool is_answered = ::fcntl(descriptor, F_OFD_GETLK, &question) == 0;
    ::close(descriptor);
    if (!is_answered) return std::nullopt;
    return question.l_type != F_UNLCK;
}

}  // namespace

std::optional<std::string> base_holder(const std::string& dev, std::uint16_t base) {
    const auto name = AbstractName::from(base_lock_name(dev, base));
    if (const auto listener = name ? holder_of(*name) : std::nullopt)
        return listener->text.empty() ? kUnknownHolder : listener->text;
    // No core holds the name, but another program that uses the device's locks may.
    const std::string device = dev + "/port";
    if (!is_range_locked(device, base).value_or(false)) return std::nullopt;
    const std::string holders = processes_with(device);
    return holders.empty() ? kUnknownHolder : holders;
}

}  // namespace psicarve::doctor
