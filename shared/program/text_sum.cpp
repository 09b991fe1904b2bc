// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/program/text_sum.hpp"

#include <xxhash.h>

namespace psicarve {

struct TextSum::State {
    State() : hash(XXH3_createState()) { XXH3_64bits_reset(hash); }
    ~State() { XXH3_freeState(hash); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    XXH3_state_t* hash;
};

void TextSum::Deleter::operator()(State* state) const noexcept {
    delete state;
}

TextSum::TextSum() : state_(new State) {}

void TextSum::add(std::span<const char> part) {
    XXH3_64bits_update(state_->hash, part.data(), part.size());
    bytes_ += part.size();
}

std::uint64_t TextSum::value() const {
    return XXH3_64bits_digest(state_->hash);
}

}  // namespace psicarve
