// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "hmi/cli/commands.hpp"
#include "hmi/machine/machine_link.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::cli {

/// The profile by which a core's pulses are told in mm and degrees: the one that --profile names, or one in a
/// default place, or where none is named the one that the core was started with, which its command line
/// tells.
class KnownProfile {
public:
    /// Errors of readable_profile().
    static Result<KnownProfile> read(const CommonOptions& common);

    /// Nothing where it is not the core's. Files are read once for each core.
    std::optional<Profile> of(machine::MachineLink& link);

private:
    explicit KnownProfile(bool is_named) noexcept : is_named_(is_named) {}

    bool is_named_;
    std::optional<Profile> chosen_;
    std::optional<Profile> found_;
    std::uint64_t looked_for_hash_ = 0;
};

}  // namespace psicarve::cli
