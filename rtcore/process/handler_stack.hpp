// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace psicarve::rtcore {

/// While it lives, the handler of fatal signals runs on a stack of its own for this thread: the thread's own
/// stack may be full, and that may be the fault. Nothing else runs on that stack.
class HandlerStack {
public:
    HandlerStack();
    ~HandlerStack();
    HandlerStack(const HandlerStack&) = delete;
    HandlerStack& operator=(const HandlerStack&) = delete;

private:
    std::vector<std::byte> memory_;
};

}  // namespace psicarve::rtcore
