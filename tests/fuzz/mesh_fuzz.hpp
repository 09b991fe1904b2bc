// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "hmi/model/file_bytes.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/model/mesh_check.hpp"
#include "shared/base/result.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/require.hpp"

namespace psicarve::fuzz {

/// Every coordinate is a number within the box that the facts tell.
inline void require_sound(const model::Mesh& mesh) {
    require(!mesh.triangles.empty(), "a mesh has facets");
    const model::MeshFacts& facts = mesh.facts;
    for (const model::Triangle& triangle : mesh.triangles) {
        for (const auto& vertex : triangle.vertices) {
            for (std::size_t k = 0; k < 3; ++k) {
                const double at = double{vertex[k]} + mesh.origin[k];
                require(std::isfinite(at), "a coordinate is a number");
                require(at >= facts.min[k] && at <= facts.max[k], "a vertex lies in the box");
            }
        }
    }
    for (const std::string& warning : mesh.warnings) {
        require(!warning.empty() && warning.find('\n') == std::string::npos, "a warning is one line");
    }
}

/// A file is refused with one line, or it is a mesh that can be carved.
inline void require_mesh_or_refusal(std::span<const std::uint8_t> bytes,
                                    Result<model::Mesh> (*read)(const model::InputFile&)) {
    const MemoryFile on_disk(bytes);
    const auto file = model::InputFile::open(on_disk.path());
    require(static_cast<bool>(file), "the reader gets its file");
    auto mesh = read(*file);
    require_one_line(mesh);
    if (!mesh) return;
    const auto judged = model::judge_mesh(*mesh, "fuzzed");
    require_one_line(judged);
    if (judged) require_sound(*mesh);
}

}  // namespace psicarve::fuzz
