// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/model/file_bytes.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/result.hpp"

namespace psicarve::model {

/// Reads geometry, and nothing else, through Assimp. `hint` is the format's usual extension: obj, ply, 3mf,
/// off.
Result<Mesh> read_with_assimp(const InputFile& file, const std::string& hint);

}  // namespace psicarve::model
