// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings and pictures that are none, or no more: one line for each, by every command that takes models.
#include <linux/capability.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/hmi/cli/refusal.hpp"
#include "tests/places.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::test {
namespace {

const std::string kGoodSvg =
    "<svg xmlns='http://www.w3.org/2000/svg' width='20mm' height='20mm' viewBox='0 0 20 20'>"
    "<path d='M2,2 h16 v16 h-16 z'/></svg>\n";
const std::string kGoodDxf =
    "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\n0\n10\n5\n"
    "20\n5\n40\n7\n0\nENDSEC\n0\nEOF\n";

std::string svg_of(const std::string& inside) {
    return "<svg xmlns='http://www.w3.org/2000/svg' width='20mm' height='20mm'>" + inside + "</svg>\n";
}
std::string dxf_of(const std::string& entity) {
    return "0\nSECTION\n2\nENTITIES\n" + entity + "0\nENDSEC\n0\nEOF\n";
}

std::string bytes_of(std::uint32_t value, unsigned count, bool is_big) {
    std::string out;
    for (unsigned i = 0; i < count; ++i) out += static_cast<char>(value >> 8U * (is_big ? count - 1 - i : i));
    return out;
}

/// The sum of a PNG's chunk (CRC-32).
std::uint32_t chunk_sum(const std::string& bytes) {
    std::uint32_t sum = 0xFFFF'FFFF;
    for (const char c : bytes) {
        sum ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? 0xEDB8'8320 : 0);
    }
    return ~sum;
}

struct Size {
    std::uint32_t width;
    std::uint32_t height;
};

// A good picture whose head says another size.
std::string png_of(std::string good, Size size) {
    good.replace(16, 8, bytes_of(size.width, 4, true) + bytes_of(size.height, 4, true));
    return good.replace(29, 4, bytes_of(chunk_sum(good.substr(12, 17)), 4, true));
}
std::string jpeg_of(std::string good, Size size) {
    const std::size_t frame = good.find("\xff\xc0");
    return good.replace(frame + 5, 4, bytes_of(size.height, 2, true) + bytes_of(size.width, 2, true));
}
std::string tiff_of(std::string good, Size size) {
    const auto two = [&good](std::size_t at) {
        return static_cast<std::size_t>(static_cast<unsigned char>(good[at])) |
               static_cast<std::size_t>(static_cast<unsigned char>(good[at + 1])) << 8U;
    };
    const std::size_t directory = two(4);  // little end first, and short
    for (std::size_t entry = directory + 2; entry < directory + 2 + 12 * two(directory); entry += 12) {
        if (two(entry) != 256 && two(entry) != 257) continue;
        good.replace(entry + 2, 10,
                     bytes_of(4, 2, false) + bytes_of(1, 4, false) +
                         bytes_of(two(entry) == 256 ? size.width : size.height, 4, false));
    }
    return good;
}
std::string bmp_of(std::string good, Size size) {
    return good.replace(18, 8, bytes_of(size.width, 4, false) + bytes_of(size.height, 4, false));
}
/// Negative where it would be.
std::string pgm_of(std::string good, Size size) {
    const auto number = [](std::uint32_t side) { return std::to_string(static_cast<std::int32_t>(side)); };
    return "P5 " + number(size.width) + " " + number(size.height) + good.substr(good.find(" 255"));
}

struct Kind {
    std::string ending;
    std::string seed;
    std::string (*sized)(std::string, Size);

    std::string good() const {
        std::ifstream in{in_source("tests/fuzz/corpus/picture/") + seed, std::ios::binary};
        return {std::istreambuf_iterator<char>(in), {}};
    }
};
const std::vector<Kind> kPictures{{"png", "grey16.png", png_of},
                                  {"jpg", "grey.jpg", jpeg_of},
                                  {"tif", "grey16.tif", tiff_of},
                                  {"bmp", "colour.bmp", bmp_of},
                                  {"pgm", "binary.pgm", pgm_of}};

class BrokenFlatInput : public RefusalTest {
protected:
    static std::vector<std::pair<std::string, std::string>> good_files() {
        std::vector<std::pair<std::string, std::string>> files{{"svg", kGoodSvg}, {"dxf", kGoodDxf}};
        for (const Kind& kind : kPictures) files.emplace_back(kind.ending, kind.good());
        return files;
    }
    /// What the commands have in common asks each reader once; a sanitizer sees no more in every pair.
    static bool is_shown_to_all(const std::string& ending) {
        return is_thorough() || ending == "svg" || ending == "png";
    }
    std::vector<std::string> sliced(const std::string& name) const {
        return {"slice", file(name), "-o", file("out.job"), "--layers", "2", "--points", "5"};
    }
    void expect_refused_by_slice(const std::string& name, const std::string& bytes) const {
        write(name, bytes);
        expect_refused(sliced(name), name);
    }
    void expect_refused_by_all(const std::string& name) const {
        expect_refused(sliced(name), name);
        expect_refused({"carve", file(name), "--segment", segment_, "--picture", file("out.png")}, name);
        expect_refused({"publish", file(name), "--segment", segment_}, name);
        expect_refused({"inspect", file(name)}, name);
        expect_refused({"estimate", file(name)}, name);
        const auto before = files_in_folder();
        const Outcome as_json = psicarve({"inspect", file(name), "--json"});
        EXPECT_EQ(as_json.exit_code, 3) << as_json.error;
        EXPECT_EQ(as_json.error_lines(), 1U) << as_json.error;
        EXPECT_EQ(as_json.json()["error"]["code"], "bad_input");
        EXPECT_EQ("psicarve: " + as_json.json()["error"]["message"].get<std::string>() + "\n", as_json.error);
        EXPECT_EQ(files_in_folder(), before) << name;
        EXPECT_FALSE(Segment::attach(segment_).has_value());
    }
};

TEST_F(BrokenFlatInput, WhatIsGoodIsTakenWhateverItsName) {
    for (const auto& [ending, bytes] : good_files()) {
        for (const std::string& name : std::vector<std::string>{"good." + ending, "good.stl", "good.xyz",
                                                                "good", "good.svg", "good.png"}) {
            write(name, bytes);
            const Outcome outcome = psicarve(sliced(name));
            EXPECT_EQ(outcome.exit_code, 0) << ending << " as " << name << ": " << outcome.error;
        }
    }
}

TEST_F(BrokenFlatInput, EmptyOnesAndThoseOfWordsAreRefusedByEveryCommand) {
    for (const auto& [ending, good] : good_files()) {
        write("empty." + ending, "");
        if (is_shown_to_all(ending)) {
            expect_refused_by_all("empty." + ending);
        } else {
            expect_refused(sliced("empty." + ending), "empty." + ending);
        }
        write("words." + ending, "this is a letter to my aunt, neither a drawing nor a picture\n");
        if (is_shown_to_all(ending)) {
            expect_refused_by_all("words." + ending);
        } else {
            expect_refused(sliced("words." + ending), "words." + ending);
        }
    }
}

TEST_F(BrokenFlatInput, ThoseCutShortAreRefused) {
    for (const auto& [ending, good] : good_files()) {
        const std::size_t size = good.size();
        for (const std::size_t kept :
             {std::size_t{1}, std::size_t{4}, std::size_t{11}, size / 4, size / 2, size * 3 / 4, size - 6}) {
            if (ending == "pgm" && kept > 10) continue;  // fifteen bytes, and the cut below
            expect_refused_by_slice("cut" + std::to_string(kept) + "." + ending, good.substr(0, kept));
        }
    }
    expect_refused_by_slice("last.pgm", kPictures[4].good().substr(0, 14));
    write("half.png", kPictures[0].good().substr(0, 40));
    expect_refused_by_all("half.png");
    write("half.dxf", kGoodDxf.substr(0, 60));
    expect_refused_by_all("half.dxf");
}

TEST_F(BrokenFlatInput, PicturesOfSizesThatAreNoneAreRefused) {
    constexpr std::uint32_t kMinus = static_cast<std::uint32_t>(-3);
    constexpr std::uint32_t kLeast = 0x8000'0000;
    const std::vector<Size> wrong{{0, 2},           {2, 0},           {0, 0},           {65535, 65535},
                                  {1'000'000, 100}, {65535, 60},      {kMinus, 2},      {2, kLeast},
                                  {kMinus, kMinus}, {kLeast, kLeast}, {2, 0x7FFF'FFFF}, {0x7FFF'FFFF, 2}};
    for (const Kind& kind : kPictures) {
        const std::string good = kind.good();
        ASSERT_GT(good.size(), 14U) << kind.seed;
        int count = 0;
        for (const Size& size : wrong) {
            // Two bytes of a JPEG's are all of its size.
            if (kind.ending == "jpg" && (size.width > 65535 || size.height > 65535)) continue;
            expect_refused_by_slice("size" + std::to_string(++count) + "." + kind.ending,
                                    kind.sized(good, size));
        }
    }
}

TEST_F(BrokenFlatInput, DrawingsOfLengthsThatAreNoneAreRefused) {
    int count = 0;
    for (const std::string inside :
         {"<rect width='0' height='5'/>", "<rect width='-4' height='5'/>", "<circle r='-4'/>",
          "<circle r='nan'/>", "<circle r='1e400'/>",
          "<path d='M0 0 H1e308 V1e308 z' transform='scale(1e9)'/>",
          "<path d='M0 0 H9 V9'  fill='none' stroke='red'/>", "<path d='M0 0 H9 z'/>", "", "<text>a</text>",
          "<rect width='9' height='9'/", "<g><g></svg>"}) {
        expect_refused_by_slice("d" + std::to_string(++count) + ".svg", svg_of(inside));
    }
    expect_refused_by_slice("zero.svg",
                            "<svg width='0' height='0' viewBox='0 0 0 0'><rect width='9' height='9'/></svg>");
    expect_refused_by_slice("minus.svg",
                            "<svg width='-9mm' height='-9mm' viewBox='0 0 -5 -5'><circle r='-9'/></svg>");
    for (const std::string entity :
         {"0\nCIRCLE\n8\n0\n10\n5\n20\n5\n40\n0\n", "0\nCIRCLE\n8\n0\n10\n5\n20\n5\n40\n-7\n",
          "0\nCIRCLE\n8\n0\n10\n5\n20\n5\n40\n1e400\n", "0\nCIRCLE\n8\n0\n10\n1e308\n20\n1e308\n40\n1e308\n",
          "0\nCIRCLE\n8\n0\n10\nfive\n20\n5\n40\n7\n", "0\nCIRCLE\n8\n0\n10\n5\n20\n5\n40\nnan\n",
          "0\nLINE\n8\n0\n10\n0\n20\n0\n11\n9\n21\n0\n", "0\nLWPOLYLINE\n90\n-1\n70\n1\n",
          "0\nTEXT\n1\nhello\n", "0\nINSERT\n2\nnothing\n10\n0\n20\n0\n", "ten\nCIRCLE\n", ""}) {
        expect_refused_by_slice("d" + std::to_string(++count) + ".dxf", dxf_of(entity));
    }
}

TEST_F(BrokenFlatInput, WhatOtherProgramsSaveUnderTheseNamesIsRefused) {
    const std::string mesh = text_of(box_stl("box.stl"));
    for (const auto& [ending, good] : good_files()) {
        expect_refused_by_slice("mesh." + ending, mesh);
        expect_refused_by_slice("page." + ending, "<!DOCTYPE html><html><body>not found</body></html>\n");
        expect_refused_by_slice("zip." + ending, std::string("PK\3\4\24\0\0\0", 8));
        expect_refused_by_slice("zeros." + ending, std::string(3000, '\0'));
    }
}

TEST_F(BrokenFlatInput, FoldersOfSuchNamesAreRefusedByEveryCommand) {
    for (const auto& [ending, good] : good_files()) {
        std::filesystem::create_directory(file("folder." + ending));
        expect_refused_by_all("folder." + ending);
    }
}

TEST_F(BrokenFlatInput, WhatMayNotBeReadIsRefused) {
    for (const auto& [ending, good] : good_files()) {
        const std::string name = "locked." + ending;
        write(name, good);
        std::filesystem::permissions(file(name), std::filesystem::perms::none);
        // Root may read everything; a thread without these two rights, and what it starts, may not.
        std::thread{[this, name] {
            prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE);
            prctl(PR_CAPBSET_DROP, CAP_DAC_READ_SEARCH);
            const Outcome outcome = psicarve(sliced(name));
            expect_refusal(outcome, name);
            EXPECT_NE(outcome.error.find("cannot be opened: Permission denied"), std::string::npos)
                << outcome.error;
        }}.join();
    }
}

}  // namespace
}  // namespace psicarve::test
