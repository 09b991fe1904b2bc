// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hmi/gcode/approach.hpp"
#include "hmi/gcode/kept_offsets.hpp"
#include "hmi/gcode/problem.hpp"
#include "hmi/gcode/program_check.hpp"
#include "hmi/machine/loose_work.hpp"
#include "hmi/program/line_index.hpp"
#include "hmi/program/path_sketch.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::program {

/// What is to be read, and for which machine.
struct DecodeRequest {
    std::string path;
    Profile profile;
    bool skips_deleted = false;
    std::uint32_t from_line = 0;  ///< 0, 1: the first
    /// Where the machine stands [mm, degrees]; nothing: not known.
    std::optional<std::array<double, kAxisCount>> start;
    /// Whose work offsets it begins with, as `psicarve gcode run` will; empty: without any.
    std::string segment_name = {};
    bool is_simulator = false;
};

/// A program that was read to its end and judged.
struct Decoded {
    DecodeRequest request;
    gcode::FileState state;
    gcode::ProgramFacts facts;
    gcode::ProblemList problems;
    LineIndex lines;
    std::vector<SketchPoint> path;
    gcode::Approach approach;    ///< to request.from_line
    gcode::KeptOffsets offsets;  ///< that it begins with
    std::string offsets_path;    ///< their file; empty: none

    bool is_right() const noexcept { return problems.error_count() == 0; }
};
using DecodedPointer = std::shared_ptr<const Decoded>;

/// How far a reading has come, and whether it is still wanted. Any thread.
struct DecodeProgress {
    std::atomic<std::uint64_t> bytes_done{0};
    std::atomic<std::uint64_t> bytes_total{0};
    std::atomic<bool> is_cancelled{false};
};

/// The work offsets that a run would begin with now.
Result<gcode::KeptOffsets> offsets_for(const DecodeRequest& request);

/// Reads the whole program. Memory does not grow with it. ErrorCode::cancelled when it was.
Result<DecodedPointer> decode(const DecodeRequest& request, DecodeProgress& progress);

/// Reads programs on a thread of its own, one at a time, with less priority than the machine. One owner's
/// thread; neither this nor the program's end waits for a disk.
class Decoder {
public:
    using Decode = std::function<Result<DecodedPointer>(const DecodeRequest&, DecodeProgress&)>;

    explicit Decoder(Decode decode = program::decode) : decode_(std::move(decode)) {}
    ~Decoder() { cancel(); }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;

    /// What is being read is given up.
    void begin(const DecodeRequest& request);
    void cancel() noexcept;
    bool is_under_way() const noexcept { return work_.is_under_way(); }
    const std::string& path() const noexcept { return path_; }
    /// From 0 to 1.
    double progress_ratio() const noexcept;
    /// The outcome, once.
    std::optional<Result<DecodedPointer>> take() { return work_.take(); }

private:
    Decode decode_;
    std::string path_;
    std::shared_ptr<DecodeProgress> progress_;
    machine::LooseWork<Result<DecodedPointer>> work_;
};

}  // namespace psicarve::program
