// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/mesh_check.hpp"

#include <emmintrin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "hmi/model/duplicate_facets.hpp"
#include "hmi/model/edge_count.hpp"
#include "hmi/model/edge_hash.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {
namespace {

// More dropped facets than one in this many, and the file is garbage rather than a model with a flaw.
constexpr std::uint64_t kDroppedFacetsAllowedOneIn = 20;
// A closed mesh is hollow paper when its volume is this small a part of its box.
constexpr double kLeastVolumeShare = 1e-9;
// Counting edges needs 24 bytes a facet; beyond this the warning goes without the count.
constexpr std::size_t kMostFacetsCounted = 20'000'000;

// Vertices this near to each other, in parts of the mesh's size, are one: some three steps of a float, and a
// hundredth of a pulse on the finest machine.
constexpr double kWeldRatio = 0x1p-22;

// One facet in this many is checked for duplicates while reading.
constexpr std::uint64_t kSampledFacetsOneIn = 64;

/// How often a hash follows an equal one.
std::uint64_t count_equal(std::vector<std::uint64_t>& hashes) {
    std::sort(hashes.begin(), hashes.end());
    std::uint64_t count = 0;
    for (std::size_t i = 1; i < hashes.size(); ++i) count += hashes[i] == hashes[i - 1] ? 1 : 0;
    return count;
}

/// The facts of the mesh without its duplicates.
void look_again(Mesh& mesh) {
    MeshCheck check;
    for (const Triangle& triangle : mesh.triangles) {
        Triangle again;
        check.accept(reinterpret_cast<const char*>(&triangle), again);
    }
    const MeshFacts before = mesh.facts;
    mesh.facts = check.facts(mesh.origin);
    mesh.facts.dropped_count = before.dropped_count;
    mesh.facts.duplicate_count = before.duplicate_count;
    mesh.facts.doubled_vertex_count = before.doubled_vertex_count;
    mesh.facts.coordinate_step = before.coordinate_step;
}

/// A facet that is listed twice is not a surface behind a surface.
void leave_out_duplicates(Mesh& mesh) {
    MeshFacts& facts = mesh.facts;
    if (mesh.triangles.size() > kMostFacetsCounted) return;
    if (facts.closed && facts.same_orientation && !facts.saw_duplicates) return;
    facts.duplicate_count = drop_duplicates(mesh.triangles);
    if (facts.duplicate_count > 0) look_again(mesh);
}

void count_flaws(Mesh& mesh) {
    MeshFacts& facts = mesh.facts;
    if (mesh.triangles.size() > kMostFacetsCounted) return;
    if (facts.closed && facts.same_orientation) return;
    double size = 0.0;
    for (std::size_t k = 0; k < 3; ++k) size = std::max(size, facts.max[k] - facts.min[k]);
    const EdgeCounts counts = join_torn_edges(mesh.triangles, kWeldRatio * size);
    facts.open_edge_count = counts.open;
    facts.turned_edge_count = counts.turned;
    facts.closed = counts.open == 0;
    facts.same_orientation = counts.turned == 0;
}

std::string counted(std::uint64_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

void write_warnings(Mesh& mesh) {
    const MeshFacts& facts = mesh.facts;
    std::vector<std::string>& out = mesh.warnings;
    if (facts.dropped_count > 0) {
        out.push_back(counted(facts.dropped_count, "facet", "facets") +
                      " with a NaN or infinite coordinate left out");
    }
    if (!facts.closed) {
        out.push_back(
            "the mesh has holes: " +
            (facts.open_edge_count > 0 ? counted(facts.open_edge_count, "edge belongs", "edges belong")
                                       : std::string("some edges belong")) +
            " to an odd number of facets; a hole is carved down to what lies behind it, or to the core");
    }
    if (facts.turned_edge_count > 0) {
        out.push_back("some facets are flipped: along " + counted(facts.turned_edge_count, "edge", "edges") +
                      " the neighbours disagree about what is outside; carved as if they agreed");
    } else if (facts.closed && facts.same_orientation && facts.signed_volume < 0.0) {
        out.emplace_back("the mesh is inside out: all facets are flipped; carved as if they were not");
    }
    if (facts.degenerate_count > 0) {
        out.push_back(counted(facts.degenerate_count, "facet", "facets") +
                      " without area (degenerate), ignored");
    }
    if (facts.duplicate_count > 0) {
        out.push_back(counted(facts.duplicate_count, "facet stands", "facets stand") +
                      " in the file once more; left out");
    }
    if (facts.doubled_vertex_count > 0) {
        out.push_back(
            counted(facts.doubled_vertex_count, "vertex is a duplicate", "vertices are duplicates") +
            " of another at the same place, taken as one");
    }
}

/// Whether all facets lie in one plane (within float rounding), however that plane stands.
bool lies_in_a_plane(const TriangleList& triangles, const MeshFacts& facts) {
    std::array<double, 3> normal{};
    double largest = 0.0;
    const auto cross_of = [](const Triangle& t) {
        std::array<double, 3> u{};
        std::array<double, 3> v{};
        for (std::size_t i = 0; i < 3; ++i) {
            u[i] = double{t.vertices[1][i]} - t.vertices[0][i];
            v[i] = double{t.vertices[2][i]} - t.vertices[0][i];
        }
        return std::array<double, 3>{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                     u[0] * v[1] - u[1] * v[0]};
    };
    for (const Triangle& t : triangles) {
        const auto n = cross_of(t);
        const double square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
        if (square > largest) {
            largest = square;
            normal = n;
        }
    }
    if (largest == 0.0) return true;
    double size = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        normal[i] /= std::sqrt(largest);
        size = std::max(size, facts.max[i] - facts.min[i]);
    }
    const auto& base = triangles.front().vertices[0];
    return std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
        return std::all_of(t.vertices.begin(), t.vertices.end(), [&](const std::array<float, 3>& v) {
            double away = 0.0;
            for (std::size_t i = 0; i < 3; ++i) away += normal[i] * (double{v[i]} - base[i]);
            return std::abs(away) <= 1e-6 * size;
        });
    });
}

bool has_volume(const Mesh& mesh) {
    const MeshFacts& facts = mesh.facts;
    double box_volume = 1.0;
    for (std::size_t i = 0; i < 3; ++i) box_volume *= facts.max[i] - facts.min[i];
    if (!(box_volume > 0.0)) return false;
    if (!facts.closed || !facts.same_orientation) return !lies_in_a_plane(mesh.triangles, facts);
    return std::abs(facts.signed_volume) > kLeastVolumeShare * box_volume;
}

}  // namespace

bool MeshCheck::accept(const char* coordinates, Triangle& out) {
    // Three overlapping loads hold all nine coordinates; adding 0 makes -0 to 0: one place, one bit pattern.
    const auto load = [coordinates](std::size_t index) {
        const char* from = coordinates + index * sizeof(float);
        const __m128i bits = _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
        return _mm_add_ps(_mm_castsi128_ps(bits), _mm_setzero_ps());
    };
    const __m128 a4 = load(0);  // ax ay az bx
    const __m128 b4 = load(3);  // bx by bz cx
    const __m128 z4 = load(5);  // bz cx cy cz
    const __m128 c4 = _mm_shuffle_ps(z4, z4, _MM_SHUFFLE(3, 3, 2, 1));
    float* v = out.vertices[0].data();
    _mm_storeu_ps(v, a4);
    _mm_storeu_ps(v + 3, b4);
    _mm_storeu_ps(v + 5, z4);

    const auto& [a, b, c] = out.vertices;
    const double ux = double{b[0]} - a[0];
    const double uy = double{b[1]} - a[1];
    const double uz = double{b[2]} - a[2];
    const double vx = double{c[0]} - a[0];
    const double vy = double{c[1]} - a[1];
    const double vz = double{c[2]} - a[2];
    const double nx = uy * vz - uz * vy;
    const double ny = uz * vx - ux * vz;
    const double nz = ux * vy - uy * vx;
    // A NaN or infinite coordinate always shows in the normal: infinity less itself, or times 0, is NaN.
    const double size = std::abs(nx) + std::abs(ny) + std::abs(nz);
    if (!(size <= std::numeric_limits<double>::max())) {
        ++dropped_count_;
        return false;
    }
    if (size == 0.0) ++degenerate_count_;
    const __m128 low = _mm_min_ps(_mm_min_ps(a4, b4), c4);
    const __m128 high = _mm_max_ps(_mm_max_ps(a4, b4), c4);
    if (accepted_count_++ == 0) {
        first_ = a;
        _mm_storeu_ps(min_.data(), low);
        _mm_storeu_ps(max_.data(), high);
    }
    _mm_storeu_ps(min_.data(), _mm_min_ps(_mm_loadu_ps(min_.data()), low));
    _mm_storeu_ps(max_.data(), _mm_max_ps(_mm_loadu_ps(max_.data()), high));
    volume_times_6_ +=
        nx * (double{a[0]} - first_[0]) + ny * (double{a[1]} - first_[1]) + nz * (double{a[2]} - first_[2]);
    hash_edges(out);
    return true;
}

void MeshCheck::add_to(TriangleList& list, const Triangle& triangle) {
    std::array<char, sizeof(Triangle)> bytes{};
    std::memcpy(bytes.data(), &triangle, sizeof(Triangle));
    Triangle accepted;
    if (accept(bytes.data(), accepted)) list.push_back(accepted);
}

void MeshCheck::hash_edges(const Triangle& triangle) {
    const std::uint64_t a = vertex_hash(triangle.vertices[0]);
    const std::uint64_t b = vertex_hash(triangle.vertices[1]);
    const std::uint64_t c = vertex_hash(triangle.vertices[2]);
    const std::uint64_t ab = edge_hash(a, b);
    const std::uint64_t bc = edge_hash(b, c);
    const std::uint64_t ca = edge_hash(c, a);
    directed_edge_sum_ +=
        directed_edge_hash(a, b, ab) + directed_edge_hash(b, c, bc) + directed_edge_hash(c, a, ca);
    edge_parity_ ^= (a == b ? 0 : ab) ^ (b == c ? 0 : bc) ^ (c == a ? 0 : ca);
    const std::uint64_t facet = a + b + c;
    if (facet % kSampledFacetsOneIn == 0) sampled_facets_.push_back(facet);
}

MeshFacts MeshCheck::facts(const std::array<double, 3>& origin) {
    MeshFacts facts;
    facts.dropped_count = dropped_count_;
    facts.degenerate_count = degenerate_count_;
    facts.closed = edge_parity_ == 0;
    facts.same_orientation = directed_edge_sum_ == 0;
    facts.saw_duplicates = count_equal(sampled_facets_) > 0;
    facts.signed_volume = volume_times_6_ / 6.0;
    for (std::size_t k = 0; k < 3; ++k) {
        facts.min[k] = origin[k] + double{min_[k]};
        facts.max[k] = origin[k] + double{max_[k]};
    }
    return facts;
}

double float_step_at(const MeshFacts& facts) noexcept {
    double farthest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        farthest = std::max({farthest, std::abs(facts.min[k]), std::abs(facts.max[k])});
    }
    const auto at = static_cast<float>(farthest);
    return double{std::nextafter(at, std::numeric_limits<float>::max())} - double{at};
}

Result<void> judge_mesh(Mesh& mesh, const std::string& file) {
    const std::uint64_t dropped = mesh.facts.dropped_count;
    const std::uint64_t total = dropped + mesh.triangles.size();
    if (total == 0) return bad_input(file + ": holds no facets (" + mesh.format + ")");
    if (dropped * kDroppedFacetsAllowedOneIn > total) {
        return bad_input(file + ": " + std::to_string(dropped) + " of " + std::to_string(total) +
                         " facets have NaN or infinite coordinates; this is not a usable mesh");
    }
    leave_out_duplicates(mesh);
    if (!has_volume(mesh)) {
        return bad_input(file + ": the mesh has no volume (all of it is flat); there is nothing to carve");
    }
    count_flaws(mesh);
    write_warnings(mesh);
    return {};
}

}  // namespace psicarve::model
