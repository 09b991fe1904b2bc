// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace psicarve {

/// For the core of the system: root's, or one that runs as another user than the one who started it.
inline constexpr const char* kSystemStateFolder = "/var/lib/psicarve";

/// The folder in which a core keeps what outlasts the computer's being switched off: $PSICARVE_STATE, else
/// the folder that systemd gives a service ($STATE_DIRECTORY), else kSystemStateFolder for a core of the
/// system, else psicarve in $XDG_STATE_HOME (~/.local/state). Empty: the core keeps nothing; so it is where
/// $PSICARVE_STATE is set but empty.
std::string state_folder_of_core(bool is_of_system);

/// The folders in which other processes, perhaps of other users, look for it: $PSICARVE_STATE alone, or none
/// where that is empty; else both, their own and kSystemStateFolder.
std::vector<std::string> state_folders_to_read();

/// The folder in which the operator's programs keep a machine's work offsets.
struct OffsetsFolder {
    std::string path;        ///< empty: nothing is kept
    bool is_shared = false;  ///< by all users who may write there
};
/// $PSICARVE_STATE, and none where that is empty; else offsets in kSystemStateFolder where that is there, for
/// all operators of the computer's machine; else psicarve in $XDG_STATE_HOME (~/.local/state).
OffsetsFolder offsets_folder();

/// How a core keeps its checkpoint on a disk, as its segment says. The segment has no room for a path, only
/// for a mark of it: a reader that has a folder in mind can compare.
struct CoreKeeping {
    enum class How : std::uint8_t {
        unknown = 0,  ///< no core, or it has not said
        nowhere = 1,
        kept = 2,
        refused = 3,  ///< what stands there cannot be trusted: the disk has not taken the newest
    };
    How how = How::unknown;
    std::uint32_t folder_mark = 0;  ///< 0 where none is kept

    static CoreKeeping in(const std::string& folder, How how = How::kept);
    static CoreKeeping unpack(std::uint32_t word) noexcept;
    std::uint32_t pack() const noexcept;

    bool is_somewhere() const noexcept { return how == How::kept || how == How::refused; }
    /// Whether the core keeps it in this folder, given by its path from the root. One path, one mark; a link
    /// is another path.
    bool is_in(const std::string& folder) const;
    bool operator==(const CoreKeeping&) const = default;
};

/// Names of what a core keeps in such a folder: one set for each segment, and another set, with other
/// endings, for its simulated machine: no two of these sets have a name in common, whatever the segments are
/// called.
struct StateNames {
    /// `segment_name` has its slash, as in Segment.
    StateNames(const std::string& folder, const std::string& segment_name, bool is_simulated);

    std::string checkpoint() const { return base + (is_simulator ? ".simulated" : ".checkpoint"); }
    /// Kept by the operator's programs.
    std::string offsets() const { return base + (is_simulator ? ".simulated-offsets" : ".offsets"); }
    /// One name for each job, so that a job never replaces another under its name.
    std::string job(std::uint64_t job_checksum) const;
    /// Whether job() gives this name to any job.
    bool is_job(const std::string& path) const;

    std::string base;  ///< "FOLDER/psicarve"
    bool is_simulator;
};

}  // namespace psicarve
