// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hmi/cli/checkpoint_text.hpp"
#include "hmi/cli/commands.hpp"
#include "hmi/cli/escaped_output.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/go_on_text.hpp"
#include "hmi/cli/known_profile.hpp"
#include "hmi/cli/motion_command.hpp"
#include "hmi/cli/program_sight.hpp"
#include "hmi/cli/program_text.hpp"
#include "hmi/cli/status_text.hpp"
#include "hmi/cli/unfinished_look.hpp"
#include "hmi/cli/unfinished_text.hpp"
#include "hmi/cli/watch_loop.hpp"
#include "hmi/machine/machine_link.hpp"
#include "hmi/report/message_json.hpp"
#include "hmi/report/status_json.hpp"
#include "shared/job/job.hpp"
#include "shared/machine/machine_state.hpp"
#include "shared/record/saved_checkpoint.hpp"
#include "shared/segment/segment.hpp"
#include "shared/segment/segment_program.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kStatusText{"status", "What the machine is doing",
                                  "Without a core, or with one that has no job, it also tells of a piece "
                                  "that is not finished and how it goes "
                                  "on.\n--watch shows it again and again until Ctrl-C: in place on a "
                                  "terminal, else a line for each change.",
                                  "psicarve status --watch"};

struct StatusOptions {
    bool watch = false;
    std::string state_folder;
};

/// The current pass of a running job, if it has several.
class RunningPass {
public:
    std::string name(machine::MachineLink& link, const CoreStatus& status) {
        if (!runs_job(status.state) || program_report(link.segment()).status.is_running != 0) return {};
        if (status.job_generation != generation_) look(link, status.job_generation);
        for (const JobPass& pass : passes_)
            if (status.layer - pass.first_layer < pass.layer_count) return pass_name(pass);
        return {};
    }

private:
    /// Copies the whole job, but once: as long as it runs no other can be published.
    void look(machine::MachineLink& link, std::uint64_t generation) {
        generation_ = generation;
        passes_.clear();
        const auto published = copy_current_job(link.segment(), kCopyLimit);
        if (!published || published->generation != generation) return;
        const auto job = JobView::check(published->blob);
        if (job && job->passes().size() > 1) passes_.assign(job->passes().begin(), job->passes().end());
    }

    static constexpr std::chrono::milliseconds kCopyLimit{500};
    std::uint64_t generation_ = 0;
    std::vector<JobPass> passes_;  ///< empty: the job has but one
};

std::string head_line(const machine::MachineLink& link) {
    return "segment    " + link.segment_name() + ", core pid " + std::to_string(link.core_pid().value_or(0)) +
           "\n";
}

/// Whether the disk's record of a living core is false, or may be.
bool is_disk_refusing(const machine::MachineLink& link) {
    return link.segment().core_keeping().how == CoreKeeping::How::refused;
}

/// A piece that was begun before this core, while this core has no other.
struct Unfinished {
    std::optional<FoundCheckpoint> found;
    WayBack way;
    bool is_silent = false;  ///< the disk does not answer: not known
};

/// Searches without ever waiting for a disk that hangs.
class UnfinishedPieces {
public:
    explicit UnfinishedPieces(const std::string& folder) : folder_(folder), look_(folder) {}

    Unfinished beside(machine::MachineLink& link, const CoreStatus& status,
                      std::chrono::milliseconds patience) {
        Unfinished unfinished;
        unfinished.way.segment = link.segment_name();
        unfinished.way.has_core = true;
        if (status.job_generation != 0) return unfinished;
        unfinished.found = look_.look(link.segment_name(), status.is_simulator != 0,
                                      link.segment().core_keeping(), patience);
        unfinished.is_silent = look_.is_silent();
        if (unfinished.found)
            unfinished.way.is_other_core =
                link.segment().header().core_profile_hash.load() != unfinished.found->saved.profile_hash;
        return unfinished;
    }
    /// Null: there is no segment either.
    Unfinished without_core(const machine::MachineLink* link, const std::string& segment) {
        Unfinished unfinished;
        unfinished.way.segment = segment;
        look_ = UnfinishedLook{folder_};  // the result from the core's lifetime is old
        unfinished.found = look_.look(segment, {}, {}, kDiskPatience);
        unfinished.is_silent = look_.is_silent();
        unfinished.way.is_published = link != nullptr && unfinished.found &&
                                      link->is_of_published_job(unfinished.found->saved.checkpoint);
        return unfinished;
    }

private:
    std::string folder_;
    UnfinishedLook look_;
};

std::string text_of(const Unfinished& unfinished) {
    if (unfinished.is_silent)
        return "unfinished not known: the disk that keeps unfinished pieces does not answer\n";
    return unfinished.found ? unfinished_text(*unfinished.found, unfinished.way) : std::string{};
}

/// Names of files and jobs may be in any letters.
std::string text_of(const nlohmann::ordered_json& object) {
    return object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

void put_into(nlohmann::ordered_json& object, const Unfinished& unfinished) {
    object["unfinished"] = unfinished_json(unfinished.found, unfinished.way);
    if (unfinished.is_silent) object["is_disk_silent"] = true;
}

/// A disk that does not answer may know of a run that has begun anew.
std::optional<GoOnPlace> place_beside(const machine::MachineLink* link, const Unfinished& unfinished) {
    return link == nullptr || unfinished.is_silent ? std::nullopt : place_to_go_on(*link, unfinished.found);
}

/// Reports first that there is no core, then the piece that it left unfinished.
Result<int> tell_without_core(const CommonOptions& common, const machine::MachineLink* link, Error error,
                              UnfinishedPieces& pieces) {
    // A silent core exists all the same.
    const bool is_gone = error.code == ErrorCode::no_core && (link == nullptr || !link->core_pid());
    if (!is_gone) return error;
    if (common.json) {
        const Unfinished unfinished = pieces.without_core(link, common.segment);
        const auto place = place_beside(link, unfinished);
        if (!unfinished.found && !unfinished.is_silent && !place) return error;
        print_error(error);
        nlohmann::ordered_json object;
        object["error"] = nlohmann::ordered_json::parse(error_json(error));
        put_into(object, unfinished);
        object["go_on"] = go_on_json(place);
        std::fputs((text_of(object) + "\n").c_str(), stdout);
        return exit_code_of(error.code);
    }
    print_error(error);
    const Unfinished unfinished = pieces.without_core(link, common.segment);
    std::fputs((go_on_text(place_beside(link, unfinished)) + text_of(unfinished)).c_str(), stdout);
    return exit_code_of(error.code);
}

std::string json_line(machine::MachineLink& link, const ProgramSight& sight, const std::string& pass,
                      const std::optional<Profile>& profile, const Unfinished& unfinished) {
    const CoreStatus& status = sight.machine;
    nlohmann::ordered_json object{{"segment", link.segment_name()},
                                  {"core_pid", link.core_pid().value_or(0)}};
    const auto checkpoint = link.checkpoint();
    object.update(
        report::status_json(status, profile ? report::TableSize::of(*profile) : report::TableSize{}));
    object["position"] = profile ? report::position_json(status, *profile) : nlohmann::ordered_json(nullptr);
    object["program"] = program_json(sight.program, status, profile ? &*profile : nullptr);
    object["last_program"] = last_program_json(sight.program);
    object["pass"] = pass.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(pass);
    object["checkpoint"] = checkpoint_json(checkpoint, checkpoint && link.is_of_published_job(*checkpoint));
    object["go_on"] = go_on_json(place_to_go_on(link, status));
    if (const auto remarks = current_remarks(link.job_remarks(), checkpoint); !remarks.empty()) {
        object["job_remark"] = in_words(remarks);
        auto messages = nlohmann::ordered_json::array();
        for (const Message& one : remarks) messages.push_back(report::message_json(one));
        object["job_remarks"] = messages;
    }
    if (is_disk_refusing(link)) object["is_disk_refusing"] = true;
    put_into(object, unfinished);
    return text_of(object) + "\n";
}

/// Adds a line about the state that the dead core left behind.
Error with_last_state(machine::MachineLink& link, Error error) {
    const auto last = link.last_status();
    if (!last || link.core_pid()) return error;
    error.message += "; the last one left it " + state_text(*last);
    const ProgramStatus program = program_report(link.segment()).status;
    if (program.is_running != 0) {
        error.message += " in line " + std::to_string(program.line) + " of its program";
    } else if (last->points_total > 0) {
        error.message +=
            " at layer " + std::to_string(last->layer) + ", point " + std::to_string(last->point);
    }
    return error;
}

Result<int> show_status(const CommonOptions& common, const StatusOptions& options) {
    auto known = KnownProfile::read(common);
    if (!known) return known.error();
    UnfinishedPieces pieces{options.state_folder};
    auto link = machine::MachineLink::attach(common.segment, common.group);
    if (!link) return tell_without_core(common, nullptr, link.error(), pieces);
    RunningPass running;
    const auto show = [&](bool as_line) -> Result<std::string> {
        const auto sight = told_sight(*link);
        if (!sight) return with_last_state(*link, sight.error());
        const CoreStatus& status = sight->machine;
        const ProgramReport& program = sight->program;
        const std::string pass = running.name(*link, status);
        const auto profile = known->of(*link);
        // A view that is refreshed soon does not wait for a disk, except once.
        const auto patience = options.watch ? std::chrono::milliseconds{0} : kDiskPatience;
        if (common.json)
            return json_line(*link, *sight, pass, profile, pieces.beside(*link, status, patience));
        if (as_line && program.status.is_running != 0)
            return state_text(status) + "; program " + named_place_text(program) + "\n";
        if (as_line) return status_line(status, pass);
        const auto checkpoint = link->checkpoint();
        std::string text = head_line(*link) + status_text(status, profile ? &*profile : nullptr, pass) +
                           program_text(program, status, profile ? &*profile : nullptr) +
                           checkpoint_text(checkpoint, checkpoint && link->is_of_published_job(*checkpoint));
        text += go_on_text(place_to_go_on(*link, status));
        if (const std::string remark = in_words(current_remarks(link->job_remarks(), checkpoint));
            !remark.empty())
            text += "mind       " + remark + "\n";
        if (is_disk_refusing(*link))
            text +=
                "mind       the disk does not take how far the piece has come: if the power fails, do not go "
                "on by it\n";
        if (!options.watch) {
            // The machine's status first: its disk may hang.
            std::fputs(std::exchange(text, {}).c_str(), stdout);
            if (const auto flushed = flush_output(); !flushed) return flushed.error();
        }
        return text + text_of(pieces.beside(*link, status, patience));
    };
    auto shown = show_or_watch(show, options.watch, common.json);
    return shown ? shown : tell_without_core(common, &*link, shown.error(), pieces);
}

}  // namespace

void add_status(CommandSet& commands) {
    const auto options = std::make_shared<StatusOptions>();
    commands
        .add(kStatusText, [options](const CommonOptions& common) { return show_status(common, *options); })
        .flag("--watch", options->watch, "Go on showing it until Ctrl-C")
        .option("--state", options->state_folder, "FOLDER",
                "Where the core keeps what is unfinished, if it was given --state");
}

}  // namespace psicarve::cli
