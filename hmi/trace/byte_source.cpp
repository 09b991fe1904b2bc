// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/trace/byte_source.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace psicarve::verify {

namespace {
constexpr std::size_t kBufferBytes = std::size_t{256} * 1024;
}

ByteSource::ByteSource(int descriptor, std::string name, std::uint64_t offset)
    : descriptor_(descriptor), name_(std::move(name)), buffer_(kBufferBytes), offset_of_buffer_(offset) {}

ByteSource::ByteSource(ByteSource&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      name_(std::move(other.name_)),
      buffer_(std::move(other.buffer_)),
      begin_(other.begin_),
      end_(other.end_),
      offset_of_buffer_(other.offset_of_buffer_),
      at_end_(other.at_end_) {}

ByteSource::~ByteSource() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

Result<bool> ByteSource::refill() {
    if (at_end_) return false;
    if (begin_ > 0) {
        std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
        offset_of_buffer_ += begin_;
        end_ -= begin_;
        begin_ = 0;
    }
    if (end_ == buffer_.size()) return bad_at(0, "a word of more than 256 KiB: not a pin trace");
    for (;;) {
        const ssize_t got = ::read(descriptor_, buffer_.data() + end_, buffer_.size() - end_);
        if (got > 0) {
            end_ += static_cast<std::size_t>(got);
            return true;
        }
        if (got == 0) {
            at_end_ = true;
            return false;
        }
        if (errno != EINTR) {
            const std::string why = std::generic_category().message(errno);
            return bad_at(end_ - begin_, "cannot read: " + why);
        }
    }
}

Result<void> ByteSource::want(std::size_t bytes) {
    while (unread().size() < bytes) {
        auto more = refill();
        if (!more) return more.error();
        if (!*more) break;
    }
    return {};
}

Error ByteSource::bad_at(std::size_t ahead, const std::string& text) const {
    return bad_input(name_ + ": byte " + std::to_string(offset() + ahead) + ": " + text);
}

}  // namespace psicarve::verify
