// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/line_source.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

namespace psicarve::gcode {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 16U;
/// A longer line belongs to no program, however wrong: the endless bytes of a device.
constexpr std::size_t kHopelessLineBytes = std::size_t{1} << 26U;

/// A file's descriptor, closed at the end.
class OpenProgram {
public:
    explicit OpenProgram(int descriptor) noexcept : descriptor_(descriptor) {}
    ~OpenProgram() {
        if (descriptor_ >= 0) close(descriptor_);
    }
    OpenProgram(const OpenProgram&) = delete;
    OpenProgram& operator=(const OpenProgram&) = delete;

    int descriptor() const noexcept { return descriptor_; }

private:
    int descriptor_;
};

FileState state_from(const struct stat& facts) noexcept {
    constexpr std::int64_t kNsPerSecond = 1'000'000'000;
    const auto ns_of = [](const timespec& time) { return time.tv_sec * kNsPerSecond + time.tv_nsec; };
    return {facts.st_dev, facts.st_ino, facts.st_size, ns_of(facts.st_mtim), ns_of(facts.st_ctim)};
}

Error wrong_program(const std::string& path) {
    return bad_input(path + ": cannot be read: " + std::strerror(errno));
}

ByteSource bytes_of(const std::shared_ptr<OpenProgram>& program, const std::string& path) {
    return [program, path](std::span<char> room) -> Result<std::size_t> {
        for (;;) {
            const ssize_t got = read(program->descriptor(), room.data(), room.size());
            if (got >= 0) return static_cast<std::size_t>(got);
            if (errno != EINTR) return wrong_program(path);
        }
    };
}

ByteSeek seek_of(const std::shared_ptr<OpenProgram>& program, const std::string& path) {
    return [program, path](std::uint64_t offset) -> Result<void> {
        if (lseek(program->descriptor(), static_cast<off_t>(offset), SEEK_SET) < 0)
            return wrong_program(path);
        return {};
    };
}

}  // namespace

LineSource::LineSource(ProgramBytes bytes) : bytes_(std::move(bytes)), buffer_(kBufferBytes, '\0') {}

Result<bool> LineSource::fill() {
    const auto got = bytes_.read(std::span<char>{buffer_.data(), buffer_.size()});
    if (!got) return got.error();
    begin_ = 0;
    end_ = *got;
    return *got > 0;
}

bool LineSource::can_go_to(const LinePlace& place) const noexcept {
    return bytes_.seek != nullptr || place.offset == read_to_ || kept_.holds(place.offset);
}

Result<void> LineSource::go_to(const LinePlace& place) {
    number_ = place.line;
    if (bytes_.seek != nullptr && place.offset != offset_) {
        // Most loops lie in what has just been read.
        const std::uint64_t buffer_offset = offset_ - begin_;
        if (place.offset >= buffer_offset && place.offset - buffer_offset <= end_) {
            begin_ = place.offset - buffer_offset;
        } else {
            if (const auto found = bytes_.seek(place.offset); !found) return found.error();
            begin_ = end_ = 0;
        }
    }
    offset_ = place.offset;
    return {};
}

void LineSource::hold() {
    if (bytes_.seek != nullptr) return;
    if (holds_++ == 0 && offset_ == read_to_) kept_.begin(offset_);
}

void LineSource::release() {
    if (bytes_.seek != nullptr) return;
    if (--holds_ == 0) kept_.drop();
}

void LineSource::keep_for_good() {
    kept_.keep_for_good();
}

Result<bool> LineSource::next(std::string_view& line) {
    if (bytes_.seek == nullptr && offset_ != read_to_) {
        if (!kept_.holds(offset_)) return false;
        line = kept_.line_at(offset_);
        has_line_feed_ = true;
        offset_ += line.size() + 1;
        ++number_;
        return true;
    }
    const auto got = next_of_bytes(line);
    if (bytes_.seek == nullptr && got && *got) {
        if (holds_ > 0) kept_.append(offset_, line);
        offset_ += line.size() + 1;
        read_to_ = offset_;
    }
    return got;
}

Result<bool> LineSource::next_of_bytes(std::string_view& line) {
    joined_.clear();
    has_line_feed_ = true;
    bool has_some = false;
    std::size_t line_bytes = 0;
    for (;;) {
        if (begin_ == end_) {
            const auto filled = fill();
            if (!filled) return filled.error();
            if (!*filled) {
                if (!has_some) return false;
                has_line_feed_ = false;
                break;
            }
        }
        has_some = true;
        const std::string_view rest{buffer_.data() + begin_, end_ - begin_};
        const std::size_t length = rest.find('\n');
        const std::string_view piece = rest.substr(0, length);
        begin_ += piece.size();
        line_bytes += piece.size();
        if (line_bytes > kHopelessLineBytes)
            return bad_input("line " + std::to_string(number_ + 1) +
                             " has more than 64 MiB: this is no program in G-code");
        if (length != std::string_view::npos) ++begin_;
        if (bytes_.seek != nullptr) offset_ += piece.size() + (length != std::string_view::npos ? 1 : 0);
        if (length != std::string_view::npos && joined_.empty()) {
            ++number_;
            line = piece.substr(0, kMostLineBytes + 1);
            return true;
        }
        const std::size_t room = kMostLineBytes + 1 - joined_.size();
        joined_.append(piece.substr(0, room));
        if (length != std::string_view::npos) break;
    }
    ++number_;
    line = joined_;
    return true;
}

Result<ProgramBytes> open_program(const std::string& path) {
    const auto program = std::make_shared<OpenProgram>(open(path.c_str(), O_RDONLY | O_CLOEXEC));
    struct stat facts {};
    if (program->descriptor() < 0 || fstat(program->descriptor(), &facts) != 0) return wrong_program(path);
    if (S_ISDIR(facts.st_mode)) return bad_input(path + ": is a folder; name a program");
    return ProgramBytes{bytes_of(program, path),
                        S_ISREG(facts.st_mode) ? seek_of(program, path) : ByteSeek{}};
}

Result<ProgramBytes> open_stream(int descriptor) {
    const std::string name = "standard input";
    const auto program = std::make_shared<OpenProgram>(fcntl(descriptor, F_DUPFD_CLOEXEC, 0));
    struct stat facts {};
    if (program->descriptor() < 0 || fstat(program->descriptor(), &facts) != 0) return wrong_program(name);
    if (S_ISDIR(facts.st_mode)) return bad_input(name + ": is a folder; name a program");
    return ProgramBytes{bytes_of(program, name), ByteSeek{}};
}

Result<FileState> state_of_program(const std::string& path) {
    struct stat facts {};
    if (stat(path.c_str(), &facts) != 0) return wrong_program(path);
    if (S_ISDIR(facts.st_mode)) return bad_input(path + ": is a folder; name a program");
    if (!S_ISREG(facts.st_mode))
        return bad_input(path + ": is no regular file, and is read twice; give it as standard input: -");
    return state_from(facts);
}

Result<ProgramBytes> open_unchanged_program(const std::string& path, const FileState& state) {
    const auto program = std::make_shared<OpenProgram>(open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (program->descriptor() < 0) return wrong_program(path);
    ByteSource bytes{[program, path, state](std::span<char> room) -> Result<std::size_t> {
        const ssize_t got = read(program->descriptor(), room.data(), room.size());
        if (got < 0) return wrong_program(path);
        // Looked at afterwards: what was read before a change is what was checked.
        struct stat facts {};
        if (fstat(program->descriptor(), &facts) != 0) return wrong_program(path);
        if (state_from(facts) != state)
            return bad_input(path + ": has been changed while it is run; what was read of it before is run");
        return static_cast<std::size_t>(got);
    }};
    return ProgramBytes{std::move(bytes), seek_of(program, path)};
}

}  // namespace psicarve::gcode
