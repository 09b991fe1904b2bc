// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/three_mf_reader.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "hmi/model/file_bytes.hpp"
#include "hmi/model/indexed_mesh.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/model/mesh_check.hpp"
#include "hmi/model/three_mf_parts.hpp"
#include "hmi/model/zip_archive.hpp"
#include "shared/result.hpp"

namespace psicarve::model {
namespace {

// Objects made of objects can multiply without end, or name themselves.
constexpr int kDeepestNesting = 32;
constexpr std::uint64_t kMostPlacedObjects = 100'000;
constexpr std::size_t kMostTriangles = 200'000'000;

/// First `inner`, then `outer`.
Placement3mf chained(const Placement3mf& inner, const Placement3mf& outer) noexcept {
    Placement3mf out{};
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            double sum = row == 3 ? outer[9 + column] : 0.0;
            for (std::size_t k = 0; k < 3; ++k) sum += inner[3 * row + k] * outer[3 * k + column];
            out[3 * row + column] = sum;
        }
    }
    return out;
}

bool is_mirroring(const Placement3mf& m) noexcept {
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
               m[2] * (m[3] * m[7] - m[4] * m[6]) <
           0.0;
}

/// Puts objects where the build wants them and collects their triangles.
class Builder3mf {
public:
    Builder3mf(const Package3mf& package, const std::string& file) : package_(package), file_(file) {}

    Result<Mesh> build() {
        const double mm = package_.mm_per_unit;
        const Placement3mf to_mm{mm, 0, 0, 0, mm, 0, 0, 0, mm, 0, 0, 0};
        for (const PlacedObject& item : package_.build) {
            if (auto done = place(item, to_mm, 0); !done) return done.error();
        }
        mesh_.format = "3MF";
        mesh_.facts = check_.facts(mesh_.origin);
        return std::move(mesh_);
    }

private:
    Result<void> place(const PlacedObject& placed, const Placement3mf& outer, int depth) {
        const std::string name = "object " + std::to_string(placed.object.second);
        const auto found = package_.objects.find(placed.object);
        if (found == package_.objects.end()) return bad_input(file_ + ": " + name + " is not in the archive");
        if (depth > kDeepestNesting) return bad_input(file_ + ": " + name + " is made of itself");
        const Object3mf& object = found->second;
        ++placed_count_;
        if (placed_count_ > kMostPlacedObjects ||
            mesh_.triangles.size() + object.triangles.size() > kMostTriangles) {
            return bad_input(file_ + ": its objects multiply to more than can be carved");
        }
        const Placement3mf placement = chained(placed.placement, outer);
        add_triangles(object, placement);
        for (const PlacedObject& component : object.components) {
            if (auto done = place(component, placement, depth + 1); !done) return done;
        }
        return {};
    }

    std::array<double, 3> at(const std::array<double, 3>& p, const Placement3mf& m) const noexcept {
        std::array<double, 3> out{};
        for (std::size_t k = 0; k < 3; ++k)
            out[k] = p[0] * m[k] + p[1] * m[3 + k] + p[2] * m[6 + k] + m[9 + k];
        return out;
    }

    void add_triangles(const Object3mf& object, const Placement3mf& placement) {
        // A mirror turns a surface inside out.
        const bool is_turned = is_mirroring(placement);
        for (std::array<std::uint32_t, 3> corners : object.triangles) {
            if (is_turned) std::swap(corners[1], corners[2]);
            Triangle triangle{};
            for (std::size_t v = 0; v < 3; ++v) {
                const std::array<double, 3> point = at(object.points[corners[v]], placement);
                if (!origin_chosen_) mesh_.origin = origin_near(point);
                origin_chosen_ = true;
                for (std::size_t k = 0; k < 3; ++k) {
                    triangle.vertices[v][k] = static_cast<float>(point[k] - mesh_.origin[k]);
                }
            }
            check_.add_to(mesh_.triangles, triangle);
        }
    }

    const Package3mf& package_;
    const std::string& file_;
    Mesh mesh_;
    MeshCheck check_;
    std::uint64_t placed_count_ = 0;
    bool origin_chosen_ = false;
};

}  // namespace

Result<Mesh> read_3mf(const InputFile& file) {
    return mesh_of_whole_file(file, [&file](std::string_view bytes) -> Result<Mesh> {
        const auto archive = ZipArchive::open(bytes, file.path());
        if (!archive) return archive.error();
        const auto package = read_3mf_parts(*archive);
        if (!package) return package.error();
        return Builder3mf(*package, file.path()).build();
    });
}

}  // namespace psicarve::model
