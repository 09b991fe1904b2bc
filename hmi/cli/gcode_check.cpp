// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "hmi/cli/commands.hpp"
#include "hmi/cli/exit_code.hpp"
#include "hmi/cli/gcode_problems.hpp"
#include "hmi/cli/job_source.hpp"
#include "hmi/cli/run_offsets.hpp"
#include "hmi/gcode/canon_writer.hpp"
#include "hmi/gcode/machine_check.hpp"
#include "hmi/gcode/machine_options.hpp"
#include "hmi/gcode/program_check.hpp"

namespace psicarve::cli {
namespace {

constexpr CommandText kGcodeCheckText{
    "check", "Whether a program in G-code is right, and can be run on the machine",
    "All of a program is read, and everything that is wrong is told with "
    "line and column. Which\nletter moves which axis is in the profile's [gcode].",
    "psicarve gcode check pocket.ngc"};

struct GcodeCheckOptions {
    std::string path;
    std::string dialect = "ngc";
    bool prints_canon = false;
    bool leaves_out_machine = false;
    bool skips_deleted = false;
};

constexpr std::size_t kCanonPieceBytes = std::size_t{1} << 16U;

/// Sends motion to standard output and to the machine's check, as asked for.
class CheckedMotion : public gcode::CanonSink {
public:
    CheckedMotion(gcode::MachineCheck* machine, bool prints) : machine_(machine), prints_(prints) {}

    void take(const gcode::CanonRecord& record) override {
        if (machine_ != nullptr) machine_->take(record);
        if (!prints_) return;
        gcode::append_canon_line(record, text_);
        if (text_.size() >= kCanonPieceBytes) flush();
    }
    void flush() {
        std::fwrite(text_.data(), 1, text_.size(), stdout);
        text_.clear();
    }

private:
    gcode::MachineCheck* machine_;
    bool prints_;
    std::string text_;
};

Result<int> check(const CommonOptions& common, const GcodeCheckOptions& options) {
    const std::string name = program_name(options.path);
    gcode::InterpreterOptions how;
    gcode::ProblemList problems;
    std::unique_ptr<gcode::MachineCheck> machine;
    if (!options.leaves_out_machine) {
        const auto profile = chosen_profile(common);
        if (!profile) return profile.error();
        machine = std::make_unique<gcode::MachineCheck>(*profile, problems);
        how = gcode::machine_options(*profile);
        const auto offsets = kept_offsets(common, *profile);
        if (!offsets) return offsets.error();
        how.is_start_known = false;
        how.offsets = offsets->kept;
    }
    how.dialect = options.dialect == "iso" ? gcode::Dialect::iso : gcode::Dialect::ngc;
    how.skips_deleted = options.skips_deleted;
    how.ends_with_input = is_standard_input(options.path);
    auto bytes = gcode::open_program(options.path);
    if (!bytes) return bytes.error();
    gcode::LineSource lines{std::move(bytes).value()};
    CheckedMotion motion{machine.get(), options.prints_canon};
    const auto facts = gcode::interpret_program(lines, how, motion, problems);
    motion.flush();
    if (!facts) return facts.error();
    print_problems(name, problems);
    if (common.json) print_json_line(check_json(name, *facts, problems));
    if (problems.error_count() > 0) return kExitBadInput;
    if (!common.json && !options.prints_canon)
        std::printf("%s: OK, %s, %s\n", name.c_str(), count_text(facts->line_count, "line").c_str(),
                    count_text(facts->motion_count, "motion").c_str());
    return kExitDone;
}

}  // namespace

void add_gcode_check(CommandSet& commands) {
    const auto options = std::make_shared<GcodeCheckOptions>();
    commands.add(kGcodeCheckText, [options](const CommonOptions& common) { return check(common, *options); })
        .input("FILE", options->path, "A program in G-code")
        .flag("--canon", options->prints_canon, "Print canonical motion, one JSON object a line")
        .flag("--no-machine", options->leaves_out_machine, "Judge the language alone, with all letters")
        .flag("--block-delete", options->skips_deleted, "Leave out blocks that begin with /")
        .choice("--dialect", options->dialect, {"ngc", "iso"},
                "Where controls differ: with iso G70 and G71 are the units (default ngc)")
        .excludes("--canon", "--json");
}

}  // namespace psicarve::cli
