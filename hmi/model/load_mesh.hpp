// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {

/// Reads STL (both kinds), OBJ, PLY, 3MF or OFF, decided by the content, then by the extension. A model that
/// cannot be carved is refused in one line "FILE: what, where"; one that can be carved with flaws gets
/// warnings.
Result<Mesh> load_mesh(const std::string& path);

/// Whether the file is of a kind that load_mesh reads, by its beginning and name alone; refuses others as
/// load_mesh does.
Result<void> check_is_mesh(const std::string& path);

}  // namespace psicarve::model
