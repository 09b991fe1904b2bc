// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hmi/cli/job_source.hpp"
#include "hmi/piece/job_piece.hpp"
#include "hmi/report/model_findings.hpp"
#include "shared/base/result.hpp"

namespace psicarve::cli {

/// Before the work: refuses a wrong name, or a folder that cannot be written. Empty: no preview.
Result<void> check_preview(const std::string& path);

/// The report of a model before it is carved: its mesh, its place, the expected piece.
class ModelReport {
public:
    /// Made of a job that was just sliced; without its mesh (a table) that part is left out. The job outlives
    /// it.
    static Result<ModelReport> make(const PreparedJob& job);

    /// A line each, "name: what".
    std::vector<std::string> lines() const;
    std::string text() const;
    std::string json() const;
    /// Empty: writes none.
    Result<void> write_preview(const std::string& path) const;

private:
    ModelReport(const PreparedJob& job, piece::JobPiece expected)
        : job_(&job), expected_(std::move(expected)) {}

    const PreparedJob* job_;
    piece::JobPiece expected_;
    std::optional<report::ModelFindings> findings_;
};

}  // namespace psicarve::cli
