// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "hmi/trace/trace_reader.hpp"
#include "shared/base/result.hpp"

namespace psicarve::verify {

/// Maps the identifiers of a value-change dump to signals.
class VcdWires {
public:
    static constexpr std::int8_t kUndeclared = -2;
    static constexpr std::int8_t kNotOurs = -1;

    VcdWires() { short_.fill(kUndeclared); }
    /// The first wire with a signal's name counts; the same name in another scope belongs to another
    /// program's signal.
    void declare(std::string_view identifier, std::string_view name, std::string_view bits);
    /// The signal's number, kNotOurs or kUndeclared.
    std::int8_t find(std::string_view identifier) const noexcept {
        if (identifier.size() == 1) return short_[at(identifier[0])];
        if (identifier.size() == 2) return short_[kFirst + at(identifier[0]) * kFirst + at(identifier[1])];
        const auto found = long_.find(std::string(identifier));
        return found == long_.end() ? kUndeclared : found->second;
    }
    SignalWord present() const noexcept { return present_; }

private:
    static constexpr std::size_t kFirst = 256;
    static std::size_t at(char c) noexcept { return static_cast<unsigned char>(c); }

    std::array<std::int8_t, kFirst + kFirst * kFirst> short_{};  ///< by the one or two characters
    std::unordered_map<std::string, std::int8_t> long_;
    SignalWord present_ = 0;
};

/// Converts the file's unit of time to ns, in whole numbers.
struct VcdTimescale {
    std::int64_t multiply = 1;
    std::int64_t divide = 1;

    /// "1 ns", "10us", "100 ps" and their like.
    static std::optional<VcdTimescale> from_text(std::string_view text);
    /// Nothing when the time does not fit.
    std::optional<std::int64_t> to_ns(std::uint64_t time) const noexcept;
};

/// The content of a comment that our writer made; other comments have none.
struct VcdComment {
    std::optional<std::array<std::int64_t, kAxisCount>> position_pulses;
    std::optional<std::array<std::int64_t, kAxisCount>> crossed_pulses;
    std::optional<std::int64_t> period_ns;
    bool is_damaged = false;  ///< it is to give crossed_pulses, and does not

    static VcdComment from_text(std::string_view text);
};

}  // namespace psicarve::verify
