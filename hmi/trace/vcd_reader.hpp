// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "hmi/trace/byte_source.hpp"
#include "hmi/trace/trace_reader.hpp"
#include "hmi/trace/vcd_header.hpp"
#include "shared/base/result.hpp"

namespace psicarve::verify {

/// Reads a value-change dump (IEEE 1364, four-state) as our writer and other tools make it: any timescale and
/// scopes, vectors of one bit, x and z as 0. Finds wires by the signals' names. A wire that changes twice at
/// one instant keeps both changes. Its members: parts, and the state of one pass through the file, in which
/// each word may change any of it.
class VcdReader final : public TraceReader {
public:
    /// Waits for the declarations and the values at the first instant.
    static Result<std::unique_ptr<TraceReader>> open(ByteSource source);

    const TraceStart& start() const noexcept override { return start_; }
    const std::string& name() const noexcept override { return source_.name(); }
    Result<std::size_t> read(std::span<TraceEvent> events) override;

private:
    /// The meaning of the next word.
    enum class Expect { anything, comment, skipped_block, timescale, variable, vector_wire, real_wire };
    enum class Got { word, incomplete, end };

    explicit VcdReader(ByteSource source) : source_(std::move(source)) {}
    Result<void> read_opening();
    Result<void> check_wires() const;
    Got next_word(std::string_view& word);
    Result<bool> wait_for_word(std::string_view& word);

    Result<void> take_front(std::string_view word);
    Result<void> take(std::string_view word);
    Result<void> take_keyword(std::string_view word);
    Result<void> take_block_end();
    Result<void> take_time(std::string_view digits);
    Result<void> take_value(char value, std::string_view identifier);
    Result<void> take_comment();
    void flush_pins();
    void flush_end();
    void push(const TraceEvent& event);
    Error bad_word(const std::string& text) const;

    ByteSource source_;
    TraceStart start_;
    VcdWires wires_;
    VcdTimescale timescale_;
    Expect expect_ = Expect::anything;
    std::string block_;  ///< words of the block being read, bounded
    char vector_value_ = '0';
    bool declared_ = false;  ///< $enddefinitions was read
    bool opened_ = false;    ///< the first instant is over: changes are events
    bool has_time_ = false;
    std::int64_t time_ns_ = 0;
    SignalWord levels_ = 0;   ///< as of now
    SignalWord told_ = 0;     ///< as of the last event
    SignalWord changed_ = 0;  ///< wires that changed since then
    std::size_t word_bytes_ = 0;
    std::int64_t last_event_ns_ = 0;
    std::optional<Error> failure_;       ///< reported once the events before it are handed out
    std::array<TraceEvent, 4> pending_;  ///< events made but not yet handed out
    std::size_t pending_count_ = 0;
};

}  // namespace psicarve::verify
