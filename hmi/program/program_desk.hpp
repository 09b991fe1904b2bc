// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "hmi/program/decoding.hpp"
#include "hmi/program/program_lock.hpp"
#include "hmi/program/program_process.hpp"
#include "hmi/program/text_window.hpp"
#include "hmi/session/machine_view.hpp"
#include "hmi/session/message_log.hpp"

namespace psicarve::program {

/// The program that is open in a window: read, judged, started, watched. Outlives the views that show it. One
/// owner's thread. Its members: parts (decoder, text, process), and what was started last.
class ProgramDesk {
public:
    static constexpr std::size_t kMostBlocks = 100;  ///< typed ones that are remembered

    ProgramDesk(session::MessageLog& log, std::string segment_name, std::string group, RunFiles files)
        : log_(log),
          segment_name_(std::move(segment_name)),
          group_(std::move(group)),
          process_(std::move(files)) {}

    /// Reads and judges it. A failure becomes a message and problem().
    void open(const std::string& path, const session::MachineView& machine, const Profile& profile);
    /// The same file once more. Requires a path.
    void decode_again(const session::MachineView& machine, const Profile& profile);
    void cancel();
    /// A look at what is under way, and at the program that the core has. Call it at screen rate.
    void poll(const ProgramReport& report);

    const std::string& path() const noexcept { return path_; }
    bool is_reading() const noexcept { return decoder_.is_under_way(); }
    double progress_ratio() const noexcept { return decoder_.progress_ratio(); }
    /// Null: none was read.
    const DecodedPointer& program() const noexcept { return program_; }
    TextWindow& text() noexcept { return text_; }
    const TextWindow& text() const noexcept { return text_; }
    /// Why the file could not be read; empty: it could.
    const session::Phrase& problem() const noexcept { return problem_; }
    /// Grows with every change of the program and its runs; with other lines that are read.
    std::uint64_t edition() const noexcept { return edition_; }
    std::uint64_t text_edition() const noexcept { return text_edition_; }

    RunSwitches switches;         ///< of the next start
    bool asks_for_start = false;  ///< what a run from a line does first is told, and waits to be confirmed
    std::string typed;            ///< a block that was not asked for yet
    std::uint8_t plane = 0;       ///< of the path that is shown

    /// Requires that start_lock() has nothing against it. Where one is under way nothing happens.
    void start(const session::MachineView& machine);
    /// Ends what is under way as long as the core does not run it.
    void give_up(const ProgramReport& report);
    /// The command was started and has not ended.
    bool has_process() const noexcept { return process_.pid() != 0; }
    /// Under way, and the core does not run it yet, or no more.
    bool is_on_its_way(const ProgramReport& report) const noexcept {
        return is_under_way() && !(report.status.is_running != 0 && report.writer_pid == process_.pid());
    }
    /// Starts a program of this block alone. Requires that machine_lock() has nothing against it.
    void run_block(const std::string& block, const session::MachineView& machine);
    bool is_under_way() const noexcept { return process_.state() != ProgramProcess::State::none; }
    /// The program that runs, or ran last, is the file that was started here.
    bool is_ours(const ProgramStatus& status) const noexcept {
        return status.program != 0 && status.program == own_program_ && !is_block_;
    }
    /// The same, and it is the text that is shown.
    bool is_shown(const ProgramStatus& status) const noexcept {
        return is_ours(status) && program_ && program_->state == started_.state &&
               program_->request.path == started_.path;
    }
    /// Name of the file that was started last.
    std::string started_name() const;
    /// What the program that is under way was started with, else those of the next start.
    const RunSwitches& shown_switches() const noexcept {
        return is_under_way() && !is_block_ ? started_.switches : switches;
    }
    bool is_block() const noexcept { return is_block_; }
    /// How the last one ended; nothing: none has, or another was started since.
    const std::optional<ProgramProcess::Ended>& ended() const noexcept { return ended_; }
    /// Oldest first.
    const std::deque<std::string>& blocks() const noexcept { return blocks_; }

private:
    void begin_decode(const session::MachineView& machine, const Profile& profile);
    void tell_end();
    void forget_last_run();
    RunRequest request() const;

    /// The file that was started last.
    struct Started {
        std::string path;
        gcode::FileState state;
        RunSwitches switches;
    };

    session::MessageLog& log_;
    std::string segment_name_;
    std::string group_;
    std::string path_;
    Decoder decoder_;
    DecodedPointer program_;
    TextWindow text_;
    session::Phrase problem_;
    std::uint64_t edition_ = 0;
    std::uint64_t text_edition_ = 0;
    ProgramProcess process_;
    Started started_;
    std::uint64_t own_program_ = 0;  ///< number of what was started last; 0: it has none yet
    bool is_block_ = false;          ///< what was started last is a typed block
    std::optional<ProgramProcess::Ended> ended_;
    std::deque<std::string> blocks_;
};

}  // namespace psicarve::program
