// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/port/port_address.hpp"

#include <charconv>
#include <cstdio>
#include <string_view>

namespace psicarve::port {
namespace {

constexpr std::string_view kPpdev = "ppdev:";
constexpr std::string_view kRaw = "io:";

Error bad_port(const std::string& text, const std::string& problem) {
    return Error{ErrorCode::bad_usage,
                 "--port " + text + ": " + problem + "; sim, ppdev:/dev/parport0 or io:0x378"};
}

Result<PortAddress> parse_raw(const std::string& text) {
    constexpr int kHexadecimal = 16;
    std::string_view digits = std::string_view{text}.substr(kRaw.size());
    const bool has_prefix = digits.starts_with("0x") || digits.starts_with("0X");
    if (has_prefix) digits.remove_prefix(2);
    PortAddress address;
    address.kind = PortKind::raw;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), address.base, kHexadecimal);
    if (!has_prefix || error != std::errc{} || end != digits.data() + digits.size()) {
        return bad_port(text, "not a hexadecimal address");
    }
    return address;
}

}  // namespace

Result<PortAddress> parse_port_address(const std::string& text) {
    if (text == "sim") return PortAddress{};
    if (text.starts_with(kRaw)) return parse_raw(text);
    if (!text.starts_with(kPpdev)) return bad_port(text, "no such kind of port");
    PortAddress address;
    address.kind = PortKind::ppdev;
    address.device = text.substr(kPpdev.size());
    if (!address.device.starts_with('/')) return bad_port(text, "not the path of a device");
    return address;
}

std::string port_text(const PortAddress& address) {
    if (address.kind == PortKind::simulated) return "sim";
    if (address.kind == PortKind::ppdev) return std::string{kPpdev} + address.device;
    char digits[8];
    std::snprintf(digits, sizeof digits, "0x%x", unsigned{address.base});
    return std::string{kRaw} + digits;
}

}  // namespace psicarve::port
