// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/record/snapshot_file.hpp"

#include <gmock/gmock.h>
#include <grp.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/shared/segment_fixture.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve {
namespace {

using testing::HasSubstr;
using Bytes = std::vector<std::byte>;

Snapshot full_snapshot() {
    Snapshot snapshot;
    snapshot.status.emplace();
    std::memset(static_cast<void*>(&*snapshot.status), 0, sizeof(CoreStatus));
    snapshot.status->tick = 4711;
    for (std::uint64_t tick = 0; tick < 3; ++tick) {
        FlightRecord record{};
        record.tick = tick;
        snapshot.records.push_back(record);
    }
    snapshot.job_blob = test::make_job(5);
    snapshot.capacity_layers = 4000;
    snapshot.capacity_points = 3600;
    snapshot.generation = 8;
    return snapshot;
}

Snapshot job_only() {
    Snapshot snapshot;
    snapshot.job_blob = test::make_job(5);
    return snapshot;
}

void fix_checksum(Bytes& bytes) {
    const std::uint64_t checksum = snapshot_checksum(bytes);
    std::memcpy(bytes.data() + offsetof(SnapshotHeader, checksum), &checksum, sizeof(checksum));
}

template <typename T>
void put(Bytes& bytes, std::size_t offset, T value) {
    std::memcpy(bytes.data() + offset, &value, sizeof(value));
    fix_checksum(bytes);
}

std::string refusal_of(const Bytes& bytes) {
    const auto parsed = parse_snapshot(bytes, "job.psi");
    if (parsed) return "was not refused";
    EXPECT_EQ(parsed.error().code, ErrorCode::bad_input);
    EXPECT_THAT(parsed.error().message, testing::StartsWith("job.psi: "));
    return parsed.error().message;
}

TEST(SnapshotFile, GivesBackEverythingThatWasSaved) {
    const test::TemporaryFolder folder;
    const Snapshot saved = full_snapshot();
    ASSERT_TRUE(save_snapshot(saved, folder.path("s.psi")).has_value());

    const auto loaded = load_snapshot(folder.path("s.psi"));

    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    ASSERT_TRUE(loaded->status.has_value());
    EXPECT_EQ(std::memcmp(&*loaded->status, &*saved.status, sizeof(CoreStatus)), 0);
    ASSERT_EQ(loaded->records.size(), 3U);
    EXPECT_EQ(loaded->records[2].tick, 2U);
    EXPECT_EQ(loaded->job_blob, saved.job_blob);
    EXPECT_EQ(loaded->capacity_points, 3600U);
    EXPECT_EQ(loaded->generation, 8U);
}

Snapshot snapshot_with_source(const std::string& profile) {
    Snapshot snapshot = full_snapshot();
    auto source = std::make_shared<RecordedSource>();
    source->taken = 17;
    source->record_sum = 99;
    source->source.program = 4;
    source->source.kept[3] = 1.5;
    source->source.profile_bytes = static_cast<std::uint32_t>(profile.size());
    profile.copy(source->source.profile, profile.size());
    snapshot.source = std::move(source);
    return snapshot;
}

TEST(SnapshotFile, KeepsTheSourceOfAProgramAsFarAsItsProfileGoes) {
    for (const std::string& profile :
         {std::string{}, std::string{"name"}, std::string(kSourceProfileBytes, 'x')}) {
        const Snapshot saved = snapshot_with_source(profile);
        const Bytes bytes = snapshot_bytes(saved);
        const auto parsed = parse_snapshot(bytes, "s.psi");
        ASSERT_TRUE(parsed.has_value()) << parsed.error().message;
        ASSERT_NE(parsed->source, nullptr);
        EXPECT_EQ(std::memcmp(parsed->source.get(), saved.source.get(), sizeof(RecordedSource)), 0);
        EXPECT_EQ(snapshot_bytes(*parsed), bytes);
        EXPECT_EQ(parsed->job_blob, saved.job_blob);
        EXPECT_LE(bytes.size(), snapshot_bytes(full_snapshot()).size() + 1400 + profile.size());
    }
    EXPECT_EQ(parse_snapshot(snapshot_bytes(full_snapshot()), "s.psi")->source, nullptr);
}

TEST(SnapshotFile, OnlyOneWithASourceIsOfANewerVersion) {
    const auto version_of = [](const Snapshot& snapshot) {
        std::uint32_t version = 0;
        std::memcpy(&version, snapshot_bytes(snapshot).data() + offsetof(SnapshotHeader, version),
                    sizeof(version));
        return version;
    };
    EXPECT_EQ(version_of(full_snapshot()), 1U) << "an older psicarve reads it";
    EXPECT_EQ(version_of(snapshot_with_source("name")), 2U);
}

TEST(SnapshotFile, ASourceOfAnotherSizeIsRefused) {
    const Bytes bytes = snapshot_bytes(snapshot_with_source("name = \"lathe\""));
    for (const std::uint64_t size : {0U, 16U, 1312U, 1320U, 1336U, 60'000U}) {
        Bytes changed = bytes;
        const std::size_t end_of_job = snapshot_bytes(full_snapshot()).size();
        changed.resize(end_of_job + size);
        put(changed, offsetof(SnapshotHeader, total_bytes), std::uint64_t{changed.size()});
        EXPECT_THAT(refusal_of(changed), HasSubstr("damaged")) << size;
    }
    Bytes changed = bytes;
    const std::size_t profile_bytes = snapshot_bytes(full_snapshot()).size() +
                                      offsetof(RecordedSource, source) +
                                      offsetof(ProgramSource, profile_bytes);
    for (const std::uint32_t count : {0U, 100U, 48U * 1024U + 1U, 0xFFFF'FFFFU}) {
        put(changed, profile_bytes, count);
        EXPECT_THAT(refusal_of(changed), HasSubstr("the source of its program")) << count;
    }
}

TEST(SnapshotFile, JobFileIsASnapshotWithoutStatus) {
    const auto parsed = parse_snapshot(snapshot_bytes(job_only()), "job.psi");

    ASSERT_TRUE(parsed.has_value()) << parsed.error().message;
    EXPECT_FALSE(parsed->status.has_value());
    EXPECT_TRUE(parsed->records.empty());
    EXPECT_EQ(parsed->job_blob, test::make_job(5));
}

TEST(SnapshotFile, SameJobGivesTheSameBytesHoweverItIsWritten) {
    const test::TemporaryFolder folder;
    const Bytes bytes = snapshot_bytes(job_only());
    ASSERT_TRUE(save_snapshot(job_only(), folder.path("a.psi")).has_value());

    EXPECT_EQ(snapshot_bytes(job_only()), bytes);
    EXPECT_EQ(read_whole_file(folder.path("a.psi")).value(), bytes);
}

TEST(SnapshotFile, IsToldFromAModelByItsFirstBytes) {
    const Bytes bytes = snapshot_bytes(job_only());

    EXPECT_TRUE(looks_like_snapshot(bytes));
    EXPECT_FALSE(looks_like_snapshot(std::as_bytes(std::span{"solid figurine"})));
    EXPECT_FALSE(looks_like_snapshot({}));
}

TEST(SnapshotFile, EverySingleDamagedByteIsNoticed) {
    const Bytes bytes = snapshot_bytes(full_snapshot());
    for (std::size_t index = 0; index < bytes.size(); ++index) {
        Bytes damaged = bytes;
        damaged[index] ^= std::byte{0x10};
        ASSERT_FALSE(parse_snapshot(damaged, "job.psi").has_value()) << index;
    }
}

TEST(SnapshotFile, EveryTruncationIsRefused) {
    const Bytes bytes = snapshot_bytes(full_snapshot());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        Bytes cut = bytes;
        cut.resize(size);
        ASSERT_FALSE(parse_snapshot(cut, "job.psi").has_value()) << size;
    }
    Bytes cut = bytes;
    cut.pop_back();
    EXPECT_THAT(refusal_of(cut), HasSubstr("truncated"));
}

TEST(SnapshotFile, BytesBehindItsEndAreRefused) {
    Bytes bytes = snapshot_bytes(job_only());
    bytes.resize(bytes.size() + 3);

    EXPECT_THAT(refusal_of(bytes), HasSubstr("3 bytes too many"));
}

TEST(SnapshotFile, GarbageIsRefused) {
    EXPECT_THAT(refusal_of(Bytes(1000, std::byte{'x'})), HasSubstr("no psicarve job or snapshot file"));
    EXPECT_THAT(refusal_of({}), HasSubstr("no psicarve job or snapshot file"));
}

TEST(SnapshotFile, ForeignVersionIsRefusedByItsNumber) {
    Bytes bytes = snapshot_bytes(job_only());
    put(bytes, offsetof(SnapshotHeader, version), std::uint32_t{9});

    EXPECT_THAT(refusal_of(bytes), HasSubstr("file version 9"));
}

TEST(SnapshotFile, ForeignAbiIsRefused) {
    Bytes bytes = snapshot_bytes(job_only());
    put(bytes, offsetof(SnapshotHeader, abi_hash), snapshot_abi_hash(false) + 1);

    EXPECT_THAT(refusal_of(bytes), HasSubstr("another build"));
}

TEST(SnapshotFile, StatusOfAForeignLayoutIsRefusedButAJobOutlivesIt) {
    Bytes snapshot = snapshot_bytes(full_snapshot());
    put(snapshot, offsetof(SnapshotHeader, layout_version), kLayoutVersion + 1);
    Bytes job = snapshot_bytes(job_only());
    put(job, offsetof(SnapshotHeader, layout_version), kLayoutVersion + 1);

    EXPECT_THAT(refusal_of(snapshot), HasSubstr("layout version"));
    EXPECT_TRUE(parse_snapshot(job, "job.psi").has_value());
}

TEST(SnapshotFile, StatusOfAnOlderLayoutWithTheSameStructuresIsRead) {
    Bytes snapshot = snapshot_bytes(full_snapshot());
    put(snapshot, offsetof(SnapshotHeader, layout_version), kOldestStatusVersion);
    EXPECT_TRUE(parse_snapshot(snapshot, "s.psi").has_value());
    put(snapshot, offsetof(SnapshotHeader, layout_version), kOldestStatusVersion - 1);
    EXPECT_THAT(refusal_of(snapshot), HasSubstr("layout version"));
}

TEST(SnapshotFile, ADryRunOfAnOlderLayoutIsOneWithoutAForecast) {
    Bytes snapshot = snapshot_bytes(full_snapshot());
    put(snapshot, offsetof(SnapshotHeader, layout_version), std::uint32_t{9});
    put(snapshot, sizeof(SnapshotHeader) + offsetof(CoreStatus, is_dry), std::uint16_t{1});
    const auto parsed = parse_snapshot(snapshot, "s.psi");
    ASSERT_TRUE(parsed.has_value()) << parsed.error().message;
    EXPECT_EQ(parsed->status->is_dry, 1U);
    EXPECT_EQ(parsed->status->is_left_forecast, 0U);
    EXPECT_EQ(parsed->status->is_port_silent, 0U);
}

TEST(SnapshotFile, KeepsTheCheckpointAndNoImpossibleOne) {
    Snapshot saved = full_snapshot();
    EXPECT_FALSE(parse_snapshot(snapshot_bytes(saved), "s.psi")->checkpoint.has_value());
    saved.checkpoint = checkpoint_at(77, 3, 10);
    Bytes bytes = snapshot_bytes(saved);
    const auto parsed = parse_snapshot(bytes, "s.psi");
    ASSERT_TRUE(parsed.has_value());
    ASSERT_TRUE(parsed->checkpoint.has_value());
    EXPECT_EQ(parsed->checkpoint->job_checksum, 77U);
    EXPECT_EQ(parsed->checkpoint->next_layer, 3U);
    EXPECT_EQ(parsed->checkpoint->layer_count, 10U);
    put(bytes, offsetof(SnapshotHeader, checkpoint_next_layer), std::uint32_t{11});
    EXPECT_THAT(refusal_of(bytes), HasSubstr("checkpoint"));
}

TEST(SnapshotFile, SizesAndOffsetsThatCannotBeAreRefusedEvenWithARightChecksum) {
    const Bytes bytes = snapshot_bytes(full_snapshot());
    for (std::size_t offset = offsetof(SnapshotHeader, status_offset);
         offset <= offsetof(SnapshotHeader, job_bytes); offset += 8) {
        for (const std::uint64_t value : {std::uint64_t{1}, std::uint64_t{1} << 63, ~std::uint64_t{0},
                                          ~std::uint64_t{0} - 63, std::uint64_t{bytes.size()}}) {
            Bytes damaged = bytes;
            put(damaged, offset, value);
            ASSERT_FALSE(parse_snapshot(damaged, "job.psi").has_value()) << offset << " " << value;
        }
    }
}

TEST(SnapshotFile, ARecorderOfNoWholeNumberOfRecordsIsRefused) {
    const Bytes whole = snapshot_bytes(full_snapshot());
    SnapshotHeader header{};
    std::memcpy(&header, whole.data(), sizeof(header));
    Bytes bytes = whole;
    const auto behind = static_cast<std::ptrdiff_t>(header.recorder_offset + header.recorder_bytes);
    bytes.insert(bytes.begin() + behind, 8, std::byte{0});
    put(bytes, offsetof(SnapshotHeader, recorder_bytes), header.recorder_bytes + 8);
    put(bytes, offsetof(SnapshotHeader, job_offset), header.job_offset + 8);
    put(bytes, offsetof(SnapshotHeader, total_bytes), header.total_bytes + 8);

    EXPECT_THAT(refusal_of(bytes), HasSubstr("damaged: sizes and offsets"));
}

TEST(SnapshotFile, JobInsideIsCheckedToo) {
    Bytes bytes = snapshot_bytes(job_only());
    put(bytes, sizeof(SnapshotHeader) + offsetof(JobHeader, layer_count), std::uint32_t{5});

    EXPECT_THAT(refusal_of(bytes), HasSubstr("job"));
}

TEST(SnapshotFile, SnapshotMayHoldNoJobButAJobFileMust) {
    Snapshot snapshot = full_snapshot();
    snapshot.job_blob.clear();
    EXPECT_TRUE(parse_snapshot(snapshot_bytes(snapshot), "s.psi").has_value());

    EXPECT_THAT(refusal_of(snapshot_bytes(Snapshot{})), HasSubstr("holds no job"));
}

TEST(SnapshotFile, LoadingNamesTheFileAndTheCause) {
    const test::TemporaryFolder folder;

    EXPECT_THAT(load_snapshot(folder.path("none.psi")).error().message,
                HasSubstr("none.psi: cannot be read: No such"));
    EXPECT_THAT(load_snapshot(folder.path("")).error().message, HasSubstr("is a folder"));
    EXPECT_THAT(load_snapshot("/dev/zero").error().message, HasSubstr("no regular file"));
}

mode_t rights_of_file(const std::string& path) {
    struct stat facts {};
    EXPECT_EQ(::stat(path.c_str(), &facts), 0);
    return facts.st_mode & 0777;
}

TEST(SnapshotFile, IsForItsOwnerAloneOrForTheGroupThatIsNamed) {
    const test::TemporaryFolder folder;
    const std::string path = folder.path("a.snap");
    std::ofstream{path} << "readable by all";
    ASSERT_EQ(::chmod(path.c_str(), 0644), 0);
    ASSERT_TRUE(save_snapshot(full_snapshot(), path));
    EXPECT_EQ(rights_of_file(path), 0600U);
    const std::string group = ::getgrgid(::getegid())->gr_name;
    ASSERT_TRUE(save_snapshot(full_snapshot(), path, group));
    EXPECT_EQ(rights_of_file(path), 0660U);
    EXPECT_FALSE(save_snapshot(full_snapshot(), path, "no-such-group-here"));
    // A job is made to be passed on.
    ASSERT_TRUE(save_snapshot(job_only(), folder.path("a.job")));
    const mode_t mask = ::umask(0);
    ::umask(mask);
    EXPECT_EQ(rights_of_file(folder.path("a.job")), 0666U & ~mask);
}

}  // namespace
}  // namespace psicarve
