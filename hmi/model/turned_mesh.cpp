// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/turned_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "shared/base/units.hpp"

namespace psicarve::model {
namespace {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;  // by row

struct CosineSine {
    double cosine;
    double sine;
};

/// Exact at quarter turns.
CosineSine cosine_sine(double degrees) {
    const double quarters = degrees / 90.0;
    if (quarters == std::floor(quarters)) {
        constexpr std::array<CosineSine, 4> kQuarters{{{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}}};
        const double rest = quarters - 4.0 * std::floor(quarters / 4.0);
        return kQuarters[static_cast<std::size_t>(rest)];
    }
    return {std::cos(rad_from_deg(degrees)), std::sin(rad_from_deg(degrees))};
}

Matrix matrix_of(const MeshTurn& turn) {
    Matrix matrix{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    if (turn.mirror) matrix[*turn.mirror][*turn.mirror] = -1.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [cosine, sine] = cosine_sine(turn.rotate_deg[axis]);
        const std::size_t from = (axis + 1) % 3;
        const std::size_t to = (axis + 2) % 3;
        const Vector was_from = matrix[from];
        const Vector was_to = matrix[to];
        for (std::size_t k = 0; k < 3; ++k) {
            matrix[from][k] = cosine * was_from[k] - sine * was_to[k];
            matrix[to][k] = sine * was_from[k] + cosine * was_to[k];
        }
    }
    return matrix;
}

Vector product(const Matrix& matrix, const Vector& point) {
    Vector out{};
    for (std::size_t row = 0; row < 3; ++row)
        out[row] = matrix[row][0] * point[0] + matrix[row][1] * point[1] + matrix[row][2] * point[2];
    return out;
}

void measure(Mesh& mesh) {
    bool is_first = true;
    for (const Triangle& triangle : mesh.triangles) {
        for (const auto& vertex : triangle.vertices) {
            for (std::size_t k = 0; k < 3; ++k) {
                const double at = mesh.origin[k] + double{vertex[k]};
                mesh.facts.min[k] = is_first ? at : std::min(mesh.facts.min[k], at);
                mesh.facts.max[k] = is_first ? at : std::max(mesh.facts.max[k], at);
            }
            is_first = false;
        }
    }
}

}  // namespace

Mesh turned(Mesh mesh, const MeshTurn& turn) {
    if (!turn.any()) return mesh;
    const Matrix matrix = matrix_of(turn);
    mesh.origin = product(matrix, mesh.origin);
    for (Triangle& triangle : mesh.triangles) {
        for (auto& vertex : triangle.vertices) {
            const Vector at = product(matrix, {vertex[0], vertex[1], vertex[2]});
            // Adding 0 makes -0 to 0: one place, one bit pattern.
            for (std::size_t k = 0; k < 3; ++k) vertex[k] = static_cast<float>(at[k]) + 0.0F;
        }
        if (turn.mirror) std::swap(triangle.vertices[1], triangle.vertices[2]);
    }
    measure(mesh);
    if (mesh.axis_hint && turn.rotate_deg[0] == 0.0 && turn.rotate_deg[1] == 0.0) {
        const Vector hint = product(matrix, {(*mesh.axis_hint)[0], (*mesh.axis_hint)[1], 0.0});
        mesh.axis_hint = {hint[0], hint[1]};
    } else {
        mesh.axis_hint.reset();
    }
    mesh.turn = turn;
    return mesh;
}

}  // namespace psicarve::model
