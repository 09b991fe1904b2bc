// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "hmi/offsets/offsets_place.hpp"
#include "shared/base/result.hpp"
#include "shared/file/partial_file.hpp"

namespace psicarve::offsets {

/// The right to read offsets, change them and write them, for one process at a time: a run of a program has
/// it as long as it lasts. Ends with the process, however it ends.
class OffsetsLock {
public:
    /// Makes the folder where there is none. machine_refused: another process has it and keeps it.
    static Result<OffsetsLock> take(const OffsetsPlace& place, std::chrono::milliseconds limit);

private:
    explicit OffsetsLock(OpenFile file) noexcept : file_(std::move(file)) {}

    OpenFile file_;
};

}  // namespace psicarve::offsets
