// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

namespace psicarve::ui::test {

/// What a file has by now; empty: nothing, or there is none.
inline std::string text_of(const std::string& path) {
    std::ifstream file{path};
    return {std::istreambuf_iterator<char>{file}, {}};
}

/// Waits for what a program of its own does. False: it has not, however slow the computer.
template <typename Condition>
bool eventually(Condition condition) {
    constexpr std::chrono::seconds kLimit{120};
    const auto end = std::chrono::steady_clock::now() + kLimit;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    return true;
}

}  // namespace psicarve::ui::test
