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

/// Before the work: a wrong name, a folder that cannot be written. Empty: no preview.
Result<void> check_preview(const std::string& path);

/// What a model comes to before it is carved: its mesh, how it stands, the piece that is to be expected.
class ModelReport {
public:
    /// Of a job that was just sliced; without its mesh (a table) nothing is said of that. Outlived by the
    /// job.
    static Result<ModelReport> make(const PreparedJob& job);

    /// A line each, "name: what".
    std::vector<std::string> lines() const;
    std::string text() const;
    std::string json() const;
    /// Empty: none is wanted.
    Result<void> write_preview(const std::string& path) const;

private:
    ModelReport(const PreparedJob& job, piece::JobPiece expected)
        : job_(&job), expected_(std::move(expected)) {}

    const PreparedJob* job_;
    piece::JobPiece expected_;
    std::optional<report::ModelFindings> findings_;
};

}  // namespace psicarve::cli
