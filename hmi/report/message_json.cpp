// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/message_json.hpp"

#include <nlohmann/json.hpp>

#include "shared/wording/wording.hpp"

namespace psicarve::report {
namespace {

nlohmann::ordered_json value_of(const Argument& argument, const std::string& words) {
    using K = ArgumentKind;
    switch (argument.kind) {
        case K::count:
        case K::layer:
        case K::point:
        case K::ms:
            return argument.bits;
        case K::pulses:
            return argument.signed_number();
        case K::mm:
        case K::mm_s:
        case K::deg_s:
            return argument.number();
        default:
            return words;
    }
}

}  // namespace

nlohmann::ordered_json message_json(const Message& message) {
    if (!is_sound(message)) return nullptr;
    const Wording& row = *wording_of(message.id);
    const std::vector<std::string> words = argument_words(message);
    auto arguments = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < words.size(); ++i)
        arguments[row.arguments[i].name] = value_of(message.arguments[i], words[i]);
    return {{"id", row.name}, {"arguments", arguments}};
}

}  // namespace psicarve::report
