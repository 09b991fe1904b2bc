// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/model/file_bytes.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {

/// Reads what a 3MF archive's build places, in mm whatever unit it is written in. Reads geometry alone.
Result<Mesh> read_3mf(const InputFile& file);

}  // namespace psicarve::model
