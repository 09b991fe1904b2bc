// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace psicarve {

/// Of the system's core: root's, or one that is another user than the one who started it.
inline constexpr const char* kSystemStateFolder = "/var/lib/psicarve";

/// Where a core keeps what is to outlast the computer's being switched off: $PSICARVE_STATE, else the folder
/// that systemd gives a service ($STATE_DIRECTORY), else kSystemStateFolder for a core of the system's, else
/// psicarve in $XDG_STATE_HOME (~/.local/state). Empty: nowhere; so it is where $PSICARVE_STATE is set but
/// empty.
std::string state_folder_of_core(bool is_of_system);

/// Where others look for it, who may be other users: $PSICARVE_STATE alone, or nowhere where that is empty;
/// else both, their own and kSystemStateFolder.
std::vector<std::string> state_folders_to_read();

/// How a core keeps its checkpoint on a disk, as its segment tells it. A path has no room there: it is known
/// by a mark, for whoever has a folder in mind.
struct CoreKeeping {
    enum class How : std::uint8_t {
        unknown = 0,  ///< no core, or it has not said
        nowhere = 1,
        kept = 2,
        refused = 3,  ///< what stands there is not to be believed: the disk has not taken the newest
    };
    How how = How::unknown;
    std::uint32_t folder_mark = 0;  ///< 0 where none is kept

    static CoreKeeping in(const std::string& folder, How how = How::kept);
    static CoreKeeping unpack(std::uint32_t word) noexcept;
    std::uint32_t pack() const noexcept;

    bool is_somewhere() const noexcept { return how == How::kept || how == How::refused; }
    /// Whether that is its folder, by its path from the root: one path, one mark; links are other paths.
    bool is_in(const std::string& folder) const;
    bool operator==(const CoreKeeping&) const = default;
};

/// Names of what a core keeps in such a folder: one set for each segment, and another, with other endings,
/// for its simulated machine: no segment's name makes the one the other.
struct StateNames {
    /// `segment_name` as Segment has it, with its slash.
    StateNames(const std::string& folder, const std::string& segment_name, bool is_simulated);

    std::string checkpoint() const { return base + (is_simulator ? ".simulated" : ".checkpoint"); }
    /// One name for each job: what replaces it never stands under its name.
    std::string job(std::uint64_t job_checksum) const;
    /// Whether it is a name that job() gives, to any job.
    bool is_job(const std::string& path) const;

    std::string base;  ///< "FOLDER/psicarve"
    bool is_simulator;
};

}  // namespace psicarve
