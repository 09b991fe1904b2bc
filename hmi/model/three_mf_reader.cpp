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
#include "hmi/model/three_mf_parts.hpp"
#include "hmi/model/whole_file.hpp"
#include "hmi/model/zip_archive.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {
namespace {

// Objects made of objects can multiply without end, or name themselves.
constexpr int kDeepestNesting = 32;
constexpr std::size_t kMostPointsAndTriangles = 100'000'000;

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

std::array<double, 3> moved(const std::array<double, 3>& p, const Placement3mf& m) noexcept {
    std::array<double, 3> out{};
    for (std::size_t k = 0; k < 3; ++k) out[k] = p[0] * m[k] + p[1] * m[3 + k] + p[2] * m[6 + k] + m[9 + k];
    return out;
}

bool is_mirroring(const Placement3mf& m) noexcept {
    const double determinant = m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
                               m[2] * (m[3] * m[7] - m[4] * m[6]);
    return determinant < 0.0;
}

/// Places the build's objects and collects their triangles.
class ThreeMfReader {
public:
    ThreeMfReader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

    Result<Mesh> read() {
        auto archive = ZipArchive::open(bytes_, file_);
        if (!archive) return archive.error();
        auto package = read_3mf_parts(*archive);
        if (!package) return package.error();
        package_ = std::move(*package);
        const double mm = package_.mm_per_unit;
        const Placement3mf to_mm{mm, 0, 0, 0, mm, 0, 0, 0, mm, 0, 0, 0};
        for (const PlacedObject& item : package_.build) {
            if (auto good = check(item, 0); !good) return good.error();
        }
        for (const PlacedObject& item : package_.build) place(item, to_mm);
        return mesh_.finish(mm == 1.0 ? "3MF" : "3MF, unit " + package_.unit);
    }

private:
    /// Checks that all objects are there, and not too many once they are put together.
    Result<void> check(const PlacedObject& placed, int depth) {
        const std::string name = "object " + std::to_string(placed.object.second);
        const auto found = package_.objects.find(placed.object);
        if (found == package_.objects.end()) return bad_input(file_ + ": " + name + " is not in the archive");
        if (depth > kDeepestNesting)
            return bad_input(file_ + ": " + name + " stands more than " + std::to_string(kDeepestNesting) +
                             " deep in others, or in itself");
        const Object3mf& object = found->second;
        element_count_ += object.points.size() + object.triangles.size();
        if (++placed_count_ > kMostObjects3mf || element_count_ > kMostPointsAndTriangles)
            return bad_input(file_ + ": its objects multiply to more than can be carved");
        for (const PlacedObject& component : object.components) {
            if (auto good = check(component, depth + 1); !good) return good;
        }
        return {};
    }

    void place(const PlacedObject& placed, const Placement3mf& outer) {
        const Object3mf& object = package_.objects.at(placed.object);
        const Placement3mf placement = chained(placed.placement, outer);
        add_mesh(object, placement);
        for (const PlacedObject& component : object.components) place(component, placement);
    }

    void add_mesh(const Object3mf& object, const Placement3mf& placement) {
        const std::uint64_t first = mesh_.point_count();
        for (const auto& point : object.points) mesh_.add_point(moved(point, placement));
        // A mirror turns a surface inside out.
        const bool is_turned = is_mirroring(placement);
        for (const auto& [a, b, c] : object.triangles) {
            const std::array<std::uint64_t, 3> corners{first + a, first + (is_turned ? c : b),
                                                       first + (is_turned ? b : c)};
            mesh_.add_polygon(corners);
        }
    }

    std::string_view bytes_;
    const std::string& file_;
    Package3mf package_;
    IndexedMesh mesh_;
    std::size_t placed_count_ = 0;
    std::size_t element_count_ = 0;  ///< points and triangles
};

}  // namespace

Result<Mesh> read_3mf(const InputFile& file) {
    return read_whole<ThreeMfReader>(file);
}

}  // namespace psicarve::model
