// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/trace/trace_reader.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "hmi/trace/binary_reader.hpp"
#include "hmi/trace/byte_source.hpp"
#include "hmi/trace/vcd_reader.hpp"
#include "shared/trace/trace_format.hpp"

namespace psicarve::verify {

namespace {

bool begins_like_vcd(std::string_view bytes) {
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && bytes[first] == '$';
}

bool begins_like_binary(std::string_view bytes) {
    return bytes.size() >= sizeof kTraceMagic &&
           std::memcmp(bytes.data(), &kTraceMagic, sizeof kTraceMagic) == 0;
}

Result<std::unique_ptr<TraceReader>> open_source(ByteSource source) {
    auto wanted = source.want(sizeof kTraceMagic);
    if (!wanted) return wanted.error();
    const std::string_view bytes = source.unread();
    if (bytes.empty()) return source.bad_at(0, "the trace is empty");
    if (begins_like_binary(bytes)) return BinaryReader::open(std::move(source));
    if (begins_like_vcd(bytes) || source.name().ends_with(".vcd")) return VcdReader::open(std::move(source));
    return source.bad_at(0, "neither a value-change dump nor a binary pin trace");
}

}  // namespace

Result<std::unique_ptr<TraceReader>> open_trace(const std::string& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return bad_input(path + ": cannot open: " + std::generic_category().message(errno));
    return open_source(ByteSource(descriptor, path));
}

Result<std::unique_ptr<TraceReader>> open_trace_fd(int descriptor, const std::string& name) {
    return open_source(ByteSource(descriptor, name));
}

}  // namespace psicarve::verify
