// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "hmi/cam/job_builder.hpp"
#include "hmi/cam/prepared_job.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::session {

/// A job in the desk's form: with the least times that its machine allows.
std::shared_ptr<const cam::PreparedJob> with_least_times(cam::PreparedJob&& job);
/// The same from a file, checked.
Result<std::shared_ptr<const cam::PreparedJob>> read_job(const std::string& path);
Result<std::shared_ptr<const cam::PreparedJob>> prepared(cam::BuiltJob built, const Profile& profile,
                                                         const std::string& source);

}  // namespace psicarve::session
