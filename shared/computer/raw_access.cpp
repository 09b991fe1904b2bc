// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/computer/raw_access.hpp"

#include <linux/capability.h>
#include <sys/io.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace psicarve {
namespace {

constexpr const char* kUseDevice = "use --port ppdev:/dev/parport0";

bool may_use_raw_addresses() {
    __user_cap_header_struct header{.version = _LINUX_CAPABILITY_VERSION_3, .pid = 0};
    std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> words{};
    return syscall(SYS_capget, &header, words.data()) == 0 &&
           (words[CAP_TO_INDEX(CAP_SYS_RAWIO)].effective & CAP_TO_MASK(CAP_SYS_RAWIO)) != 0;
}

}  // namespace

RawRefusal raw_refusal(int error, bool has_right) {
    const bool is_refused = error == EPERM || error == EACCES;
    if (is_refused && !has_right) {
        return {"no right to addresses", std::string{"run with CAP_SYS_RAWIO, or "} + kUseDevice};
    }
    if (is_refused) {
        return {
            "this kernel lets nobody at addresses: it is locked down (Secure Boot), or this is a container",
            kUseDevice};
    }
    if (error == ENOSYS) return {"this kernel lets nobody at addresses", kUseDevice};
    return {"ioperm: " + std::generic_category().message(error), kUseDevice};
}

std::optional<RawRefusal> take_addresses(std::uint16_t base, std::uint16_t count) {
    if (ioperm(base, count, 1) == 0) return std::nullopt;
    const int error = errno;
    return raw_refusal(error, may_use_raw_addresses());
}

std::optional<RawRefusal> ask_for_addresses(std::uint16_t base, std::uint16_t count) {
    auto refusal = take_addresses(base, count);
    if (!refusal) static_cast<void>(ioperm(base, count, 0));
    return refusal;
}

}  // namespace psicarve
