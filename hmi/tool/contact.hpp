// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "hmi/tool/contact_parts.hpp"
#include "hmi/tool/tool.hpp"

namespace psicarve::tool {

/// One direction, seen from outside along the tool: a point of the mesh lies `across` to the left of the
/// tool's axis, `up`, and `out` from the rotation axis.
struct Column {
    double cosine;
    double sine;
    std::span<const double> heights;  ///< ascending
    std::span<double> tips;           ///< one for each height
};

/// Raises the tips in a column's rows to where a tool touches parts of a mesh.
class Contact {
public:
    explicit Contact(const Tool& tool);

    void touch(const Edge& edge, const Column& column) const;
    void touch(const Facet& facet, const Column& column) const;

private:
    Tool tool_;
    double flank_slope_;
};

}  // namespace psicarve::tool
