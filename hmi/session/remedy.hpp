// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hmi/cam/job_builder.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/phrase/phrase.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::session {

/// A remedy for a refusal that one click applies.
struct Remedy {
    enum class Kind : std::uint8_t {
        height,        ///< of the model: `value` mm
        scale,         ///< of the model: mm for each unit of its file
        layers,        ///< at most this many
        best_axis,     ///< the one that loses least
        core_profile,  ///< slice again with the core's profile, which is known by now
    };
    Kind kind = Kind::height;
    double value = 0.0;
    bool operator==(const Remedy&) const = default;
};

/// A request that the desk refused.
struct OpenJobRefusal {
    enum class Of : std::uint8_t { slicing, publishing };
    Of of = Of::slicing;
    std::string name;  ///< of what is on the desk; `why` may begin with it
    Phrase why;
    std::vector<Remedy> remedies;
};

/// "Height 149.9 mm"
Phrase remedy_text(const Remedy& remedy);
/// For a mesh whose slicing was refused. Searches for its size where that is the cause: may take as long as a
/// search for its axis.
std::vector<Remedy> slicing_remedies(const Error& error, const model::Mesh& mesh, const Profile& profile,
                                     const cam::JobOptions& options);
/// For a job that can be sliced again.
std::vector<Remedy> publishing_remedies(const Error& error);

}  // namespace psicarve::session
