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
