// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "hmi/flat/grooves.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {

/// The cylinder with its grooves, as triangles between samples of their cross-section; Mesh::grooves keeps
/// the exact form.
Result<model::Mesh> engraved_body(std::shared_ptr<const Grooves> grooves, const std::string& format,
                                  const std::string& file);

}  // namespace psicarve::flat
