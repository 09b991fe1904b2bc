// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/three_mf_reader.hpp"

#include <assimp/scene.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "hmi/model/file_bytes.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/model/mesh_check.hpp"
#include "hmi/model/three_mf_unit.hpp"
#include "shared/result.hpp"

namespace psicarve::model {
namespace {

/// Walks Assimp's scene and collects its triangles where their nodes put them.
class SceneWalk {
public:
    SceneWalk(const aiScene& scene, Mesh& mesh) : scene_(scene), mesh_(mesh) {}

    void run(const ThreeMfUnit& unit) {
        aiMatrix4x4 in_mm;
        aiMatrix4x4::Scaling(aiVector3D(static_cast<float>(unit.mm)), in_mm);
        walk(*scene_.mRootNode, in_mm);
        mesh_.facts = check_.facts(mesh_.origin);
    }

private:
    void walk(const aiNode& node, const aiMatrix4x4& parent) {
        const aiMatrix4x4 placed = parent * node.mTransformation;
        for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene_.mMeshes[node.mMeshes[i]], placed);
        for (unsigned i = 0; i < node.mNumChildren; ++i) walk(*node.mChildren[i], placed);
    }

    void add(const aiMesh& part, const aiMatrix4x4& placed) {
        for (unsigned f = 0; f < part.mNumFaces; ++f) {
            const aiFace& face = part.mFaces[f];
            if (face.mNumIndices != 3) continue;  // points and lines have no surface
            Triangle triangle{};
            bool whole = true;
            for (std::size_t v = 0; v < 3; ++v) {
                const unsigned index = face.mIndices[v];
                whole = whole && index < part.mNumVertices;
                if (!whole) break;
                const aiVector3D at = placed * part.mVertices[index];
                triangle.vertices[v] = {at.x, at.y, at.z};
            }
            if (whole) check_.add_to(mesh_.triangles, triangle);
        }
    }

    const aiScene& scene_;
    Mesh& mesh_;
    MeshCheck check_;
};

std::string first_line(std::string text) {
    text.resize(std::min(text.find('\n'), text.size()));
    return text;
}

Result<Mesh> import(const InputFile& file, const std::vector<char>& bytes) {
    Assimp::Importer importer;
    // No post-processing: 3MF holds triangles alone, and Assimp's steps end the process on empty meshes.
    const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, "3mf");
    Mesh mesh;
    const ThreeMfUnit unit = three_mf_unit(file.path());
    mesh.format = unit.mm == 1.0 ? "3MF" : "3MF in units of a " + unit.name;
    if (scene == nullptr || scene->mRootNode == nullptr) {
        const std::string why = first_line(importer.GetErrorString());
        return bad_input(file.path() + ": not a readable 3MF file" + (why.empty() ? "" : ": " + why));
    }
    SceneWalk(*scene, mesh).run(unit);
    return mesh;
}

}  // namespace

Result<Mesh> read_3mf(const InputFile& file) {
    const Result<std::vector<char>> bytes = file.read_all();
    if (!bytes) return bytes.error();
    try {
        Result<Mesh> mesh = import(file, *bytes);
        if (mesh) mesh->source_hash = XXH3_64bits(bytes->data(), bytes->size());
        return mesh;
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_room, file.path() + ": too large for this computer's memory"};
    } catch (const std::exception& problem) {
        return bad_input(file.path() + ": not a readable 3MF file: " + first_line(problem.what()));
    }
}

}  // namespace psicarve::model
