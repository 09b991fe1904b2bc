// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hmi/machine/loose_work.hpp"
#include "hmi/program/decoding.hpp"

namespace psicarve::program {

/// The lines of a program that are looked at, read when they are wanted by a thread of its own; no caller
/// waits.
class TextWindow {
public:
    /// Null: none.
    void show(const DecodedPointer& program);
    /// These lines are seen, from 1.
    void want(std::uint64_t first, std::uint64_t count);
    /// True: other lines are there than before.
    bool poll();
    /// Null: not read yet.
    const std::string* line(std::uint64_t number) const noexcept;
    /// Why no more can be read; nothing: it can.
    const std::optional<Error>& failure() const noexcept { return failure_; }

private:
    struct Range {
        std::uint64_t first = 0;
        std::uint64_t count = 0;
    };
    using Lines = Result<std::vector<std::string>>;
    bool has(const Range& range) const noexcept;
    void read_wanted();

    DecodedPointer program_;
    Range wanted_;
    std::uint64_t first_ = 1;  ///< of lines_
    std::vector<std::string> lines_;
    std::uint64_t read_first_ = 1;  ///< of what is being read
    std::optional<Error> failure_;
    machine::LooseWork<Lines> work_;
};

}  // namespace psicarve::program
