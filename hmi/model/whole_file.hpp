// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <xxhash.h>

#include <new>
#include <string_view>
#include <vector>

#include "hmi/model/file_bytes.hpp"
#include "hmi/model/mesh.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {

/// Runs a reader that wants the whole file in memory: Reader(bytes, path).read().
template <typename Reader>
Result<Mesh> read_whole(const InputFile& file) {
    const Result<std::vector<char>> bytes = file.read_all();
    if (!bytes) return bytes.error();
    try {
        Result<Mesh> mesh = Reader(std::string_view(bytes->data(), bytes->size()), file.path()).read();
        if (mesh) mesh->source_hash = XXH3_64bits(bytes->data(), bytes->size());
        return mesh;
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_room, file.path() + ": too large for this computer's memory"};
    }
}

}  // namespace psicarve::model
