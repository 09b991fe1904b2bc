// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "hmi/trace/binary_reader.hpp"
#include "hmi/trace/byte_source.hpp"
#include "shared/job/job.hpp"
#include "shared/trace/trace_format.hpp"
#include "tests/fuzz/trace_fuzz.hpp"

namespace {

using psicarve::fuzz::require;
using psicarve::fuzz::require_one_line;
using psicarve::verify::BinaryReader;

/// What the first job comes to: its blob, "no job", or why not.
std::string first_job(int descriptor) {
    const auto reader = BinaryReader::open_binary(psicarve::verify::ByteSource(descriptor, "fuzzed"));
    if (!reader) return reader.error().message;
    const auto job = (*reader)->next_job(true);
    require_one_line(job);
    if (!job) return job.error().message;
    if (!*job) return "no job";
    require_one_line(psicarve::JobView::check((*job)->blob));
    return {reinterpret_cast<const char*>((*job)->blob.data()), (*job)->blob.size()};
}

}  // namespace

/// Binary pin traces: all bytes are read as one, whatever they begin with.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<std::uint8_t> bytes(data, data + size);
    const auto magic = std::as_bytes(std::span(&psicarve::kTraceMagic, 1));
    for (std::size_t i = 0; i < std::min(bytes.size(), magic.size()); ++i)
        bytes[i] = std::to_integer<std::uint8_t>(magic[i]);
    psicarve::fuzz::require_trace_or_refusal(bytes, "fuzzed");
    const psicarve::fuzz::MemoryFile file(bytes);
    require(first_job(file.opened()) == first_job(psicarve::fuzz::in_pieces(bytes)),
            "a pipe's job is a file's");
    return 0;
}
