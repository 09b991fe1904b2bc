// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace psicarve::test {

/// A mesh that others made, of a package that `scripts/deps.sh test` installs.
struct RealMesh {
    std::string archive;  ///< empty: the file lies there as it is
    std::string path;     ///< in the archive, or of the file
};

inline RealMesh of_cgal(const std::string& name) {
    return {"/usr/share/doc/libcgal-dev/data.tar.gz", "data/meshes/" + name};
}
inline RealMesh of_opencascade(const std::string& name) {
    return {{}, "/usr/share/opencascade/data/stl/" + name};
}
inline RealMesh of_glmark(const std::string& name) {
    return {{}, "/usr/share/glmark2/models/" + name};
}

/// Its file, taken out of the archive into the folder if need be. Fails the test where it is not there.
inline std::string file_of(const RealMesh& mesh, const std::filesystem::path& folder) {
    const std::string& source = mesh.archive.empty() ? mesh.path : mesh.archive;
    EXPECT_TRUE(std::filesystem::exists(source))
        << source << " is not there: scripts/deps.sh test installs it";
    if (mesh.archive.empty()) return mesh.path;
    const std::string command =
        "tar -xzf '" + mesh.archive + "' -C '" + folder.string() + "' '" + mesh.path + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return (folder / mesh.path).string();
}

}  // namespace psicarve::test
