// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hmi/trace/trace_reader.hpp"
#include "shared/base/result.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/require.hpp"

namespace psicarve::fuzz {

/// All that a reader has said of a trace.
struct ReadTrace {
    verify::TraceStart start;
    std::vector<verify::TraceEvent> events;
    std::string refusal;  ///< empty: it came to its proper end
};

inline ReadTrace read_trace(int descriptor, const std::string& name) {
    ReadTrace read;
    const auto reader = verify::open_trace_fd(descriptor, name);
    require_one_line(reader);
    if (!reader) {
        read.refusal = reader.error().message;
        return read;
    }
    read.start = (*reader)->start();
    std::array<verify::TraceEvent, 64> batch{};
    std::int64_t last_ns = 0;
    for (;;) {
        const auto count = (*reader)->read(batch);
        require_one_line(count);
        if (!count) {
            read.refusal = count.error().message;
            return read;
        }
        require(*count <= batch.size(), "no more events than there is room for");
        if (*count == 0) return read;
        for (const verify::TraceEvent& event : std::span(batch).first(*count)) {
            require(event.time_ns >= last_ns, "times never fall");
            last_ns = event.time_ns;
            read.events.push_back(event);
        }
    }
}

/// The same bytes through a socket whose other end has written them in pieces: each is one read.
inline int in_pieces(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t kMostPieces = 60;
    std::array<int, 2> ends{};
    require(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) == 0,
            "the fuzzer gets a pipe");
    std::size_t length = bytes.size() / kMostPieces + 1;
    while (!bytes.empty()) {
        const auto piece = bytes.first(std::min(length, bytes.size()));
        const auto sent = ::send(ends[1], piece.data(), piece.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        require(sent == static_cast<ssize_t>(piece.size()), "the pipe takes a piece");
        bytes = bytes.subspan(piece.size());
        // Pieces of all lengths, so that each kind of record is divided somewhere.
        length = length % 7 == 0 ? length - 3 : length + 1;
    }
    ::close(ends[1]);
    return ends[0];
}

inline bool is_same(const verify::TraceEvent& a, const verify::TraceEvent& b) {
    return a.time_ns == b.time_ns && a.levels == b.levels && a.kind == b.kind &&
           a.position_pulses == b.position_pulses;
}

/// A trace is refused with one line, or it is read to its end; from a pipe as from a file.
inline void require_trace_or_refusal(std::span<const std::uint8_t> bytes, const std::string& name) {
    const MemoryFile on_disk(bytes);
    const ReadTrace whole = read_trace(on_disk.opened(), name);
    const ReadTrace divided = read_trace(in_pieces(bytes), name);
    require(whole.refusal == divided.refusal, "a pipe's trace is refused as a file's");
    require(whole.start.initial_levels == divided.start.initial_levels &&
                whole.start.present == divided.start.present &&
                whole.start.position_pulses == divided.start.position_pulses &&
                whole.start.crossed_pulses == divided.start.crossed_pulses &&
                whole.start.period_ns == divided.start.period_ns,
            "a pipe's trace begins as a file's");
    require(std::ranges::equal(whole.events, divided.events, &is_same), "a pipe's events are a file's");
}

}  // namespace psicarve::fuzz
