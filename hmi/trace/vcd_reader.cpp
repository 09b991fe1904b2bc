// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/trace/vcd_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <utility>

namespace psicarve::verify {

namespace {

constexpr std::size_t kLongestBlock = 512;  // of a comment or declaration that can matter to us

constexpr bool is_space(char c) {
    return static_cast<unsigned char>(c) <= ' ';
}

}  // namespace

Result<std::unique_ptr<TraceReader>> VcdReader::open(ByteSource source) {
    std::unique_ptr<VcdReader> reader(new VcdReader(std::move(source)));
    auto opening = reader->read_opening();
    if (!opening) return opening.error();
    return std::unique_ptr<TraceReader>(std::move(reader));
}

Error VcdReader::bad_word(const std::string& text) const {
    return source_.bad_at(0, text);
}

Result<void> VcdReader::check_wires() const {
    std::string missing;
    const SignalWord needed = kStepMask | kDirMask;
    for (std::size_t bit = 0; bit < kSignalCount; ++bit) {
        const auto signal = static_cast<Signal>(bit);
        if ((needed & bit_of(signal)) == 0 || (wires_.present() & bit_of(signal)) != 0) continue;
        if (!missing.empty()) missing += ", ";
        missing += name_of(signal);
    }
    if (missing.empty()) return {};
    return bad_input(source_.name() + ": the trace has no wire named " + missing +
                     "; step and direction of every axis are needed");
}

VcdReader::Got VcdReader::next_word(std::string_view& word) {
    const std::string_view bytes = source_.unread();
    std::size_t begin = 0;
    while (begin < bytes.size() && is_space(bytes[begin])) ++begin;
    std::size_t end = begin;
    while (end < bytes.size() && !is_space(bytes[end])) ++end;
    source_.consume(begin);
    if (end == bytes.size() && !source_.at_end()) return Got::incomplete;
    if (begin == end) return Got::end;
    word = bytes.substr(begin, end - begin);
    word_bytes_ = end - begin;
    return Got::word;
}

/// False at the end of the file.
Result<bool> VcdReader::wait_for_word(std::string_view& word) {
    for (;;) {
        const Got got = next_word(word);
        if (got != Got::incomplete) return got == Got::word;
        auto more = source_.refill();
        if (!more) return more.error();
    }
}

/// Reads up to where the values at the first instant are known: the end of $dumpvars, or the second time.
Result<void> VcdReader::read_opening() {
    while (!opened_) {
        std::string_view word;
        auto got = wait_for_word(word);
        if (!got) return got.error();
        if (!*got) break;
        auto taken = take_front(word);
        if (!taken) return taken;
    }
    if (!declared_) return bad_word("the dump ends before $enddefinitions");
    if (!opened_) {
        start_.initial_levels = told_ = levels_;
        opened_ = true;
    }
    start_.present = wires_.present();
    return {};
}

Result<std::size_t> VcdReader::read(std::span<TraceEvent> events) {
    std::size_t count = 0;
    while (count < events.size()) {
        if (pending_count_ > 0) {
            const std::size_t handed = std::min(pending_count_, events.size() - count);
            std::copy_n(pending_.begin(), handed, events.begin() + static_cast<std::ptrdiff_t>(count));
            std::copy(pending_.begin() + handed, pending_.begin() + pending_count_, pending_.begin());
            pending_count_ -= handed;
            count += handed;
            continue;
        }
        if (failure_ && count > 0) break;
        if (failure_) return *failure_;
        std::string_view word;
        const Got got = next_word(word);
        if (got == Got::word) {
            auto taken = take_front(word);
            if (!taken) failure_ = taken.error();
        } else if (got == Got::end) {
            if (expect_ != Expect::anything)
                failure_ = bad_word("the dump is cut off inside a block or a value");
            else
                flush_end();
            if (pending_count_ == 0 && !failure_) break;
        } else {
            if (count > 0) break;
            auto more = source_.refill();
            if (!more) return more.error();
        }
    }
    return count;
}

/// Takes the word at the source's front and consumes it.
Result<void> VcdReader::take_front(std::string_view word) {
    auto taken = take(word);
    // White space follows every word of a whole dump except the last one, which then makes sense.
    const bool is_cut_off = !taken && source_.at_end() && source_.unread().size() == word_bytes_;
    if (is_cut_off) taken = source_.bad_at(word_bytes_, "the dump is cut off inside its last word");
    source_.consume(word_bytes_);
    word_bytes_ = 0;
    return taken;
}

Result<void> VcdReader::take(std::string_view word) {
    switch (expect_) {
        case Expect::anything:
            break;
        case Expect::vector_wire:
            expect_ = Expect::anything;
            return take_value(vector_value_, word);
        case Expect::real_wire:
            expect_ = Expect::anything;
            return {};
        default:
            if (word == "$end") return take_block_end();
            if (block_.size() + word.size() < kLongestBlock) block_.append(word).push_back(' ');
            return {};
    }
    switch (word[0]) {
        case '#':
            return take_time(word.substr(1));
        case '$':
            return take_keyword(word);
        case '0':
        case '1':
        case 'x':
        case 'X':
        case 'z':
        case 'Z':
            return take_value(word[0], word.substr(1));
        case 'b':
        case 'B':
            if (word.size() < 2) return bad_word("a vector without a value");
            vector_value_ = word.back();
            expect_ = Expect::vector_wire;
            return {};
        case 'r':
        case 'R':
        case 's':
        case 'S':
            expect_ = Expect::real_wire;
            return {};
        default:
            return bad_word("\"" + std::string(word.substr(0, 20)) + "\" is no part of a value-change dump");
    }
}

Result<void> VcdReader::take_keyword(std::string_view word) {
    if (word == "$dumpvars" || word == "$dumpon" || word == "$dumpoff" || word == "$dumpall") return {};
    if (word == "$end") {
        // Only $dumpvars and its kin get here: the first instant's values are complete.
        if (declared_ && !opened_ && has_time_) {
            start_.initial_levels = told_ = levels_;
            changed_ = 0;
            opened_ = true;
        }
        return {};
    }
    block_.clear();
    if (word == "$comment") {
        expect_ = Expect::comment;
    } else if (word == "$timescale") {
        expect_ = Expect::timescale;
    } else if (word == "$var") {
        expect_ = Expect::variable;
    } else {
        if (word == "$enddefinitions") declared_ = true;
        expect_ = Expect::skipped_block;
    }
    return {};
}

Result<void> VcdReader::take_block_end() {
    const Expect block = std::exchange(expect_, Expect::anything);
    if (block == Expect::comment) return take_comment();
    if (block == Expect::timescale) {
        const auto timescale = VcdTimescale::from_text(block_);
        if (!timescale)
            return bad_word("timescale " + block_ + "is not 1, 10 or 100 of s, ms, us, ns, ps, fs");
        timescale_ = *timescale;
    }
    if (block == Expect::variable) {
        // type bits identifier name [range]
        std::array<std::string_view, 4> fields;
        std::string_view rest = block_;
        for (std::string_view& field : fields) {
            const std::size_t end = rest.find(' ');
            if (end == std::string_view::npos)
                return bad_word("a $var without type, size, identifier and name");
            field = rest.substr(0, end);
            rest.remove_prefix(end + 1);
        }
        wires_.declare(fields[2], fields[3], fields[1]);
    }
    return declared_ && block == Expect::skipped_block && !opened_ ? check_wires() : Result<void>{};
}

Result<void> VcdReader::take_time(std::string_view digits) {
    if (!declared_) return bad_word("a time before $enddefinitions");
    std::uint64_t time = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), time);
    if (error != std::errc{} || end != digits.data() + digits.size() || digits.empty())
        return bad_word("#" + std::string(digits.substr(0, 20)) + " is no time");
    const auto time_ns = timescale_.to_ns(time);
    if (!time_ns) return bad_word("a time beyond all bounds");
    if (has_time_ && *time_ns < time_ns_) return bad_word("time runs backwards");
    if (has_time_ && *time_ns > time_ns_) {
        if (!opened_) {
            start_.initial_levels = told_ = levels_;
            changed_ = 0;
            opened_ = true;
        }
        flush_pins();
    }
    time_ns_ = *time_ns;
    has_time_ = true;
    return {};
}

Result<void> VcdReader::take_value(char value, std::string_view identifier) {
    if (identifier.empty()) return bad_word("a value without a wire");
    const std::int8_t wire = wires_.find(identifier);
    if (wire == VcdWires::kUndeclared)
        return bad_word("wire \"" + std::string(identifier.substr(0, 20)) + "\" was never declared");
    if (wire < 0) return {};
    const SignalWord bit = SignalWord{1} << static_cast<unsigned>(wire);
    const SignalWord levels = value == '1' ? levels_ | bit : levels_ & ~bit;
    if (levels == levels_) return {};
    if (opened_ && (changed_ & bit) != 0) flush_pins();
    levels_ = levels;
    changed_ |= bit;
    return {};
}

Result<void> VcdReader::take_comment() {
    const VcdComment comment = VcdComment::from_text(block_);
    if (comment.period_ns && !opened_) start_.period_ns = *comment.period_ns;
    if (comment.is_damaged && !opened_) return bad_word("crossed_pulses are not four counts from 0 on");
    if (comment.crossed_pulses && !opened_) start_.crossed_pulses = *comment.crossed_pulses;
    if (!comment.position_pulses) return {};
    if (!opened_) {
        start_.position_pulses = *comment.position_pulses;
        start_.has_positions = true;
        return {};
    }
    flush_pins();
    push({.time_ns = time_ns_,
          .levels = levels_,
          .kind = TraceEvent::Kind::position,
          .position_pulses = *comment.position_pulses});
    return {};
}

void VcdReader::flush_pins() {
    changed_ = 0;
    if (levels_ == told_) return;
    told_ = levels_;
    push({.time_ns = time_ns_, .levels = levels_, .kind = TraceEvent::Kind::pins, .position_pulses = {}});
}

/// A last event without a change, where the dump's last time lies behind its last change.
void VcdReader::flush_end() {
    flush_pins();
    if (pending_count_ == 0 && time_ns_ > last_event_ns_)
        push({.time_ns = time_ns_, .levels = levels_, .kind = TraceEvent::Kind::pins, .position_pulses = {}});
}

void VcdReader::push(const TraceEvent& event) {
    last_event_ns_ = event.time_ns;
    pending_[pending_count_++] = event;
}

}  // namespace psicarve::verify
