// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/zip_archive.hpp"

#include <zip.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "hmi/model/text_scan.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {
namespace {

constexpr std::size_t kPieceBytes = 1U << 16U;
constexpr std::size_t kShownMemberName = 80;

struct PartCloser {
    void operator()(zip_file_t* part) const noexcept { zip_fclose(part); }
};

std::int64_t index_of(struct zip* archive, const std::string& part) noexcept {
    const char* name = part.c_str();
    if (*name == '/') ++name;
    return zip_name_locate(archive, name, ZIP_FL_NOCASE);
}

std::string shown(const std::string& part) {
    return "part " + quoted(part, kShownMemberName) + " of the archive";
}

}  // namespace

void ZipArchive::Closer::operator()(struct zip* archive) const noexcept {
    zip_discard(archive);
}

Result<ZipArchive> ZipArchive::open(std::span<const char> bytes, const std::string& file,
                                    const UnpackLimits& limits) {
    if (std::string_view(bytes.data(), bytes.size()).substr(0, 2) != "PK")
        return bad_input(file + ": is no 3MF file: these are zip archives");
    zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr);
    struct zip* archive = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, nullptr);
    if (archive != nullptr) {
        const std::uint64_t by_ratio = std::max(limits.free_bytes, limits.most_ratio * bytes.size());
        return ZipArchive(archive, file, std::min(limits.most_bytes, by_ratio));
    }
    zip_source_free(source);
    return bad_input(file + ": the zip archive is truncated or damaged: it has no readable directory");
}

bool ZipArchive::has(const std::string& part) const {
    return index_of(archive_.get(), part) >= 0;
}

/// The reason in the archive's directory why this part cannot be read, if there is one.
std::optional<Error> ZipArchive::refusal_of(std::uint64_t index, const std::string& part) const {
    zip_stat_t facts;
    zip_stat_init(&facts);
    if (zip_stat_index(archive_.get(), index, 0, &facts) != 0)
        return bad_input(file_ + ": " + shown(part) + " is damaged");
    if ((facts.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && facts.encryption_method != ZIP_EM_NONE)
        return bad_input(file_ + ": " + shown(part) + " is encrypted: save it without a password");
    // 3MF knows no other; some of the others allocate what the part announces.
    const bool is_known = facts.comp_method == ZIP_CM_STORE || facts.comp_method == ZIP_CM_DEFLATE;
    if ((facts.valid & ZIP_STAT_COMP_METHOD) != 0 && !is_known)
        return bad_input(file_ + ": " + shown(part) + " is packed in a way that 3MF does not allow");
    return std::nullopt;
}

Result<void> ZipArchive::read(const std::string& part,
                              const std::function<Result<void>(std::string_view piece)>& take) {
    const std::int64_t found = index_of(archive_.get(), part);
    if (found < 0) return bad_input(file_ + ": there is no " + shown(part));
    const auto index = static_cast<std::uint64_t>(found);
    if (const auto refusal = refusal_of(index, part)) return *refusal;
    const std::unique_ptr<zip_file_t, PartCloser> opened(zip_fopen_index(archive_.get(), index, 0));
    const Error damaged = bad_input(file_ + ": " + shown(part) + " is damaged");
    if (opened == nullptr) return damaged;
    std::array<char, kPieceBytes> piece{};
    while (true) {
        const std::int64_t got = zip_fread(opened.get(), piece.data(), piece.size());
        if (got < 0) return damaged;
        if (got == 0) return {};
        const auto got_bytes = static_cast<std::uint64_t>(got);
        if (got_bytes > unpackable_bytes_)
            return bad_input(file_ + ": the archive unpacks to far more than a model needs");
        unpackable_bytes_ -= got_bytes;
        if (auto done = take({piece.data(), static_cast<std::size_t>(got)}); !done) return done;
    }
}

}  // namespace psicarve::model
