// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>

namespace psicarve {

/// XXH3 over a text that comes in parts, and how many bytes they were.
class TextSum {
public:
    TextSum();
    void add(std::span<const char> part);
    std::uint64_t bytes() const noexcept { return bytes_; }
    std::uint64_t value() const;

private:
    struct State;
    struct Deleter {
        void operator()(State* state) const noexcept;
    };
    std::unique_ptr<State, Deleter> state_;
    std::uint64_t bytes_ = 0;
};

}  // namespace psicarve
