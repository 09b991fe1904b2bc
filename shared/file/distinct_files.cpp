// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/file/distinct_files.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace psicarve {
namespace {

/// Equal for two names of one file.
struct FileIdentity {
    dev_t device;
    ino_t inode;       ///< of the file, or of its folder while there is no file
    std::string leaf;  ///< its name there; empty: the file is there

    bool operator==(const FileIdentity&) const = default;
};

std::string parent_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "./" : path.substr(0, slash + 1);
}

/// The target of a link that leads to nothing yet; else the path itself.
std::string followed(std::string path) {
    constexpr int kMostLinks = 40;
    for (int i = 0; i < kMostLinks; ++i) {
        std::array<char, 4096> target{};
        const ssize_t size = ::readlink(path.c_str(), target.data(), target.size());
        if (size <= 0) break;
        const std::string_view to{target.data(), static_cast<std::size_t>(size)};
        path = to.front() == '/' ? std::string{to} : parent_of(path).append(to);
    }
    return path;
}

/// Nothing where no file can be lost.
std::optional<FileIdentity> identity_of(const std::string& given) {
    if (given.empty() || given == "-") return std::nullopt;
    struct stat facts {};
    if (::stat(given.c_str(), &facts) == 0) {
        if (!S_ISREG(facts.st_mode)) return std::nullopt;
        return FileIdentity{facts.st_dev, facts.st_ino, ""};
    }
    const std::string path = followed(given);
    const std::string folder = parent_of(path);
    if (::stat(folder.c_str(), &facts) != 0) return std::nullopt;
    return FileIdentity{facts.st_dev, facts.st_ino,
                        path.substr(path.rfind('/') == std::string::npos ? 0 : folder.size())};
}

Error same_file(const NamedFile& written, const NamedFile& other) {
    const std::string both =
        written.name + " " + written.path + " and " + other.name + " " + other.path + " are one file, ";
    const char* const why =
        other.is_written ? "and only one of them could be kept" : "and what is read there would be lost";
    return Error{ErrorCode::bad_usage, both + why + ": choose another name"};
}

}  // namespace

bool is_same_file(const std::string& one, const std::string& other) {
    const auto identity = identity_of(one);
    return identity && identity == identity_of(other);
}

Result<void> check_distinct(std::span<const NamedFile> files) {
    for (std::size_t i = 0; i < files.size(); ++i) {
        for (std::size_t j = i + 1; j < files.size(); ++j) {
            if (!files[i].is_written && !files[j].is_written) continue;
            if (!is_same_file(files[i].path, files[j].path)) continue;
            return files[i].is_written ? same_file(files[i], files[j]) : same_file(files[j], files[i]);
        }
    }
    return {};
}

}  // namespace psicarve
