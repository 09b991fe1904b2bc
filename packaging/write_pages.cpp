// SPDX-License-Identifier: GPL-3.0-or-later
// Run by the build: writes man pages and completion of all programs into a folder, each from the table that
// its
// --help comes from.
//   psicarve-write-pages FOLDER VERSION DATE
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "hmi/cli/command_table.hpp"
#include "hmi/cli/program.hpp"
#include "hmi/manual/man_page.hpp"
#include "hmi/manual/shell_completion.hpp"
#include "hmi/manual/window_table.hpp"
#include "rtcore/options/options.hpp"

namespace psicarve {
namespace {

namespace fs = std::filesystem;
using manual::CommandTable;
using manual::PlacedCommand;

void write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream file{path, std::ios::binary};
    file << text;
    if (!file.flush()) throw std::runtime_error{path.string() + ": cannot be written"};
}

CommandTable core_table() {
    CommandTable table;
    supervisor::show_command_line([&table](const CLI::App& app) { table = cli::table_of(app); });
    return table;
}

/// The pages above a command, and those below; of the program the other programs and the profile.
std::vector<std::string> related(const PlacedCommand& command) {
    std::vector<std::string> also;
    std::vector<std::string> words = command.words;
    if (words.size() == 1) {
        for (const char* const other : {"psicarve(1)", "psicarve-hmi(1)", "psicarve-rtcore(1)"})
            if (other != words.front() + "(1)") also.emplace_back(other);
    } else {
        words.pop_back();
        also.push_back(manual::page_name(words) + "(1)");
        words = command.words;
    }
    for (const CommandTable& below : command.table->commands) {
        words.push_back(below.name);
        also.push_back(manual::page_name(words) + "(1)");
        words.pop_back();
    }
    also.emplace_back("psicarve-profile(5)");
    return also;
}

void write_program(const fs::path& folder, const CommandTable& program, const manual::Edition& edition) {
    for (const PlacedCommand& command : manual::all_commands(program)) {
        // What a program's exit codes mean holds for each of its commands.
        CommandTable table = *command.table;
        table.exit_codes = program.exit_codes;
        write(folder / "man1" / (manual::page_name(command.words) + ".1"),
              manual::man_page({command.words, &table}, related(command), edition));
    }
    write(folder / "bash" / program.name, manual::bash_completion(program));
    write(folder / "zsh" / ("_" + program.name), manual::zsh_completion(program));
    write(folder / "fish" / (program.name + ".fish"), manual::fish_completion(program));
}

void write_all(const fs::path& folder, const manual::Edition& edition) {
    // A command that is no more leaves no page behind.
    fs::remove_all(folder);
    write_program(folder, cli::program_table(), edition);
    write_program(folder, core_table(), edition);
    write_program(folder, manual::window_table(), edition);
    write(folder / "man5" / "psicarve-profile.5", manual::profile_page(edition));
}

}  // namespace
}  // namespace psicarve

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr, "usage: %s FOLDER VERSION DATE\n", argv[0]);
        return 2;
    }
    try {
        psicarve::write_all(argv[1], {argv[2], argv[3]});
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
        return 1;
    }
}
