// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>

#include "shared/job/job.hpp"

namespace psicarve::report {

/// Writes a row for each point, with the header layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses;
/// for a job with passes also run (counted from 1 on), pass (its number), allowance_mm, depth_mm, clear_mm.
/// cam::job_from_table reads it back.
void write_csv(const JobView& job, std::FILE* out);

/// Writes one object: counts, joining, feed, profile, heights and both radius tables as arrays of layers; for
/// a spiral also the heights of its points.
void write_json(const JobView& job, std::FILE* out);

}  // namespace psicarve::report
