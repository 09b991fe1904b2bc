// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/zip_archive.hpp"

#include <zip.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "shared/result.hpp"

namespace psicarve::model {
namespace {

// A few kilobytes can unpack to terabytes; no mesh of ours needs more text than this.
constexpr std::uint64_t kMostUnpackedBytes = std::uint64_t{4} << 30U;
constexpr std::size_t kPieceBytes = 1U << 16U;

struct PartCloser {
    void operator()(zip_file_t* part) const noexcept { zip_fclose(part); }
};

std::int64_t index_of(struct zip* archive, const std::string& part) noexcept {
    const char* name = part.c_str();
    if (*name == '/') ++name;
    return zip_name_locate(archive, name, ZIP_FL_NOCASE);
}

}  // namespace

void ZipArchive::Closer::operator()(struct zip* archive) const noexcept {
    zip_discard(archive);
}

Result<ZipArchive> ZipArchive::open(std::span<const char> bytes, const std::string& file) {
    zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr);
    struct zip* archive = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, nullptr);
    if (archive != nullptr) return ZipArchive(archive, file);
    zip_source_free(source);
    return bad_input(file + ": the zip archive is truncated or damaged: it has no readable directory");
}

bool ZipArchive::has(const std::string& part) const {
    return index_of(archive_.get(), part) >= 0;
}

Result<void> ZipArchive::read(const std::string& part,
                              const std::function<Result<void>(std::string_view piece)>& take) const {
    const std::int64_t index = index_of(archive_.get(), part);
    if (index < 0) return bad_input(file_ + ": the archive has no part " + part);
    const std::unique_ptr<zip_file_t, PartCloser> opened(
        zip_fopen_index(archive_.get(), static_cast<zip_uint64_t>(index), 0));
    const Error damaged = bad_input(file_ + ": part " + part + " of the archive is damaged or encrypted");
    if (opened == nullptr) return damaged;
    std::array<char, kPieceBytes> piece{};
    std::uint64_t unpacked_bytes = 0;
    while (true) {
        const std::int64_t got = zip_fread(opened.get(), piece.data(), piece.size());
        if (got < 0) return damaged;
        if (got == 0) return {};
        unpacked_bytes += static_cast<std::uint64_t>(got);
        if (unpacked_bytes > kMostUnpackedBytes) {
            return bad_input(file_ + ": part " + part + " unpacks to more than 4 GiB");
        }
        if (auto done = take({piece.data(), static_cast<std::size_t>(got)}); !done) return done;
    }
}

}  // namespace psicarve::model
