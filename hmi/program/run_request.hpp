// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hmi/gcode/kept_offsets.hpp"
#include "hmi/gcode/line_source.hpp"

namespace psicarve::program {

/// How the operator wants a program to run.
struct RunSwitches {
    bool is_single = false;          ///< holds behind each block
    bool stops_at_optional = false;  ///< holds at M1
    bool skips_deleted = false;      ///< leaves out blocks that begin with /
    bool is_dry = false;             ///< spindle off, heads outside the blank
    std::uint32_t from_line = 1;
    bool operator==(const RunSwitches&) const = default;
};

/// By its name: *.ngc, *.nc, *.gcode, *.tap, *.cnc.
bool is_program_file(const std::string& path);

/// A program, and the machine that is to run it.
struct RunRequest {
    std::string file;  ///< an absolute path
    RunSwitches switches;
    std::string segment_name;
    std::string group;         ///< empty: none
    std::string profile_path;  ///< of the core's profile
    std::optional<gcode::FileState> state =
        {};  ///< that it was judged in; nothing: the process that runs it judges it
    bool is_simulator = false;
    bool is_typed = false;                           ///< a block of the MDI line
    std::optional<gcode::KeptOffsets> offsets = {};  ///< that it was judged with; nothing: as with `state`
};

/// What `psicarve` is started with, its own path first.
std::vector<std::string> arguments_of(const std::string& psicarve, const RunRequest& request);

}  // namespace psicarve::program
