// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace psicarve::rtcore {

/// While it lives, a fatal signal of this thread is handled on a stack of its own: the thread's may be full,
/// which is what the signal says. The handler of fatal signals runs there alone.
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
