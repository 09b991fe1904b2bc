// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/model/file_bytes.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/result.hpp"

namespace psicarve::model {

/// Reads the geometry of a 3MF archive, and nothing else, through Assimp. The archive's unit is not looked
/// at: what it calls a unit is taken as a millimetre.
Result<Mesh> read_3mf(const InputFile& file);

}  // namespace psicarve::model
