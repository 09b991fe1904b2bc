// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "hmi/gcode/machine_check.hpp"
#include "hmi/gcode/modes_trail.hpp"
#include "hmi/gcode/record_maker.hpp"

namespace psicarve::gcode {

/// Makes a program into records block by block. A block that the machine or the language has something
/// against gives none at all, and nothing behind it does. What a block comes to is held until all of it is
/// judged; of a block that may be long, that is rehearsed, nothing. So 100 000 pieces of one drawn way, and
/// what few records such a block has beside, are the most that is held.
///
///     block -> held -> end of the block, and nothing is wrong -> records
///     cycle -> rehearsal, and nothing is wrong -> the same block again -> records
class JudgedMotion : public CanonSink {
public:
    /// All outlive this. `offsets`: what the last block that was taken has set.
    JudgedMotion(const Profile& profile, ProblemList& problems, RecordMaker& maker, KeptOffsets& offsets,
                 ModesTrail& trail);

    void take(const CanonRecord& record) override;
    void begin_line(const ReachedLine& line) override { maker_.begin_line(line); }
    void end_block() override;
    void set_offsets(const KeptOffsets& kept) override;
    void set_modes(const ActiveModes& modes) override;
    bool wants_modes() const noexcept override { return true; }
    bool wants_more() const noexcept override { return !is_wrong() && maker_.wants_more(); }
    CanonSink* rehearsal() override;

private:
    /// Judges, and has nothing carried out.
    class Rehearsal : public CanonSink {
    public:
        explicit Rehearsal(JudgedMotion& motion) noexcept : motion_(motion) {}
        void take(const CanonRecord& record) override { (void)motion_.is_right(record); }
        bool wants_more() const noexcept override { return !motion_.is_wrong(); }

    private:
        JudgedMotion& motion_;
    };

    bool is_wrong() const noexcept { return problems_.error_count() > 0; }
    bool is_right(const CanonRecord& record);
    void give_held();
    void give(const CanonRecord& record);

    MachineCheck machine_;
    ProblemList& problems_;
    RecordMaker& maker_;
    KeptOffsets& offsets_;
    ModesTrail& trail_;
    Rehearsal rehearsal_{*this};
    bool is_rehearsed_ = false;  ///< the block, and it is right
    // Of the block:
    std::vector<CanonRecord> held_;
    std::vector<std::pair<std::size_t, ActiveModes>> held_modes_;  ///< from which of those on they hold
};

}  // namespace psicarve::gcode
