// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/process/handler_stack.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>

namespace psicarve::rtcore {

HandlerStack::HandlerStack() {
    // The kernel saves a big processor's registers there, too, in addition to what the handler needs.
    constexpr std::size_t kHandlerBytes = std::size_t{32} << 10;
    memory_.resize(static_cast<std::size_t>(std::max(sysconf(_SC_MINSIGSTKSZ), 0L)) + kHandlerBytes);
    const stack_t stack{.ss_sp = memory_.data(), .ss_flags = 0, .ss_size = memory_.size()};
    sigaltstack(&stack, nullptr);
}

HandlerStack::~HandlerStack() {
    const stack_t none{.ss_sp = nullptr, .ss_flags = SS_DISABLE, .ss_size = 0};
    sigaltstack(&none, nullptr);
}

}  // namespace psicarve::rtcore
