// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/model/file_bytes.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {

/// Wavefront OBJ: reads points and faces, ignores all else.
Result<Mesh> read_obj(const InputFile& file);

/// Object File Format, also with normals or colours; text only.
Result<Mesh> read_off(const InputFile& file);

/// Polygon File Format: text and binary of both byte orders.
Result<Mesh> read_ply(const InputFile& file);

}  // namespace psicarve::model
