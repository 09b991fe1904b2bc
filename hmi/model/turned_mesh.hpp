// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hmi/model/mesh.hpp"

namespace psicarve::model {

/// The mesh mirrored, then turned about the file's x, y and z axis, in this order, counter-clockwise seen
/// from that axis' positive end; all through the file's origin. Quarter turns are exact, other turns are
/// rounded as a file of floats would be. Outsides stay outside. Records it in Mesh::turn; requires a mesh
/// that was not turned before.
Mesh turned(Mesh mesh, const MeshTurn& turn);

}  // namespace psicarve::model
