// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "shared/program/program_source.hpp"

namespace psicarve::cli {

/// 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);
/// "1234 bytes, XXH3 0123456789abcdef": a text by what tells it from others.
std::string text_words(std::uint64_t bytes, std::uint64_t sum);

/// A line for a person, for `snapshot info`: which text the last program's records were made of, and how it
/// was read. Null: empty, the snapshot does not know.
std::string source_text(const RecordedSource* recorded);
/// What `snapshot info --json` says of it; null where the snapshot does not know.
nlohmann::ordered_json source_json(const RecordedSource* recorded);

}  // namespace psicarve::cli
