// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "hmi/model/zip_archive.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {

/// Four rows of three, as 3MF writes them: a point is a row, (x y z 1) times these.
using Placement3mf = std::array<double, 12>;
inline constexpr Placement3mf kUnmoved3mf{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};

/// A file with more objects and components than this is refused, whether they stand in the file or arise from
/// putting them together.
inline constexpr std::size_t kMostObjects3mf = 100'000;

/// An object's name: the model part that holds it (0 is the one that the package begins with), and its number
/// there.
using ObjectKey = std::pair<std::size_t, std::uint64_t>;

struct PlacedObject {
    ObjectKey object;
    Placement3mf placement = kUnmoved3mf;
};

/// One object: a mesh of its own, or an assembly of others.
struct Object3mf {
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<PlacedObject> components;
};

/// What the model parts of an archive say about geometry.
struct Package3mf {
    std::string unit = "millimeter";  ///< of the part that the package begins with
    double mm_per_unit = 1.0;
    std::map<ObjectKey, Object3mf> objects;
    std::vector<PlacedObject> build;  ///< the objects to be made
};

/// Reads the model part that the package begins with, and those that it names.
/// Source: 3D Manufacturing Format, core specification 1.2 and production extension 1.1.
Result<Package3mf> read_3mf_parts(ZipArchive& archive);

}  // namespace psicarve::model
