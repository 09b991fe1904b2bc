// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {

/// Checks every facet once, in constant memory, while a reader makes them.
/// Whether a mesh is closed is decided by sums over hashed edges: in a closed, consistently turned mesh each
/// edge comes once in each direction and the sum is zero. A wrong "closed" has a chance of about 2^-64.
class MeshCheck {
public:
    /// Takes nine coordinates as a file holds them (36 bytes, any alignment) into `out`, -0 made to 0. False
    /// when one of them is NaN or infinite: leave that facet out.
    bool accept(const char* coordinates, Triangle& out);

    /// Appends the facet unless accept says no.
    void add_to(TriangleList& list, const Triangle& triangle);

    /// Bounding box, volume and closedness of the accepted facets.
    MeshFacts facts(const std::array<double, 3>& origin);

private:
    void hash_edges(const Triangle& triangle);

    std::array<float, 3> first_{};
    std::array<float, 4> min_{};  ///< the fourth is whatever follows a vertex in memory
    std::array<float, 4> max_{};
    double volume_times_6_ = 0.0;
    std::uint64_t accepted_count_ = 0;
    std::uint64_t dropped_count_ = 0;
    std::uint64_t degenerate_count_ = 0;
    std::uint64_t directed_edge_sum_ = 0;
    std::uint64_t edge_parity_ = 0;
    std::vector<std::uint64_t> sampled_facets_;
};

/// The step between two floats at the farthest coordinate of the box: what a file of floats can tell apart.
double float_step_at(const MeshFacts& facts) noexcept;

/// The last step of every reader: refuses meshes that cannot be carved ("FILE: what, where"), counts open
/// edges and duplicate facets where the quick check found something, and writes the warnings.
Result<void> judge_mesh(Mesh& mesh, const std::string& file);

}  // namespace psicarve::model
