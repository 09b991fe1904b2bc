// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "hmi/cli/job_source.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"

namespace psicarve::cli {

/// --model: the file that a job was sliced from, read and turned as it was then; null where `path` is empty.
/// Whether it is that file is checked when it is placed. Errors: a table, a file that cannot be read.
Result<std::shared_ptr<const model::Mesh>> model_of_job(const std::string& path, const PreparedJob& job);

}  // namespace psicarve::cli
